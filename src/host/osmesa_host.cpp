// SPDX-License-Identifier: MIT
// A host without a window through OSMesa.
#include "host/osmesa_host.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>

#include "host/current_context.hpp"
#include "host/library.hpp"

namespace vides {
namespace {

// What we use of GL/osmesa.h, declared here because that header pulls in GL/gl.h.
using OsmesaContext = struct osmesa_context*;
struct OsmesaFunctions {
  OsmesaContext (*createContext)(GLenum format, GLint depthBits, GLint stencilBits,
                                 GLint accumulationBits, OsmesaContext sharing);
  OsmesaContext (*createContextAttributes)(const int* attributes, OsmesaContext sharing);
  void (*destroyContext)(OsmesaContext context);
  GLboolean (*makeCurrent)(OsmesaContext context, void* buffer, GLenum type, GLsizei width,
                           GLsizei height);
  OsmesaContext (*currentContext)();
  GlFunction (*getProcAddress)(const char* name);
};
constexpr int kFormat = 0x22;  // OSMESA_FORMAT
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36;
constexpr int kMinorVersion = 0x37;

// OSMesa wants a picture of its own; ours is a framebuffer object, so this one is never drawn into.
constexpr int kUnusedSide = 16;

class OsmesaHost final : public OffscreenHost {
 public:
  explicit OsmesaHost(const OsmesaFunctions& functions) : osmesa_(functions) {}
  ~OsmesaHost() override {
    if (context_ == nullptr) return;
    makeCurrent();
    release();
    osmesa_.makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    setCurrentContext(nullptr);
    osmesa_.destroyContext(context_);
  }

  tl::expected<void, std::string> open(const OffscreenOptions& options) {
    const std::array attributes = {kFormat,       GL_RGBA, kProfile, kCoreProfile, kMajorVersion, 3,
                                   kMinorVersion, 3,       0};
    context_ = osmesa_.createContextAttributes(attributes.data(), nullptr);
    // Without OpenGL 3.3 whatever there is can still say what it is: start() refuses it.
    if (context_ == nullptr) context_ = osmesa_.createContext(GL_RGBA, 0, 0, 0, nullptr);
    if (context_ == nullptr || !bind()) {
      return Failure("OpenGL 3.3 is needed, and OSMesa gives none");
    }
    return start([this](const char* name) { return osmesa_.getProcAddress(name); }, options);
  }

  void makeCurrent() override {
    if (!isCurrentContext(context_) || osmesa_.currentContext() != context_) bind();
  }

 protected:
  void bindAnew() override { bind(); }

 private:
  bool bind() {
    setCurrentContext(context_);
    return osmesa_.makeCurrent(context_, unused_.data(), GL_UNSIGNED_BYTE, kUnusedSide,
                               kUnusedSide) == GL_TRUE;
  }

  OsmesaFunctions osmesa_;
  OsmesaContext context_ = nullptr;
  std::array<std::uint32_t, std::size_t{kUnusedSide} * kUnusedSide> unused_{};
};

}  // namespace

tl::expected<std::unique_ptr<OffscreenHost>, std::string> openOsmesaHost(
    const OsmesaOptions& options) {
  const auto library = Library::open(options.library);
  if (!library) return Failure("OSMesa is missing: " + library.error());
  OsmesaFunctions functions{};
  if (!library->find("OSMesaCreateContextExt", functions.createContext) ||
      !library->find("OSMesaCreateContextAttribs", functions.createContextAttributes) ||
      !library->find("OSMesaDestroyContext", functions.destroyContext) ||
      !library->find("OSMesaMakeCurrent", functions.makeCurrent) ||
      !library->find("OSMesaGetCurrentContext", functions.currentContext) ||
      !library->find("OSMesaGetProcAddress", functions.getProcAddress)) {
    return Failure(fmt::format("{} is not an OSMesa that knows OpenGL 3.3", options.library));
  }
  auto host = std::make_unique<OsmesaHost>(functions);
  if (const auto opened = host->open(options); !opened) return Failure(opened.error());
  return host;
}

}  // namespace vides
