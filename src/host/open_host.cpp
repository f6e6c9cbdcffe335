// SPDX-License-Identifier: MIT
// Opens the hosts that this build has.
#include "host/open_host.hpp"

#include "host/osmesa_host.hpp"
#ifdef VIDES_HAVE_EGL
#include "host/egl_host.hpp"
#endif

namespace vides {

tl::expected<std::unique_ptr<Host>, std::string> openWindow(
    [[maybe_unused]] const WindowOptions& options) {
#ifdef VIDES_HAVE_GLFW
  return openGlfwHost(options);
#else
  return Failure("this vides was built without GLFW and cannot open a window");
#endif
}

tl::expected<std::unique_ptr<OffscreenHost>, std::string> openOffscreen(
    OffscreenKind kind, const OffscreenOptions& options) {
  if (kind == OffscreenKind::kOsmesa) {
    OsmesaOptions osmesa;
    static_cast<OffscreenOptions&>(osmesa) = options;
    return openOsmesaHost(osmesa);
  }
#ifdef VIDES_HAVE_EGL
  EglOptions egl;
  static_cast<OffscreenOptions&>(egl) = options;
  return openEglHost(egl);
#else
  return Failure("this vides was built without EGL");
#endif
}

}  // namespace vides
