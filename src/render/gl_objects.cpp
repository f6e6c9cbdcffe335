// SPDX-License-Identifier: MIT
// OpenGL objects that free themselves.
#include "render/gl_objects.hpp"

#include <fmt/format.h>

#include <cassert>

namespace vides {
namespace {

// A shader object until the program holds it.
class Shader {
 public:
  Shader(const Gl& gl, GLenum kind) : gl_(gl), id_(gl.CreateShader(kind)) {}
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  ~Shader() { gl_.DeleteShader(id_); }

  // Empty, or the driver's log.
  std::string compile(std::string_view source) const {
    const GLchar* text = source.data();
    const auto length = static_cast<GLint>(source.size());
    gl_.ShaderSource(id_, 1, &text, &length);
    gl_.CompileShader(id_);
    GLint compiled = GL_FALSE;
    gl_.GetShaderiv(id_, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return {};
    GLchar log[1024] = "";
    gl_.GetShaderInfoLog(id_, sizeof log, nullptr, log);
    return log[0] == '\0' ? "no reason given" : log;
  }
  GLuint id() const { return id_; }

 private:
  const Gl& gl_;
  GLuint id_;
};

[[maybe_unused]] std::size_t bytesOf(int width, int height, TextureKind kind) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
         (kind == TextureKind::kCoverage ? 1 : 4);
}

}  // namespace

void Buffer::upload(std::span<const std::byte> bytes, GLenum usage) {
  bind();
  handle_.gl().BufferData(target_, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), usage);
  size_ = bytes.size();
}

void Buffer::reserve(std::size_t size, GLenum usage) {
  bind();
  handle_.gl().BufferData(target_, static_cast<GLsizeiptr>(size), nullptr, usage);
  size_ = size;
}

void Buffer::update(std::size_t offset, std::span<const std::byte> bytes) {
  assert(offset <= size_ && bytes.size() <= size_ - offset);
  bind();
  handle_.gl().BufferSubData(target_, static_cast<GLintptr>(offset),
                             static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

tl::expected<Texture, std::string> Texture::create(const Gl& gl, int width, int height,
                                                   std::span<const std::uint8_t> pixels,
                                                   TextureFilter filter, TextureKind kind) {
  const int limit = gl.limits.maxTextureSize;
  if (width < 1 || height < 1 || width > limit || height > limit) {
    return Failure(fmt::format(
        "a texture of {} × {} pixels cannot be made: this OpenGL allows 1 to {} along a side",
        width, height, limit));
  }
  Texture texture;
  texture.handle_ = TextureHandle(gl);
  texture.kind_ = kind;
  texture.width_ = width;
  texture.height_ = height;
  assert(pixels.empty() || pixels.size() == bytesOf(width, height, kind));
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  const GLint scaling = filter == TextureFilter::kLinear ? GL_LINEAR : GL_NEAREST;
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, scaling);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, scaling);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  const bool coverage = kind == TextureKind::kCoverage;
  if (coverage) {
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_R, GL_ONE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_G, GL_ONE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_B, GL_ONE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_A, GL_RED);
  }
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  gl.TexImage2D(GL_TEXTURE_2D, 0, coverage ? GL_R8 : GL_RGBA8, width, height, 0,
                coverage ? GL_RED : GL_RGBA, GL_UNSIGNED_BYTE,
                pixels.empty() ? nullptr : pixels.data());
  if (const auto ok = checkGl(gl, "texture"); !ok) return Failure(ok.error());
  return texture;
}

void Texture::update(std::span<const std::uint8_t> pixels) {
  assert(pixels.size() == bytesOf(width_, height_, kind_));
  const Gl& gl = handle_.gl();
  gl.BindTexture(GL_TEXTURE_2D, id());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_,
                   kind_ == TextureKind::kCoverage ? GL_RED : GL_RGBA, GL_UNSIGNED_BYTE,
                   pixels.data());
}

tl::expected<ShaderProgram, std::string> ShaderProgram::build(const Gl& gl, std::string_view name,
                                                              std::string_view vertexSource,
                                                              std::string_view fragmentSource) {
  const Shader vertex(gl, GL_VERTEX_SHADER);
  const Shader fragment(gl, GL_FRAGMENT_SHADER);
  if (const std::string log = vertex.compile(vertexSource); !log.empty()) {
    return Failure(fmt::format("shader {}, vertices: {}", name, log));
  }
  if (const std::string log = fragment.compile(fragmentSource); !log.empty()) {
    return Failure(fmt::format("shader {}, fragments: {}", name, log));
  }
  ShaderProgram program(gl, gl.CreateProgram());
  gl.AttachShader(program.id(), vertex.id());
  gl.AttachShader(program.id(), fragment.id());
  gl.LinkProgram(program.id());
  gl.DetachShader(program.id(), vertex.id());
  gl.DetachShader(program.id(), fragment.id());
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program.id(), GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    GLchar log[1024] = "";
    gl.GetProgramInfoLog(program.id(), sizeof log, nullptr, log);
    return Failure(fmt::format("shader {}: {}", name, log));
  }
  return program;
}

GLint ShaderProgram::uniform(const char* name) const {
  const GLint place = gl_->GetUniformLocation(id_, name);
  assert(place >= 0);
  return place;
}

}  // namespace vides
