// SPDX-License-Identifier: MIT
// Draws Dear ImGui's draw lists through a table of OpenGL functions.
//
// A texture is an ImTextureID made from an OpenGL texture's id by imguiTexture(); any number may be
// used. Colours are plain sRGB bytes and blend as such: no conversion anywhere, the same picture in
// a window and without one. Needs an ImGui context only where it says so, so that several editors
// can share a process.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "render/failure.hpp"
#include "render/gl_functions.hpp"
#include "render/gl_objects.hpp"

struct ImDrawData;
struct ImDrawList;
struct ImFontAtlas;
struct ImGuiIO;

namespace vides {

// How to hand an OpenGL texture to ImGui::Image (ImTextureID is void*).
void* imguiTexture(GLuint texture);

class ImguiRenderer {
 public:
  // Error: the shader does not build.
  static tl::expected<ImguiRenderer, std::string> create(const Gl& gl);

  // Tells an ImGui context what this renderer can do (vertex offsets, so that a window may have
  // more than 65,536 vertices). Once per context.
  static void announce(ImGuiIO& io);

  // Builds the atlas where it isn't built, uploads its picture and sets its texture id. Call it
  // once before the first NewFrame and after each change of the fonts, between frames. Error: the
  // atlas is larger than a texture may be.
  tl::expected<void, std::string> uploadFonts(ImFontAtlas& atlas);

  // Draws into the framebuffer that is bound; its viewport must be the whole of it, of
  // DisplaySize · FramebufferScale pixels. Sets the state it needs and leaves blending, scissor,
  // depth and stencil tests, clip planes and face culling off, no program and no vertex array
  // bound. User callbacks in the lists are called; ImDrawCallback_ResetRenderState restores the
  // state.
  void draw(const ImDrawData& data);

 private:
  ImguiRenderer() = default;
  struct Target;  // where the lists go, in pixels

  void setUp(const Target& target);
  void drawList(const ImDrawList& list, const ImDrawData& data, const Target& target);

  const Gl* gl_ = nullptr;
  ShaderProgram program_;
  GLint projection_ = -1;
  GLint texture_ = -1;
  GLint clip_ = -1;
  VertexArray vertexArray_;
  Buffer vertices_;
  Buffer indices_;
  Texture fonts_;
};

}  // namespace vides
