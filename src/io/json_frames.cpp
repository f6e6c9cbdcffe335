// SPDX-License-Identifier: MIT
// The format `json`: one object; each frame is an object on a line of its own.
#include <algorithm>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

#include "io/frame_text.hpp"
#include "io/vid_writer.hpp"

namespace vides {
namespace {

class JsonText : public FrameText {
 public:
  JsonText(const Flight& flight, const Space& space)
      : space_(space),
        lens_(flight.lens),
        width_(flight.picture.width),
        height_(flight.picture.height),
        head_(headOf(flight)) {}

  std::string head() const override { return head_; }

  char* write(const Frame& frame, char* out) override {
    if (!first_) *out++ = ',';
    first_ = false;
    out = appendText(out, "\n{\"frame\":");
    out = writeInteger(out, frame.number);
    out = appendText(out, ",\"time\":");
    out = writeShortest(out, frame.time);
    out = appendText(out, ",\"section\":");
    out = writeInteger(out, frame.section);
    out = appendText(out, ",\"kind\":\"");
    const std::string_view kind = name(frame.kind);
    out = std::copy(kind.begin(), kind.end(), out);
    const Camera& camera = frame.camera;
    out = appendText(out, "\",\"vrp\":");
    out = vector(space_.toWorld(camera.viewReferencePoint), out);
    out = appendText(out, ",\"vpn\":");
    out = vector(camera.viewPlaneNormal, out);
    out = appendText(out, ",\"vup\":");
    out = vector(camera.viewUpVector, out);
    out = appendText(out, ",\"zoom\":");
    out = writeShortest(out, camera.zoom);
    out = appendText(out, ",\"vertical_fov_deg\":");
    out = writeShortest(
        out, lens_.verticalFieldOfView(camera.zoom, width_, height_) * 180.0 / std::numbers::pi);
    *out++ = '}';
    return out;
  }

  std::string foot() const override { return "\n]}\n"; }

 private:
  static char* vector(const Vec3& v, char* out) {
    *out++ = '[';
    out = writeShortest(out, v.x);
    *out++ = ',';
    out = writeShortest(out, v.y);
    *out++ = ',';
    out = writeShortest(out, v.z);
    *out++ = ']';
    return out;
  }

  static std::string headOf(const Flight& flight) {
    std::string out = "{\"format\":\"vides-frames\",\"version\":1,\"frame_rate\":";
    appendJsonNumber(out, flight.frameRate);
    fmt::format_to(std::back_inserter(out), ",\"picture\":{{\"width\":{},\"height\":{}}}",
                   flight.picture.width, flight.picture.height);
    out += ",\"lens\":{\"sensor_width_mm\":";
    appendJsonNumber(out, flight.lens.sensorWidth);
    out += ",\"focal_length_mm\":[";
    appendJsonNumber(out, flight.lens.focalLengthAtZoom1);
    out += ',';
    appendJsonNumber(out, flight.lens.focalLengthAtZoom100);
    out += "]},\"space\":{\"center\":[";
    appendJsonNumber(out, flight.space.center.x);
    out += ',';
    appendJsonNumber(out, flight.space.center.y);
    out += ',';
    appendJsonNumber(out, flight.space.center.z);
    out += "],\"half_size\":";
    appendJsonNumber(out, flight.space.halfSize);
    out += "},\"frames\":[";
    return out;
  }

  Space space_;
  Lens lens_;
  double width_;
  double height_;
  std::string head_;
  bool first_ = true;
};

std::unique_ptr<FrameText> make(const FrameTextInput& input) {
  return std::make_unique<JsonText>(input.flight, input.space);
}

}  // namespace

extern const FrameFormat kJsonFrames{
    .name = "json",
    .purpose = "one object with lens, picture and space; a line per frame",
    .ending = ".json",
    .make = make};

}  // namespace vides
