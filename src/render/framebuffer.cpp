// SPDX-License-Identifier: MIT
// Somewhere to draw that is no window.
#include "render/framebuffer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace vides {
namespace {

// With four samples such a picture takes 2.4 GB; software OpenGL does not refuse more, it thrashes.
constexpr std::int64_t kMaxPixels = std::int64_t{1} << 26;

tl::expected<void, std::string> checkSize(const Gl& gl, int width, int height) {
  if (width < 1 || height < 1) {
    return Failure(fmt::format("a picture of {} × {} pixels cannot be drawn", width, height));
  }
  if (width > gl.limits.maxWidth || height > gl.limits.maxHeight) {
    return Failure(fmt::format(
        "a picture of {} × {} pixels cannot be drawn: this OpenGL draws at most {} × {}", width,
        height, gl.limits.maxWidth, gl.limits.maxHeight));
  }
  if (std::int64_t{width} * height > kMaxPixels) {
    return Failure(
        fmt::format("a picture of {} × {} pixels cannot be drawn: more than {} million pixels",
                    width, height, kMaxPixels / 1'000'000));
  }
  return {};
}

RenderbufferHandle makeRenderbuffer(const Gl& gl, GLenum format, int width, int height,
                                    int samples) {
  RenderbufferHandle handle(gl);
  gl.BindRenderbuffer(GL_RENDERBUFFER, handle.id());
  if (samples > 0) {
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  } else {
    gl.RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  }
  return handle;
}

tl::expected<void, std::string> checkComplete(const Gl& gl, int width, int height) {
  const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return {};
  return Failure(
      fmt::format("a picture of {} × {} pixels cannot be drawn: OpenGL refuses it (0x{:x})", width,
                  height, status));
}

}  // namespace

tl::expected<Framebuffer, std::string> Framebuffer::create(const Gl& gl, int width, int height,
                                                           int samples) {
  if (const auto ok = checkSize(gl, width, height); !ok) return Failure(ok.error());
  Framebuffer result;
  result.samples_ = samples < 2 ? 0 : std::min(samples, gl.limits.maxSamples);
  auto texture = Texture::create(gl, width, height, {}, TextureFilter::kLinear);
  if (!texture) return Failure(texture.error());
  result.texture_ = std::move(*texture);
  result.depth_ = makeRenderbuffer(gl, GL_DEPTH24_STENCIL8, width, height, result.samples_);
  result.draw_ = FramebufferHandle(gl);
  if (result.samples_ > 0) {
    result.colour_ = makeRenderbuffer(gl, GL_RGBA8, width, height, result.samples_);
    result.resolve_ = FramebufferHandle(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, result.resolve_.id());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                            result.texture_.id(), 0);
    if (const auto ok = checkComplete(gl, width, height); !ok) return Failure(ok.error());
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, result.draw_.id());
  if (result.samples_ > 0) {
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                               result.colour_.id());
  } else {
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                            result.texture_.id(), 0);
  }
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                             result.depth_.id());
  if (const auto ok = checkGl(gl, "framebuffer"); !ok) return Failure(ok.error());
  if (const auto ok = checkComplete(gl, width, height); !ok) return Failure(ok.error());
  return result;
}

void Framebuffer::bind() const {
  const Gl& gl = draw_.gl();
  gl.BindFramebuffer(GL_FRAMEBUFFER, draw_.id());
  gl.Viewport(0, 0, width(), height());
}

void Framebuffer::resolve() {
  if (samples_ == 0) return;
  const Gl& gl = draw_.gl();
  gl.Disable(GL_SCISSOR_TEST);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, draw_.id());
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolve_.id());
  gl.BlitFramebuffer(0, 0, width(), height(), 0, 0, width(), height(), GL_COLOR_BUFFER_BIT,
                     GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, draw_.id());
}

tl::expected<Picture, std::string> Framebuffer::read() const {
  const Gl& gl = draw_.gl();
  Picture picture(width(), height());
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, samples_ > 0 ? resolve_.id() : draw_.id());
  gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.PixelStorei(GL_PACK_ROW_LENGTH, 0);
  gl.ReadPixels(0, 0, width(), height(), GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, draw_.id());
  if (const auto ok = checkGl(gl, "reading the picture"); !ok) return Failure(ok.error());

  // OpenGL's row 0 is the bottom one.
  const std::size_t row = static_cast<std::size_t>(width()) * 4;
  for (int top = 0, bottom = height() - 1; top < bottom; ++top, --bottom) {
    std::swap_ranges(picture.rgba.begin() + static_cast<std::ptrdiff_t>(row) * top,
                     picture.rgba.begin() + static_cast<std::ptrdiff_t>(row) * (top + 1),
                     picture.rgba.begin() + static_cast<std::ptrdiff_t>(row) * bottom);
  }
  return picture;
}

}  // namespace vides
