// SPDX-License-Identifier: MIT
// Fills the table of OpenGL functions and reads the context's limits.
#include "render/gl_functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

namespace vides {
namespace {

constexpr int kNeededMajor = 3;
constexpr int kNeededMinor = 3;

// "2.1 Mesa 22.3.6" gives {2, 1}; {0, 0} where the text does not begin so (OpenGL ES).
struct Version {
  int major = 0;
  int minor = 0;
};
Version parseVersion(std::string_view text) {
  Version version;
  const char* const end = text.data() + text.size();
  const auto [dot, error] = std::from_chars(text.data(), end, version.major);
  if (error != std::errc{} || dot == end || *dot != '.') return {};
  if (std::from_chars(dot + 1, end, version.minor).ec != std::errc{}) return {};
  return version;
}

// The driver's text after the number, with the renderer: "Mesa 22.3.6, llvmpipe".
std::string whatItIs(const GlLimits& limits) {
  std::string_view text = limits.version;
  text.remove_prefix(std::min(text.find(' '), text.size()));
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  if (text.empty()) return limits.renderer;
  return limits.renderer.empty() ? std::string(text) : fmt::format("{}, {}", text, limits.renderer);
}

std::string readString(const Gl& gl, GLenum name) {
  const GLubyte* text = gl.GetString(name);
  return text == nullptr ? std::string() : reinterpret_cast<const char*>(text);
}

int readInteger(const Gl& gl, GLenum name) {
  GLint value = 0;
  gl.GetIntegerv(name, &value);
  return value;
}

void readLimits(Gl& gl) {
  GLint viewport[2] = {0, 0};
  gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  const int renderbuffer = readInteger(gl, GL_MAX_RENDERBUFFER_SIZE);
  gl.limits.maxTextureSize = readInteger(gl, GL_MAX_TEXTURE_SIZE);
  gl.limits.maxWidth = std::min({viewport[0], renderbuffer, gl.limits.maxTextureSize});
  gl.limits.maxHeight = std::min({viewport[1], renderbuffer, gl.limits.maxTextureSize});
  gl.limits.maxSamples = readInteger(gl, GL_MAX_SAMPLES);
}

const char* errorName(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "an invalid enumerant";
    case GL_INVALID_VALUE:
      return "an invalid value";
    case GL_INVALID_OPERATION:
      return "an invalid operation";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "an incomplete framebuffer";
    case GL_OUT_OF_MEMORY:
      return "that memory has run out";
    default:
      return "an unknown error";
  }
}

}  // namespace

tl::expected<Gl, std::string> loadGl(const GlLoader& loader) {
  Gl gl;
  std::string missing;
  const auto load = [&](auto& member, const char* name) {
    const GlFunction function = loader(name);
    if (function == nullptr) missing += missing.empty() ? name : fmt::format(", {}", name);
    member = reinterpret_cast<std::remove_reference_t<decltype(member)>>(function);
  };
#define VIDES_GL_LOAD(name) load(gl.name, "gl" #name);
  VIDES_GL_FUNCTIONS(VIDES_GL_LOAD)
#undef VIDES_GL_LOAD

  if (gl.GetString == nullptr) return Failure("no OpenGL was found");
  gl.limits.version = readString(gl, GL_VERSION);
  gl.limits.renderer = readString(gl, GL_RENDERER);
  if (gl.limits.version.empty()) return Failure("OpenGL has no current context");
  const Version version = parseVersion(gl.limits.version);
  if (version.major < kNeededMajor ||
      (version.major == kNeededMajor && version.minor < kNeededMinor)) {
    return Failure(version.major == 0 ? fmt::format("OpenGL {}.{} is needed; this is {}",
                                                    kNeededMajor, kNeededMinor, gl.limits.version)
                                      : fmt::format("OpenGL {}.{} is needed; this is {}.{} ({})",
                                                    kNeededMajor, kNeededMinor, version.major,
                                                    version.minor, whatItIs(gl.limits)));
  }
  if (!missing.empty()) {
    return Failure(fmt::format("this OpenGL ({}) lacks {}", whatItIs(gl.limits), missing));
  }
  gl.limits.major = version.major;
  gl.limits.minor = version.minor;
  readLimits(gl);
  return gl;
}

tl::expected<void, std::string> checkGl(const Gl& gl, const char* what) {
  const GLenum first = gl.GetError();
  if (first == GL_NO_ERROR) return {};
  // A lost context reports an error for ever: bounded.
  for (int i = 0; i < 16 && gl.GetError() != GL_NO_ERROR; ++i) {
  }
  return Failure(fmt::format("{}: OpenGL reports {}", what, errorName(first)));
}

}  // namespace vides
