// SPDX-License-Identifier: MIT
// The layout of `.vid` files.
#include "io/vid_writer.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <iterator>
#include <span>

#include "flight/limits.hpp"
#include "flight/validation.hpp"
#include "io/atomic_file.hpp"
#include "io/frame_limit.hpp"

namespace vides {
namespace {

constexpr std::size_t kPieceSize = std::size_t{1} << 16;

std::string_view nameOf(AimMode mode) {
  return mode == AimMode::kAbsolute ? "absolute" : "relative";
}

// Writes members and elements with their commas; an object or array either stands on one line or
// has each of its parts on a line of its own.
class Layout {
 public:
  explicit Layout(std::string& out) : out_(out) {}

  void open(char bracket, bool oneLine = false) {
    out_ += bracket;
    ++depth_;
    oneLine_ = oneLine;
    first_ = true;
  }
  // The parts after an object or array stand in lines again: on one line stands nothing but what
  // has no lines inside.
  void close(char bracket) {
    --depth_;
    if (oneLine_) {
      out_ += ' ';
    } else {
      newLine();
    }
    out_ += bracket;
    oneLine_ = false;
    first_ = false;
  }
  void element() {
    if (!first_) out_ += ',';
    if (oneLine_) {
      out_ += ' ';
    } else {
      newLine();
    }
    first_ = false;
  }
  void member(std::string_view name) {
    element();
    ((out_ += '"') += name) += "\": ";
  }

  void value(std::string_view text) { appendJsonString(out_, text); }
  void value(double number) { appendJsonNumber(out_, number); }
  void value(int number) { fmt::format_to(std::back_inserter(out_), FMT_COMPILE("{}"), number); }
  void value(bool truth) { out_ += truth ? "true" : "false"; }
  void value(std::span<const double> numbers) {
    out_ += '[';
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (i > 0) out_ += ", ";
      appendJsonNumber(out_, numbers[i]);
    }
    out_ += ']';
  }
  void value(const Vec3& p) { value(std::initializer_list<double>{p.x, p.y, p.z}); }
  void value(std::initializer_list<double> numbers) {
    value(std::span<const double>(numbers.begin(), numbers.size()));
  }
  template <class Value>
  void member(std::string_view name, const Value& v) {
    member(name);
    value(v);
  }
  void extra(const Extra& members) {
    if (!members) return;
    for (const auto& [name, text] : *members) {
      element();
      ((out_ += name) += ": ") += text;
    }
  }

 private:
  void newLine() {
    out_ += '\n';
    out_.append(2 * depth_, ' ');
  }

  std::string& out_;
  std::size_t depth_ = 0;
  bool oneLine_ = false;
  bool first_ = true;
};

void writeShape(Layout& to, const Shape& shape) {
  to.member("tension", shape.tension);
  to.member("continuity", shape.continuity);
  to.member("bias", shape.bias);
}

void writeOrientation(Layout& to, const Orientation& o) {
  to.open('{');
  to.member("aim", o.aim);
  to.member("aim_mode", nameOf(o.aimMode));
  to.member("roll", o.roll);
  to.member("zoom", o.zoom);
  to.member("speed", std::span<const double>(o.speed));
  if (o.duration) to.member("duration", *o.duration);
  to.member("hold", o.hold);
  to.extra(o.extra);
  to.close('}');
}

void writeKey(Layout& to, const Key& key) {
  to.open('{');
  to.member("position", key.position);
  to.member("shape");
  to.open('{', true);
  if (key.shape.preset == KeyShape::kOwn) {
    writeShape(to, key.shape.own);
  } else {
    to.member("preset", key.shape.preset);
  }
  to.extra(key.shape.extra);
  to.close('}');
  to.member("orientations");
  to.open('[');
  for (const Orientation& o : key.orientations) {
    to.element();
    writeOrientation(to, o);
  }
  to.close(']');
  to.extra(key.extra);
  to.close('}');
}

void writeSmallObjects(Layout& to, const Flight& flight) {
  const Flight::Extras& extras = flight.extras;
  to.member("picture");
  to.open('{', true);
  to.member("width", flight.picture.width);
  to.member("height", flight.picture.height);
  to.extra(extras.picture);
  to.close('}');
  to.member("lens");
  to.open('{', true);
  to.member("sensor_width_mm", flight.lens.sensorWidth);
  to.member("focal_length_mm", std::initializer_list<double>{flight.lens.focalLengthAtZoom1,
                                                             flight.lens.focalLengthAtZoom100});
  to.extra(extras.lens);
  to.close('}');
  to.member("space");
  to.open('{', true);
  to.member("center", flight.space.center);
  to.member("half_size", flight.space.halfSize);
  to.extra(extras.space);
  to.close('}');
  to.member("rates");
  to.open('{', true);
  to.member("move", flight.rates.move);
  to.member("pan", flight.rates.pan);
  to.member("roll", flight.rates.roll);
  to.member("zoom", flight.rates.zoom);
  to.extra(extras.rates);
  to.close('}');
}

void writePresets(Layout& to, const Flight& flight) {
  to.member("presets");
  to.open('[');
  for (std::size_t i = 0; i < kPresets; ++i) {
    to.element();
    to.open('{', true);
    writeShape(to, flight.presets[i]);
    to.extra(flight.extras.presets[i]);
    to.close('}');
  }
  to.close(']');
}

// All entries on one line, as the example of the format has it.
void writeScene(Layout& to, std::string& out, const Flight& flight) {
  to.member("scene");
  out += '[';
  for (std::size_t i = 0; i < flight.scene.size(); ++i) {
    out += i == 0 ? " " : ", ";
    to.open('{', true);
    to.member("file", std::string_view(flight.scene[i].file));
    to.extra(flight.scene[i].extra);
    to.close('}');
  }
  out += flight.scene.empty() ? "]" : " ]";
}

}  // namespace

bool writeVid(const Flight& flight, const TextSink& sink) {
  std::string out;
  out.reserve(kPieceSize + kPieceSize / 4);
  Layout to(out);
  to.open('{');
  to.member("format", std::string_view("vides"));
  to.member("version", limits::kVersion);
  to.member("name", std::string_view(flight.name));
  to.member("frame_rate", flight.frameRate);
  writeSmallObjects(to, flight);
  to.member("closed", flight.closed);
  to.member("orientation_curve", flight.orientationCurve->name);
  writePresets(to, flight);
  to.member("keys");
  to.open('[');
  bool going = true;
  flight.keys.forEach([&](const Key& key) {
    if (!going) return;
    to.element();
    writeKey(to, key);
    if (out.size() >= kPieceSize) {
      going = sink(out);
      out.clear();
    }
  });
  to.close(']');
  writeScene(to, out, flight);
  to.extra(flight.extras.flight);
  to.close('}');
  out += '\n';
  return going && sink(out);
}

std::string writeVid(const Flight& flight) {
  std::string text;
  writeVid(flight, [&](std::string_view piece) {
    text += piece;
    return true;
  });
  return text;
}

std::optional<Problem> saveVid(const Flight& flight, const std::string& path) {
  if (std::vector<Problem> problems = validate(flight); !problems.empty()) {
    return std::move(problems.front());
  }
  if (std::optional<Problem> problem = checkFrameCount(flight)) return problem;
  AtomicFile file(path);
  writeVid(flight, [&](std::string_view piece) { return file.write(piece); });
  if (const auto saved = file.commit(); !saved) return problemOf(saved.error());
  return std::nullopt;
}

void appendJsonString(std::string& out, std::string_view text) {
  out += '"';
  for (const char c : text) {
    switch (c) {
      case '"':
        out += "\\\"";
        break;
      case '\\':
        out += "\\\\";
        break;
      case '\b':
        out += "\\b";
        break;
      case '\f':
        out += "\\f";
        break;
      case '\n':
        out += "\\n";
        break;
      case '\r':
        out += "\\r";
        break;
      case '\t':
        out += "\\t";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20) {
          fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<unsigned>(c));
        } else {
          out += c;
        }
    }
  }
  out += '"';
}

void appendJsonNumber(std::string& out, double value) {
  char digits[32];
  const double written = value == 0.0 ? 0.0 : value;  // not -0
  const auto end = fmt::format_to(digits, FMT_COMPILE("{}"), written);
  out.append(digits, end);
}

}  // namespace vides
