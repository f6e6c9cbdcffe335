// SPDX-License-Identifier: MIT
// Somewhere to draw that is no window: multisampled, resolved into a texture, read back.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "render/failure.hpp"
#include "render/gl_functions.hpp"
#include "render/gl_objects.hpp"
#include "render/picture.hpp"

namespace vides {

// RGBA8 colour with depth 24 and stencil 8. Colours are plain sRGB bytes (blended as such).
class Framebuffer {
 public:
  Framebuffer() = default;
  // `width`, `height` ≥ 1 in pixels; `samples` a pixel: 0 or 1 is none, more than the GPU's most is
  // that most. Error: a size beyond the limits of this OpenGL or 2^26 pixels, or out of memory.
  static tl::expected<Framebuffer, std::string> create(const Gl& gl, int width, int height,
                                                       int samples);

  // What one draws into; the viewport becomes all of it. Scissor and state are the caller's.
  void bind() const;
  GLuint id() const { return draw_.id(); }

  // Averages the samples into texture(): call after drawing, before reading or showing it. Leaves
  // the drawing framebuffer bound. Turns the scissor test off, for it would cut the copy.
  void resolve();
  // What resolve() wrote, row 0 at the bottom (OpenGL's order).
  const Texture& texture() const { return texture_; }
  // What resolve() wrote, top row first.
  tl::expected<Picture, std::string> read() const;

  int width() const { return texture_.width(); }
  int height() const { return texture_.height(); }
  int samples() const { return samples_; }  // 0: none
  explicit operator bool() const { return static_cast<bool>(draw_); }

 private:
  FramebufferHandle draw_;     // colour_ and depth_; or texture_ and depth_ without samples
  FramebufferHandle resolve_;  // texture_; empty without samples
  RenderbufferHandle colour_;
  RenderbufferHandle depth_;
  Texture texture_;
  int samples_ = 0;
};

}  // namespace vides
