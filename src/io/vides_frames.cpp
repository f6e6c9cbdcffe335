// SPDX-License-Identifier: MIT
// The format `vides` (paper B.2.3): VRP, VPN, VUP and zoom, each as C's "%3.4f".
#include "io/frame_text.hpp"

namespace vides {
namespace {

class VidesText : public FrameText {
 public:
  explicit VidesText(const Space& space) : space_(space) {}

  char* write(const Frame& frame, char* out) override {
    const Camera& camera = frame.camera;
    out = vector(space_.toWorld(camera.viewReferencePoint), out);
    out = vector(camera.viewPlaneNormal, out);
    out = vector(camera.viewUpVector, out);
    // No number with four decimals is shorter than the three columns of "%3.4f".
    out = writeFixed4(out, camera.zoom);
    *out++ = '\n';
    return out;
  }

 private:
  static char* vector(const Vec3& v, char* out) {
    for (const double x : {v.x, v.y, v.z}) {
      out = writeFixed4(out, x);
      *out++ = ' ';
    }
    return out;
  }

  Space space_;
};

std::unique_ptr<FrameText> make(const FrameTextInput& input) {
  return std::make_unique<VidesText>(input.space);
}

}  // namespace

extern const FrameFormat kVidesFrames{
    .name = "vides",
    .purpose = "ten numbers a line: VRP, VPN, VUP, zoom, with four decimals",
    .ending = ".txt",
    .make = make};

}  // namespace vides
