// SPDX-License-Identifier: MIT
// Draws a list of things (scene/draw_list.hpp) through a table of OpenGL functions.
//
// Lines are quads, expanded in the vertex shader from points in a buffer texture, and covered
// analytically in the fragment shader: any width and dash, no multisampling, no driver's line
// width. What is tested against depth is blended in two layers, the hidden before the hiding, so
// that edges have no dark seams. Colours are plain sRGB bytes and blend as such.
// Texts of a list are not drawn here.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "render/failure.hpp"
#include "render/gl_functions.hpp"
#include "scene/draw_list.hpp"

namespace vides {

class SceneRenderer {
 public:
  // Error: a shader does not build. The table must outlive the renderer, and its context be current
  // wherever the renderer is made, used or destroyed.
  static tl::expected<SceneRenderer, std::string> create(const Gl& gl);
  ~SceneRenderer();
  SceneRenderer(SceneRenderer&&) noexcept;
  SceneRenderer& operator=(SceneRenderer&&) noexcept;

  // Draws into the list's rectangle of the bound framebuffer, which has depth and stencil and is
  // `width` × `height` pixels; nothing outside the rectangle changes, nor outside `clip`, if there
  // is one (pixels, y down). Clears depth there. Leaves the viewport the whole framebuffer, and all
  // tests, blending and scissor off, no program and no vertex array bound.
  void draw(const DrawList& list, int width, int height,
            const std::optional<PixelRectangle>& clip = std::nullopt);

  // Of the last draw(): for tests and measurements.
  struct Statistics {
    std::size_t uploadedBytes = 0;
    std::size_t uploads = 0;
    std::size_t drawCalls = 0;
    std::size_t elements = 0;  // each once, however often it is passed over
  };
  const Statistics& statistics() const;

 private:
  struct Parts;
  explicit SceneRenderer(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace vides
