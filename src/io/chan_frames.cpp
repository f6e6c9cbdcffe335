// SPDX-License-Identifier: MIT
// The format `chan` of Nuke: number, position, rotation, vertical field of view a line.
#include <numbers>

#include "io/camera_angles.hpp"
#include "io/frame_text.hpp"

namespace vides {
namespace {

class ChanText : public FrameText {
 public:
  ChanText(const Flight& flight, const Space& space, std::int64_t firstNumber)
      : space_(space),
        lens_(flight.lens),
        width_(flight.picture.width),
        height_(flight.picture.height),
        firstNumber_(firstNumber) {}

  char* write(const Frame& frame, char* out) override {
    const Camera& camera = frame.camera;
    const Vec3 position = space_.toWorld(camera.viewReferencePoint);
    const CameraAngles angles = angles_.next(camera);
    const double fieldOfView =
        lens_.verticalFieldOfView(camera.zoom, width_, height_) * 180.0 / std::numbers::pi;
    out = writeInteger(out, frame.number + firstNumber_);
    for (const double x :
         {position.x, position.y, position.z, angles.rx, angles.ry, angles.rz, fieldOfView}) {
      *out++ = ' ';
      out = writeFixed6(out, x);
    }
    *out++ = '\n';
    return out;
  }

  // The angles continue from the flight's first frame, so that a part has the lines of the whole.
  bool depends() const override { return true; }
  void follow(const Frame& frame) override { angles_.next(frame.camera); }

 private:
  Space space_;
  Lens lens_;
  double width_;
  double height_;
  std::int64_t firstNumber_;
  AngleChain angles_;
};

std::unique_ptr<FrameText> make(const FrameTextInput& input) {
  return std::make_unique<ChanText>(input.flight, input.space, input.firstNumber);
}

}  // namespace

extern const FrameFormat kChanFrames{
    .name = "chan",
    .purpose = "for Nuke: n tx ty tz rx ry rz vfov, rotation order ZXY, degrees",
    .ending = ".chan",
    .space = FrameSpace::kWorld,
    .numbered = true,
    .make = make};

}  // namespace vides
