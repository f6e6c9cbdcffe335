// SPDX-License-Identifier: MIT
// Draws the test triangle on a host in a process of its own, whose environment a test can choose.
//
// usage: host_probe osmesa|egl|window WIDTHxHEIGHT [FILE]: writes the raw RGBA bytes to FILE (not
// for a window) and prints the renderer's name; or prints the reason on standard error and ends
// with status 1.
#include <cstdio>
#include <fstream>
#include <iostream>

#include "host/open_host.hpp"
#include "support/triangle.hpp"

namespace {

using namespace vides;

// OSMesa is suppressed by leaks.supp; what the drivers of EGL and GLX keep cannot be told apart
// from a leak of ours.
bool leaksAreTold = true;

int refuse(const std::string& sentence) {
  std::cerr << sentence << '\n';
  return 1;
}

int drawInWindow(PixelSize size) {
  leaksAreTold = false;
  WindowOptions options;
  options.size = size;
  const auto host = openWindow(options);
  if (!host) return refuse(host.error());
  test::drawTriangle(**host);
  std::cout << (*host)->gl().limits.renderer << '\n';
  return 0;
}

int drawOffscreen(OffscreenKind kind, PixelSize size, const char* file) {
  leaksAreTold = kind == OffscreenKind::kOsmesa;
  OffscreenOptions options;
  options.size = size;
  options.samples = 4;
  const auto host = openOffscreen(kind, options);
  if (!host) return refuse(host.error());
  test::drawTriangle(**host);
  const auto picture = (*host)->picture();
  if (!picture) return refuse(picture.error());
  if (file != nullptr) {
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(picture->rgba.data()),
               static_cast<std::streamsize>(picture->rgba.size()));
  }
  std::cout << (*host)->gl().limits.renderer << '\n';
  return 0;
}

}  // namespace

extern "C" int __lsan_is_turned_off();
extern "C" int __lsan_is_turned_off() { return leaksAreTold ? 0 : 1; }

int main(int count, char** arguments) {
  PixelSize size;
  if (count < 3 || std::sscanf(arguments[2], "%dx%d", &size.width, &size.height) != 2) return 2;
  const std::string kind = arguments[1];
  if (kind == "window") return drawInWindow(size);
  return drawOffscreen(kind == "egl" ? OffscreenKind::kEgl : OffscreenKind::kOsmesa, size,
                       count > 3 ? arguments[3] : nullptr);
}
