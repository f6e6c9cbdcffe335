// SPDX-License-Identifier: MIT
// A window through GLFW.
#pragma once

#include <memory>
#include <string>

#include "host/host.hpp"
#include "render/failure.hpp"

namespace vides {

struct WindowOptions {
  std::string title = "vides";
  PixelSize size{1280, 800};  // at content scale 1; the window is that many times larger
  int samples = 0;            // a pixel; 0 or 1: no multisampling, as the shaders smooth all edges
};

// On the main thread, which then owns the window. Error: a sentence — there is no display, or no
// OpenGL 3.3.
tl::expected<std::unique_ptr<Host>, std::string> openGlfwHost(const WindowOptions& options);

}  // namespace vides
