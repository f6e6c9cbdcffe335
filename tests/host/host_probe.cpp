// SPDX-License-Identifier: MIT
// Draws the test triangle on a host in a process of its own, whose environment a test can choose.
//
// usage: host_probe osmesa|egl|glfw WIDTHxHEIGHT [FILE]: writes the raw RGBA bytes to FILE, prints
// the renderer's name; or prints the reason on standard error and ends with status 1.
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <memory>

#include "host/osmesa_host.hpp"
#ifdef VIDES_HAVE_EGL
#include "host/egl_host.hpp"
#endif
#include "support/triangle.hpp"

namespace {

using vides::OffscreenHost;

// OSMesa is suppressed by leaks.supp; what EGL's drivers keep is not told apart from leaks of ours.
bool leaksAreTold = true;

tl::expected<std::unique_ptr<OffscreenHost>, std::string> open(const std::string& kind,
                                                               vides::PixelSize size) {
  if (kind == "osmesa") {
    vides::OsmesaOptions options;
    options.size = size;
    return vides::openOsmesaHost(options);
  }
#ifdef VIDES_HAVE_EGL
  if (kind == "egl") {
    leaksAreTold = false;
    vides::EglOptions options;
    options.size = size;
    return vides::openEglHost(options);
  }
#endif
  return vides::Failure(kind + ": no such host");
}

int run(const std::string& kind, vides::PixelSize size, const char* file) {
  const auto host = open(kind, size);
  if (!host) {
    std::cerr << host.error() << '\n';
    return 1;
  }
  vides::test::drawTriangle(**host);
  const auto picture = (*host)->picture();
  if (!picture) {
    std::cerr << picture.error() << '\n';
    return 1;
  }
  if (file != nullptr) {
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(picture->rgba.data()),
               static_cast<std::streamsize>(picture->rgba.size()));
  }
  std::cout << (*host)->gl().limits.renderer << '\n';
  return 0;
}

}  // namespace

extern "C" int __lsan_is_turned_off() { return leaksAreTold ? 0 : 1; }

int main(int count, char** arguments) {
  vides::PixelSize size;
  if (count < 3 || std::sscanf(arguments[2], "%dx%d", &size.width, &size.height) != 2) return 2;
  return run(arguments[1], size, count > 3 ? arguments[3] : nullptr);
}
