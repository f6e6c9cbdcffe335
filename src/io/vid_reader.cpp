// SPDX-License-Identifier: MIT
// The schema of the `.vid` format: tables of members, from the outermost object inwards.
#include "io/vid_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "flight/validation.hpp"
#include "io/frame_limit.hpp"
#include "io/read_file.hpp"
#include "io/vid_values.hpp"

namespace vides {
namespace {

// Ends the reading: nothing else is told.
struct NewerVersion {
  std::string format;
};

// What is read of a key before it is known to be right: the aims may stand before the position.
struct OrientationReading {
  Orientation orientation;
  std::size_t aimOffset = 0;
  bool aimGood = false;
  bool modeGood = true;
};
struct KeyReading {
  Key key;
  bool positionGood = false;
  std::vector<OrientationReading> orientations;
};
struct FlightReading {
  Flight flight;
  std::vector<KeyPointer> keys;
};

// What is expected of members that must be there.
Expectation expectFormat() {
  Expectation e = expectKind(Expected::kValue);
  e.text = "\"vides\"";
  return e;
}
Expectation expectVersion() { return expectInteger({limits::kVersion, limits::kVersion}); }
Expectation expectShapeNumber() { return expectNumber(limits::kShape); }
Expectation expectPosition() { return expectNumbers(3, limits::kPosition); }
Expectation expectAim() { return expectNumbers(3, limits::kAim); }
Expectation expectPath() { return expectKind(Expected::kPath); }
Expectation expectOrientations() { return expectCount(limits::kOrientations); }
Expectation expectKeys() { return expectCount(limits::kKeys); }
Expectation expectPresets() { return expectCount({kPresets, kPresets}); }
Expectation expectScene() { return expectKind(Expected::kArray); }

constexpr VidValues::Choice<AimMode> kAimModes[] = {{"absolute", AimMode::kAbsolute},
                                                    {"relative", AimMode::kRelative}};

void readOrientationCurve(VidValues& v, FlightReading& f) {
  std::vector<VidValues::Choice<const OrientationMethod*>> choices;
  for (const OrientationMethod* method : orientationMethods()) {
    choices.push_back({method->name, method});
  }
  v.oneOf<const OrientationMethod*>(choices, f.flight.orientationCurve);
}

// A `duration` that is absent means something else than any number.
void readDuration(VidValues& v, OrientationReading& o) {
  double seconds = 0.0;
  if (v.number(limits::kDuration, seconds)) o.orientation.duration = seconds;
}

constexpr Member<OrientationReading> kOrientationMembers[] = {
    {"aim",
     [](VidValues& v, OrientationReading& o) {
       o.aimGood = v.point(limits::kAim, o.orientation.aim, &o.aimOffset);
     },
     expectAim},
    {"aim_mode",
     [](VidValues& v, OrientationReading& o) {
       o.modeGood = v.oneOf<AimMode>(kAimModes, o.orientation.aimMode);
     }},
    {"roll",
     [](VidValues& v, OrientationReading& o) { v.number(limits::kRoll, o.orientation.roll); }},
    {"zoom",
     [](VidValues& v, OrientationReading& o) { v.number(limits::kZoom, o.orientation.zoom); }},
    {"speed",
     [](VidValues& v, OrientationReading& o) { v.numbers(limits::kSpeed, o.orientation.speed); }},
    {"duration", readDuration},
    {"hold",
     [](VidValues& v, OrientationReading& o) { v.number(limits::kHold, o.orientation.hold); }}};

constexpr Member<Shape> kShapeMembers[] = {
    {"tension", [](VidValues& v, Shape& s) { v.number(limits::kShape, s.tension); },
     expectShapeNumber},
    {"continuity", [](VidValues& v, Shape& s) { v.number(limits::kShape, s.continuity); },
     expectShapeNumber},
    {"bias", [](VidValues& v, Shape& s) { v.number(limits::kShape, s.bias); }, expectShapeNumber}};

// Of these either the first or all others: readKeyShape sees to it.
constexpr Member<KeyShape> kKeyShapeMembers[] = {
    {"preset", [](VidValues& v, KeyShape& s) { v.integer(limits::kPreset, s.preset); }},
    {"tension", [](VidValues& v, KeyShape& s) { v.number(limits::kShape, s.own.tension); }},
    {"continuity", [](VidValues& v, KeyShape& s) { v.number(limits::kShape, s.own.continuity); }},
    {"bias", [](VidValues& v, KeyShape& s) { v.number(limits::kShape, s.own.bias); }}};

void readKeyShape(VidValues& v, KeyShape& shape) {
  constexpr std::uint32_t kPresetBit = 1;
  const VidValues::Seen seen = v.object<KeyShape>(kKeyShapeMembers, shape, shape.extra);
  if (!seen.object) return;
  const std::size_t end = v.json().offset();
  if (seen.members == 0) {
    v.note(end, ProblemCode::kMissing, v.json().pointer() + "/preset",
           expectKind(Expected::kShape));
    return;
  }
  const bool preset = (seen.members & kPresetBit) != 0;
  if (!preset) shape.preset = KeyShape::kOwn;
  for (std::size_t i = 1; i < std::size(kKeyShapeMembers); ++i) {
    const bool there = (seen.members >> i & 1u) != 0;
    if (there != preset) continue;  // as it should be
    const std::string pointer = v.json().pointer() + pointerToken(kKeyShapeMembers[i].name);
    if (preset) {
      Expectation expected = expectKind(Expected::kNotBeside);
      expected.text = "preset";
      v.note(end, ProblemCode::kUnknownMember, pointer, expected);
    } else {
      v.note(end, ProblemCode::kMissing, pointer, expectShapeNumber());
    }
  }
}

void readOrientations(VidValues& v, KeyReading& key) {
  key.orientations.clear();
  v.array(expectOrientations, limits::kOrientations, [&](std::size_t) {
    OrientationReading& reading = key.orientations.emplace_back();
    v.object<OrientationReading>(kOrientationMembers, reading, reading.orientation.extra);
  });
}

constexpr Member<KeyReading> kKeyMembers[] = {
    {"position",
     [](VidValues& v, KeyReading& k) {
       k.positionGood = v.point(limits::kPosition, k.key.position);
     },
     expectPosition},
    {"shape", [](VidValues& v, KeyReading& k) { readKeyShape(v, k.key.shape); }},
    {"orientations", readOrientations, expectOrientations}};

void checkAims(VidValues& v, const KeyReading& key) {
  for (std::size_t i = 0; i < key.orientations.size(); ++i) {
    const OrientationReading& reading = key.orientations[i];
    if (!key.positionGood || !reading.aimGood || !reading.modeGood) continue;
    const Orientation& o = reading.orientation;
    auto problem = checkAimDistance(key.key.position, o.aimMode, o.aim, {});
    if (!problem) continue;
    problem->pointer = fmt::format("{}/orientations/{}/aim", v.json().pointer(), i);
    v.problems().add(reading.aimOffset, std::move(*problem));
  }
}

void readKeys(VidValues& v, FlightReading& f) {
  KeyReading reading;
  v.array(expectKeys, limits::kKeys, [&](std::size_t) {
    reading.key.shape = KeyShape{};
    reading.key.extra = nullptr;
    reading.positionGood = false;
    reading.orientations.clear();
    v.object<KeyReading>(kKeyMembers, reading, reading.key.extra);
    checkAims(v, reading);
    if (!v.problems().empty()) return;  // this file won't become a flight
    reading.key.orientations.clear();
    reading.key.orientations.reserve(reading.orientations.size());
    for (OrientationReading& o : reading.orientations) {
      reading.key.orientations.push_back(std::move(o.orientation));
    }
    f.keys.emplace_back(std::move(reading.key));
  });
}

void readPresets(VidValues& v, FlightReading& f) {
  v.array(expectPresets, {kPresets, kPresets}, [&](std::size_t i) {
    v.object<Shape>(kShapeMembers, f.flight.presets[i], f.flight.extras.presets[i]);
  });
}

constexpr Member<PictureFormat> kPictureMembers[] = {
    {"width", [](VidValues& v, PictureFormat& p) { v.integer(limits::kPictureSize, p.width); }},
    {"height", [](VidValues& v, PictureFormat& p) { v.integer(limits::kPictureSize, p.height); }}};

void readFocalLengths(VidValues& v, Lens& lens) {
  double lengths[2] = {lens.focalLengthAtZoom1, lens.focalLengthAtZoom100};
  v.numbers(limits::kFocalLength, lengths);
  lens.focalLengthAtZoom1 = lengths[0];
  lens.focalLengthAtZoom100 = lengths[1];
}

constexpr Member<Lens> kLensMembers[] = {
    {"sensor_width_mm",
     [](VidValues& v, Lens& lens) { v.number(limits::kSensorWidth, lens.sensorWidth); }},
    {"focal_length_mm", readFocalLengths}};

void readSpaceCenter(VidValues& v, Space& space) {
  std::size_t start = 0;
  Vec3 center = space.center;
  if (!v.point({-limits::kFinite, limits::kFinite}, center, &start)) return;
  if (auto problem = checkSpaceCenter(center, v.json().pointer())) {
    v.problems().add(start, std::move(*problem));
    return;
  }
  space.center = center;
}

constexpr Member<Space> kSpaceMembers[] = {
    {"center", readSpaceCenter},
    {"half_size", [](VidValues& v, Space& s) { v.number(limits::kSpaceHalfSize, s.halfSize); }}};

constexpr Member<Rates> kRatesMembers[] = {
    {"move", [](VidValues& v, Rates& r) { v.number(limits::kRate, r.move); }},
    {"pan", [](VidValues& v, Rates& r) { v.number(limits::kRate, r.pan); }},
    {"roll", [](VidValues& v, Rates& r) { v.number(limits::kRate, r.roll); }},
    {"zoom", [](VidValues& v, Rates& r) { v.number(limits::kRate, r.zoom); }}};

constexpr Member<SceneFile> kSceneMembers[] = {
    {"file", [](VidValues& v, SceneFile& s) { v.path(s.file); }, expectPath}};

void readScene(VidValues& v, FlightReading& f) {
  constexpr CountRange kAny{0, limits::kFileSize};
  v.array(expectScene, kAny, [&](std::size_t) {
    SceneFile file;
    v.object<SceneFile>(kSceneMembers, file, file.extra);
    if (v.problems().empty()) f.flight.scene.push_back(std::move(file));
  });
}

void readVersion(VidValues& v, FlightReading&) {
  if (v.json().kind() == JsonReader::Kind::kNumber) {
    const std::size_t start = v.json().offset();
    const JsonNumber found = v.json().number();
    const bool whole = std::trunc(found.value) == found.value;
    if (whole && found.value > limits::kVersion) {
      throw NewerVersion{found.value < 1e15 ? fmt::format("{:.0f}", found.value)
                                            : shortened(found.text)};
    }
    if (found.value == limits::kVersion) return;
    v.note(start, whole ? ProblemCode::kOutOfRange : ProblemCode::kWrongType, v.json().pointer(),
           expectVersion(), shortened(found.text));
  } else {
    v.wrongType(expectVersion());
  }
}

constexpr Member<FlightReading> kFlightMembers[] = {
    {"format", [](VidValues& v, FlightReading&) { v.text("vides"); }, expectFormat},
    {"version", readVersion, expectVersion},
    {"name", [](VidValues& v, FlightReading& f) { v.name(f.flight.name); }},
    {"frame_rate",
     [](VidValues& v, FlightReading& f) { v.number(limits::kFrameRate, f.flight.frameRate); }},
    {"picture",
     [](VidValues& v, FlightReading& f) {
       v.object<PictureFormat>(kPictureMembers, f.flight.picture, f.flight.extras.picture);
     }},
    {"lens",
     [](VidValues& v, FlightReading& f) {
       v.object<Lens>(kLensMembers, f.flight.lens, f.flight.extras.lens);
     }},
    {"space",
     [](VidValues& v, FlightReading& f) {
       v.object<Space>(kSpaceMembers, f.flight.space, f.flight.extras.space);
     }},
    {"rates",
     [](VidValues& v, FlightReading& f) {
       v.object<Rates>(kRatesMembers, f.flight.rates, f.flight.extras.rates);
     }},
    {"closed", [](VidValues& v, FlightReading& f) { v.boolean(f.flight.closed); }},
    {"orientation_curve", readOrientationCurve},
    {"presets", readPresets},
    {"keys", readKeys, expectKeys},
    {"scene", readScene}};

Problem withCode(ProblemCode code, std::string_view pointer) {
  Problem problem;
  problem.code = code;
  problem.pointer = pointer;
  return problem;
}

Problem newerVersion(const NewerVersion& newer) {
  Problem problem = withCode(ProblemCode::kNewerVersion, "/version");
  problem.expected = expectVersion();
  problem.found = newer.format;
  return problem;
}

Problem tooLarge() {
  Problem problem = withCode(ProblemCode::kTooLarge, {});
  problem.expected.max = static_cast<double>(limits::kFileSize);
  return problem;
}

ReadFlight readText(const tl::expected<std::string, Problem>& text) {
  if (!text) return tl::unexpected(std::vector<Problem>{text.error()});
  return readVid(*text);
}

}  // namespace

ReadFlight readVid(std::string_view text) {
  if (text.size() > limits::kFileSize) return tl::unexpected(std::vector<Problem>{tooLarge()});
  VidValues values(text);
  FlightReading reading;
  try {
    values.document([&] {
      values.object<FlightReading>(kFlightMembers, reading, reading.flight.extras.flight);
    });
  } catch (const NewerVersion& newer) {
    return tl::unexpected(std::vector<Problem>{newerVersion(newer)});
  }
  if (!values.problems().empty()) return tl::unexpected(values.problems().take());
  reading.flight.keys = KeyList(std::move(reading.keys));
  if (auto problem = checkFrameCount(reading.flight)) {
    return tl::unexpected(std::vector<Problem>{std::move(*problem)});
  }
  return std::move(reading.flight);
}

ReadFlight readVidFile(const std::string& path) {
  return readText(readFile(path, limits::kFileSize));
}

ReadFlight readVidDescriptor(int descriptor) {
  return readText(readDescriptor(descriptor, limits::kFileSize));
}

}  // namespace vides
