// SPDX-License-Identifier: MIT
// The format `csv`: a header line, then every number of a frame to the last bit.
#include <algorithm>

#include "io/frame_text.hpp"

namespace vides {
namespace {

class CsvText : public FrameText {
 public:
  explicit CsvText(const Space& space) : space_(space) {}

  std::string head() const override {
    return "frame,time,section,kind,vrp_x,vrp_y,vrp_z,vpn_x,vpn_y,vpn_z,vup_x,vup_y,vup_z,zoom\n";
  }

  char* write(const Frame& frame, char* out) override {
    out = writeInteger(out, frame.number);
    *out++ = ',';
    out = writeShortest(out, frame.time);
    *out++ = ',';
    out = writeInteger(out, frame.section);
    *out++ = ',';
    const std::string_view kind = name(frame.kind);
    out = std::copy(kind.begin(), kind.end(), out);
    const Camera& camera = frame.camera;
    out = vector(space_.toWorld(camera.viewReferencePoint), out);
    out = vector(camera.viewPlaneNormal, out);
    out = vector(camera.viewUpVector, out);
    *out++ = ',';
    out = writeShortest(out, camera.zoom);
    *out++ = '\n';
    return out;
  }

 private:
  static char* vector(const Vec3& v, char* out) {
    for (const double x : {v.x, v.y, v.z}) {
      *out++ = ',';
      out = writeShortest(out, x);
    }
    return out;
  }

  Space space_;
};

std::unique_ptr<FrameText> make(const FrameTextInput& input) {
  return std::make_unique<CsvText>(input.space);
}

}  // namespace

extern const FrameFormat kCsvFrames{
    .name = "csv",
    .purpose = "a header line, then frame, time, section, kind and the ten numbers",
    .ending = ".csv",
    .make = make};

}  // namespace vides
