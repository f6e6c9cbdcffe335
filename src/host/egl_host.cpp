// SPDX-License-Identifier: MIT
// A host without a window through EGL's surfaceless platform.
#include "host/egl_host.hpp"

// No native window system: keeps Xlib's headers out.
#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <array>
#include <string_view>

#include "host/current_context.hpp"
#include "host/library.hpp"

namespace vides {
namespace {

struct EglFunctions {
  decltype(&eglGetProcAddress) getProcAddress;
  decltype(&eglQueryString) queryString;
  decltype(&eglInitialize) initialize;
  decltype(&eglBindAPI) bindApi;
  decltype(&eglChooseConfig) chooseConfig;
  decltype(&eglCreateContext) createContext;
  decltype(&eglDestroyContext) destroyContext;
  decltype(&eglMakeCurrent) makeCurrent;
  decltype(&eglGetCurrentContext) currentContext;
  decltype(&eglGetError) getError;
};

tl::expected<EglFunctions, std::string> loadEgl(const std::string& name) {
  const auto library = Library::open(name);
  if (!library) return Failure("EGL is missing: " + library.error());
  EglFunctions egl{};
  if (!library->find("eglGetProcAddress", egl.getProcAddress) ||
      !library->find("eglQueryString", egl.queryString) ||
      !library->find("eglInitialize", egl.initialize) ||
      !library->find("eglBindAPI", egl.bindApi) ||
      !library->find("eglChooseConfig", egl.chooseConfig) ||
      !library->find("eglCreateContext", egl.createContext) ||
      !library->find("eglDestroyContext", egl.destroyContext) ||
      !library->find("eglMakeCurrent", egl.makeCurrent) ||
      !library->find("eglGetCurrentContext", egl.currentContext) ||
      !library->find("eglGetError", egl.getError)) {
    return Failure(fmt::format("{} is not EGL 1.4", name));
  }
  return egl;
}

bool has(const EglFunctions& egl, EGLDisplay display, std::string_view extension) {
  const char* text = egl.queryString(display, EGL_EXTENSIONS);
  if (text == nullptr) return false;
  // Whole words: one extension's name may begin another's.
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, end) == extension) return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

class EglHost final : public OffscreenHost {
 public:
  explicit EglHost(const EglFunctions& functions) : egl_(functions) {}
  // The display is not terminated: EGL has one a process, and another host may be using it.
  ~EglHost() override {
    if (context_ == EGL_NO_CONTEXT) return;
    makeCurrent();
    release();
    egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    setCurrentContext(nullptr);
    egl_.destroyContext(display_, context_);
  }

  tl::expected<void, std::string> open(const OffscreenOptions& options) {
    if (const auto opened = openDisplay(); !opened) return opened;
    if (const auto created = createContext(); !created) return created;
    return start([this](const char* name) { return egl_.getProcAddress(name); }, options);
  }

  void makeCurrent() override {
    if (!isCurrentContext(context_) || egl_.currentContext() != context_) bind();
  }

 protected:
  void bindAnew() override { bind(); }

 private:
  bool bind() {
    setCurrentContext(context_);
    // It does nothing for a context that it takes for current.
    egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    return egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }

  tl::expected<void, std::string> openDisplay() {
    const auto getPlatformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        egl_.getProcAddress("eglGetPlatformDisplayEXT"));
    if (!has(egl_, EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless") ||
        getPlatformDisplay == nullptr) {
      return Failure("this EGL cannot draw without a screen (no surfaceless platform)");
    }
    display_ = getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    EGLint major = 0;
    EGLint minor = 0;
    if (display_ == EGL_NO_DISPLAY || egl_.initialize(display_, &major, &minor) != EGL_TRUE) {
      return Failure(fmt::format("EGL cannot be started (0x{:x})", egl_.getError()));
    }
    if (!has(egl_, display_, "EGL_KHR_surfaceless_context")) {
      return Failure("this EGL cannot draw without a screen (no surfaceless contexts)");
    }
    return {};
  }

  tl::expected<void, std::string> createContext() {
    if (egl_.bindApi(EGL_OPENGL_API) != EGL_TRUE) {
      return Failure("OpenGL 3.3 is needed, and EGL gives none");
    }
    const std::array<EGLint, 5> wanted = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                          EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (egl_.chooseConfig(display_, wanted.data(), &config, 1, &count) != EGL_TRUE || count < 1) {
      return Failure("OpenGL 3.3 is needed, and EGL gives none");
    }
    const std::array<EGLint, 7> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                              3,
                                              EGL_CONTEXT_MINOR_VERSION,
                                              3,
                                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                              EGL_NONE};
    context_ = egl_.createContext(display_, config, EGL_NO_CONTEXT, attributes.data());
    // Without OpenGL 3.3 whatever there is can still say what it is: start() refuses it.
    if (context_ == EGL_NO_CONTEXT) {
      context_ = egl_.createContext(display_, config, EGL_NO_CONTEXT, nullptr);
    }
    if (context_ == EGL_NO_CONTEXT || !bind()) {
      return Failure(
          fmt::format("OpenGL 3.3 is needed, and EGL gives none (0x{:x})", egl_.getError()));
    }
    return {};
  }

  EglFunctions egl_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

tl::expected<std::unique_ptr<OffscreenHost>, std::string> openEglHost(const EglOptions& options) {
  const auto functions = loadEgl(options.library);
  if (!functions) return Failure(functions.error());
  auto host = std::make_unique<EglHost>(*functions);
  if (const auto opened = host->open(options); !opened) return Failure(opened.error());
  return host;
}

}  // namespace vides
