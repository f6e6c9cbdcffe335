// SPDX-License-Identifier: MIT
// Draws Dear ImGui's draw lists through a table of OpenGL functions.
#include "render/imgui_renderer.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "math/whole.hpp"
#include "shaders.hpp"

namespace vides {

static_assert(sizeof(ImDrawIdx) == 2 || sizeof(ImDrawIdx) == 4);
constexpr GLenum kIndexType = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;

constexpr GLenum kClipPlanes = 4;  // in the vertex shader

struct ImguiRenderer::Target {
  int width;   // pixels
  int height;  // pixels
  std::array<float, 16> projection;
};

namespace {

// ImGui's coordinates (y down) to clip space, column by column.
std::array<float, 16> projectionOf(const ImDrawData& data) {
  const float left = data.DisplayPos.x;
  const float top = data.DisplayPos.y;
  const float width = data.DisplaySize.x;
  const float height = data.DisplaySize.y;
  return {2.0f / width,
          0,
          0,
          0,
          0,
          -2.0f / height,
          0,
          0,
          0,
          0,
          -1,
          0,
          -1.0f - 2.0f * left / width,
          1.0f + 2.0f * top / height,
          0,
          1};
}

// A clip rectangle in pixels from the lower left corner, cut to the target.
struct Scissor {
  GLint x = 0, y = 0;
  GLsizei width = 0, height = 0;
};
Scissor scissorOf(const ImVec4& clip, const ImDrawData& data, int width, int height) {
  const auto pixel = [](float value, float origin, float scale, int limit) {
    const float pixels = std::round((value - origin) * scale);
    return static_cast<int>(wholeWithin(static_cast<double>(pixels), 0, limit));
  };
  const ImVec2 origin = data.DisplayPos;
  const ImVec2 scale = data.FramebufferScale;
  const int left = pixel(clip.x, origin.x, scale.x, width);
  const int top = pixel(clip.y, origin.y, scale.y, height);
  const int right = pixel(clip.z, origin.x, scale.x, width);
  const int bottom = pixel(clip.w, origin.y, scale.y, height);
  return {left, height - bottom, std::max(0, right - left), std::max(0, bottom - top)};
}

template <typename T>
std::span<const std::byte> bytesOf(const ImVector<T>& values) {
  return {reinterpret_cast<const std::byte*>(values.Data),
          static_cast<std::size_t>(values.Size) * sizeof(T)};
}

const void* bufferOffset(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

void describeVertices(const Gl& gl) {
  constexpr auto kStride = static_cast<GLsizei>(sizeof(ImDrawVert));
  gl.EnableVertexAttribArray(0);
  gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, kStride,
                         bufferOffset(offsetof(ImDrawVert, pos)));
  gl.EnableVertexAttribArray(1);
  gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, kStride, bufferOffset(offsetof(ImDrawVert, uv)));
  gl.EnableVertexAttribArray(2);
  gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                         bufferOffset(offsetof(ImDrawVert, col)));
}

}  // namespace

void* imguiTexture(GLuint texture) {
  return reinterpret_cast<void*>(static_cast<std::uintptr_t>(texture));
}

tl::expected<ImguiRenderer, std::string> ImguiRenderer::create(const Gl& gl) {
  ImguiRenderer renderer;
  renderer.gl_ = &gl;
  auto program = ShaderProgram::build(gl, "imgui", shaders::kImguiVert, shaders::kImguiFrag);
  if (!program) return Failure(program.error());
  renderer.program_ = std::move(*program);
  renderer.projection_ = renderer.program_.uniform("projection");
  renderer.texture_ = renderer.program_.uniform("picture");
  renderer.clip_ = renderer.program_.uniform("clip");
  renderer.vertexArray_ = VertexArray(gl);
  renderer.vertices_ = Buffer(gl, GL_ARRAY_BUFFER);
  renderer.indices_ = Buffer(gl, GL_ELEMENT_ARRAY_BUFFER);
  gl.BindVertexArray(renderer.vertexArray_.id());
  renderer.vertices_.bind();
  renderer.indices_.bind();
  describeVertices(gl);
  gl.BindVertexArray(0);
  return renderer;
}

void ImguiRenderer::announce(ImGuiIO& io) {
  io.BackendRendererName = "vides";
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
}

tl::expected<void, std::string> ImguiRenderer::uploadFonts(ImFontAtlas& atlas) {
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  if (!atlas.IsBuilt()) atlas.Build();
  const bool colours = atlas.TexPixelsUseColors;
  colours ? atlas.GetTexDataAsRGBA32(&pixels, &width, &height)
          : atlas.GetTexDataAsAlpha8(&pixels, &width, &height);
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  auto texture = Texture::create(*gl_, width, height, {pixels, colours ? 4 * count : count},
                                 TextureFilter::kLinear,
                                 colours ? TextureKind::kColour : TextureKind::kCoverage);
  if (!texture) return Failure("fonts: " + texture.error());
  fonts_ = std::move(*texture);
  atlas.SetTexID(imguiTexture(fonts_.id()));
  return {};
}

void ImguiRenderer::setUp(const Target& target) {
  const Gl& gl = *gl_;
  gl.Viewport(0, 0, target.width, target.height);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.Disable(GL_CULL_FACE);
  gl.Disable(GL_DEPTH_TEST);
  gl.Disable(GL_STENCIL_TEST);
  gl.Disable(GL_PRIMITIVE_RESTART);
  gl.Enable(GL_SCISSOR_TEST);
  for (GLenum i = 0; i < kClipPlanes; ++i) gl.Enable(GL_CLIP_DISTANCE0 + i);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  program_.use();
  gl.UniformMatrix4fv(projection_, 1, GL_FALSE, target.projection.data());
  gl.Uniform1i(texture_, 0);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindSampler(0, 0);
  gl.BindVertexArray(vertexArray_.id());
  vertices_.bind();
}

void ImguiRenderer::drawList(const ImDrawList& list, const ImDrawData& data, const Target& target) {
  const Gl& gl = *gl_;
  vertices_.upload(bytesOf(list.VtxBuffer), GL_STREAM_DRAW);
  indices_.upload(bytesOf(list.IdxBuffer), GL_STREAM_DRAW);
  for (const ImDrawCmd& command : list.CmdBuffer) {
    if (command.UserCallback == ImDrawCallback_ResetRenderState) {
      setUp(target);
      continue;
    }
    if (command.UserCallback != nullptr) {
      command.UserCallback(&list, &command);
      continue;
    }
    const Scissor scissor = scissorOf(command.ClipRect, data, target.width, target.height);
    if (scissor.width == 0 || scissor.height == 0) continue;
    gl.Scissor(scissor.x, scissor.y, scissor.width, scissor.height);
    const auto clipSpace = [](int pixels, int limit) {
      return 2.0f * static_cast<float>(pixels) / static_cast<float>(limit) - 1.0f;
    };
    gl.Uniform4f(clip_, clipSpace(scissor.x, target.width), clipSpace(scissor.y, target.height),
                 clipSpace(scissor.x + scissor.width, target.width),
                 clipSpace(scissor.y + scissor.height, target.height));
    gl.BindTexture(GL_TEXTURE_2D,
                   static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(command.GetTexID())));
    gl.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), kIndexType,
                              bufferOffset(command.IdxOffset * sizeof(ImDrawIdx)),
                              static_cast<GLint>(command.VtxOffset));
  }
}

void ImguiRenderer::draw(const ImDrawData& data) {
  const Target target{static_cast<int>(std::lround(data.DisplaySize.x * data.FramebufferScale.x)),
                      static_cast<int>(std::lround(data.DisplaySize.y * data.FramebufferScale.y)),
                      projectionOf(data)};
  if (target.width < 1 || target.height < 1) return;
  setUp(target);
  for (int i = 0; i < data.CmdListsCount; ++i) drawList(*data.CmdLists[i], data, target);
  for (GLenum i = 0; i < kClipPlanes; ++i) gl_->Disable(GL_CLIP_DISTANCE0 + i);
  gl_->Disable(GL_SCISSOR_TEST);
  gl_->Disable(GL_BLEND);
  gl_->BindVertexArray(0);
  gl_->UseProgram(0);
}

}  // namespace vides
