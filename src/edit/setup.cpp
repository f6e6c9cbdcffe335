// SPDX-License-Identifier: MIT
// The setup's file: its members, and how they are written.
#include "edit/setup.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>

#include "edit/file_obstacle.hpp"
#include "edit/view_state.hpp"
#include "flight/validation.hpp"
#include "io/atomic_file.hpp"
#include "io/read_file.hpp"
#include "io/vid_values.hpp"
#include "io/vid_writer.hpp"

namespace vides {
namespace {

constexpr std::string_view kFormat = "vides-setup";
constexpr std::string_view kGlide = "glide";  // a switch, but nothing that is shown
constexpr Range kByte{0, 255};
constexpr Range kTurn{-180, 180};
constexpr Range kTilt{-90, 90};
constexpr Range kSize{kMinViewSize, kMaxViewSize};

constexpr VidValues::Choice<Language> kLanguages[] = {{"en", Language::kEnglish},
                                                      {"de", Language::kGerman}};
constexpr VidValues::Choice<ThemeKind> kThemes[] = {{"dark", ThemeKind::kDark},
                                                    {"light", ThemeKind::kLight},
                                                    {"high_contrast", ThemeKind::kHighContrast}};
constexpr VidValues::Choice<Units> kUnits[] = {{"cube", Units::kCube}, {"scene", Units::kScene}};

// What is read, and whether it comes from a version that we don't know.
struct Reading {
  Setup setup;
  int version = 0;
};

Expectation expectFormat() {
  Expectation e = expectKind(Expected::kValue);
  e.text = '"' + std::string(kFormat) + '"';
  return e;
}
Expectation expectVersion() { return expectInteger({kSetupVersion, kSetupVersion}); }
Expectation expectColour() { return expectNumbers(3, kByte); }

void readShown(VidValues& v, Reading& r) {
  v.members([&](const std::string& name) {
    bool* const shown = name == kGlide ? nullptr : switchOf(r.setup.display, name);
    if (shown != nullptr) v.boolean(*shown);
    return shown != nullptr;
  });
}

void readSizes(VidValues& v, Reading& r) {
  v.members([&](const std::string& name) {
    const auto* const size = std::ranges::find(kElementSizes, name, &ElementSize::name);
    if (size == std::end(kElementSizes)) return false;
    v.number(size->range, r.setup.display.sizes.*size->size);
    return true;
  });
}

void readColours(VidValues& v, Reading& r) {
  v.members([&](const std::string& name) {
    const auto role = colourRole(name);
    if (!role || !isElement(*role)) return false;
    int bytes[3] = {};
    bool good = true;
    const bool three = v.array(expectColour, {3, 3},
                               [&](std::size_t i) { good = v.integer(kByte, bytes[i]) && good; });
    const auto byte = [&](int i) { return static_cast<std::uint8_t>(bytes[i]); };
    if (three && good) {
      r.setup.display.colours[static_cast<std::size_t>(*role)] =
          Colour{byte(0), byte(1), byte(2), 255};
    }
    return true;
  });
}

bool readLength(VidValues& v, const Range& range, float& into) {
  double length = 0.0;
  if (!v.number(range, length)) return false;
  into = static_cast<float>(length);
  return true;
}

constexpr auto kUpChoices = [] {
  std::array<VidValues::Choice<UpAxis>, kUpAxes.size()> choices{};
  for (std::size_t i = 0; i < choices.size(); ++i) choices[i] = {name(kUpAxes[i]), kUpAxes[i]};
  return choices;
}();

// Formats that this version doesn't read are passed over.
void readImportUp(VidValues& v, Reading& r) {
  v.members([&](const std::string& ending) {
    if (ending != "obj") return false;
    UpAxis axis = UpAxis::kY;
    if (v.oneOf<UpAxis>(kUpChoices, axis)) r.setup.importUp[ending] = axis;
    return true;
  });
}

constexpr Member<Layout> kLayoutMembers[] = {
    {"left", [](VidValues& v, Layout& l) { readLength(v, kLeftWidth, l.left); }},
    {"right", [](VidValues& v, Layout& l) { readLength(v, kRightWidth, l.right); }},
    {"timeline", [](VidValues& v, Layout& l) { readLength(v, kTimelineHeight, l.timeline); }},
    {"left_shown", [](VidValues& v, Layout& l) { v.boolean(l.leftShown); }},
    {"right_shown", [](VidValues& v, Layout& l) { v.boolean(l.rightShown); }},
    {"timeline_shown", [](VidValues& v, Layout& l) { v.boolean(l.timelineShown); }}};

constexpr Member<Setup> kViewMembers[] = {
    {"turn", [](VidValues& v, Setup& s) { v.number(kTurn, s.turn); }},
    {"tilt", [](VidValues& v, Setup& s) { v.number(kTilt, s.tilt); }},
    {"size", [](VidValues& v, Setup& s) { v.number(kSize, s.size); }},
    {"perspective", [](VidValues& v, Setup& s) { v.boolean(s.perspective); }}};

void readVersion(VidValues& v, Reading& r) { v.integer({1, 1e9}, r.version); }

constexpr Member<Reading> kMembers[] = {
    {"format", [](VidValues& v, Reading&) { v.text(kFormat); }, expectFormat},
    {"version", readVersion, expectVersion},
    {"language",
     [](VidValues& v, Reading& r) { v.oneOf<Language>(kLanguages, r.setup.display.language); }},
    {"theme", [](VidValues& v, Reading& r) { v.oneOf<ThemeKind>(kThemes, r.setup.display.theme); }},
    {"units", [](VidValues& v, Reading& r) { v.oneOf<Units>(kUnits, r.setup.display.units); }},
    {"content_scale",
     [](VidValues& v, Reading& r) { v.number(kContentScale, r.setup.display.contentScale); }},
    {"glide", [](VidValues& v, Reading& r) { v.boolean(r.setup.display.glide); }},
    {"ghost_every",
     [](VidValues& v, Reading& r) { v.integer(kGhostEvery, r.setup.display.shown.ghostEvery); }},
    {"grid_step", [](VidValues& v, Reading& r) { v.number(kGridSteps, r.setup.display.gridStep); }},
    {"sizes", readSizes},
    {"shown", readShown},
    {"colours", readColours},
    {"import_up", readImportUp},
    {"layout",
     [](VidValues& v, Reading& r) {
       Extra ignored;
       v.object<Layout>(kLayoutMembers, r.setup.layout, ignored);
     }},
    {"view", [](VidValues& v, Reading& r) {
       Extra ignored;
       v.object<Setup>(kViewMembers, r.setup, ignored);
     }}};

template <class T, std::size_t N>
std::string_view nameOf(const VidValues::Choice<T> (&choices)[N], T value) {
  for (const auto& choice : choices) {
    if (choice.value == value) return choice.name;
  }
  return choices[0].name;
}

// An object with a member a line, as indented JSON.
class Writer {
 public:
  void text(std::string_view name, std::string_view value) {
    begin(name);
    appendJsonString(out_, value);
  }
  void number(std::string_view name, double value) {
    begin(name);
    appendJsonNumber(out_, value);
  }
  void boolean(std::string_view name, bool value) {
    begin(name);
    out_ += value ? "true" : "false";
  }
  void colour(std::string_view name, const Colour& c) {
    begin(name);
    out_ += '[';
    appendJsonNumber(out_, c.red);
    out_ += ", ";
    appendJsonNumber(out_, c.green);
    out_ += ", ";
    appendJsonNumber(out_, c.blue);
    out_ += ']';
  }
  template <class Members>
  void object(std::string_view name, Members members) {
    begin(name);
    open(members);
  }
  template <class Members>
  void open(Members members) {
    out_ += '{';
    ++depth_;
    first_ = true;
    members();
    --depth_;
    if (!first_) newLine();
    first_ = false;
    out_ += '}';
  }
  std::string take() { return std::move(out_) + "\n"; }

 private:
  void newLine() { (out_ += '\n').append(2 * depth_, ' '); }
  void begin(std::string_view name) {
    if (!first_) out_ += ',';
    first_ = false;
    newLine();
    appendJsonString(out_, name);
    out_ += ": ";
  }
  std::string out_;
  std::size_t depth_ = 0;
  bool first_ = true;
};

void writeShown(Writer& w, const Setup& setup) {
  Display display = setup.display;
  for (const std::string_view name : switchNames()) {
    if (name != kGlide) w.boolean(name, *switchOf(display, name));
  }
}

void writeLayout(Writer& w, const Layout& layout) {
  w.number("left", static_cast<double>(layout.left));
  w.number("right", static_cast<double>(layout.right));
  w.number("timeline", static_cast<double>(layout.timeline));
  w.boolean("left_shown", layout.leftShown);
  w.boolean("right_shown", layout.rightShown);
  w.boolean("timeline_shown", layout.timelineShown);
}

}  // namespace

ReadSetup readSetup(std::string_view text) {
  VidValues values(text);
  Reading reading;
  values.document([&] {
    Extra ignored;
    values.object<Reading>(kMembers, reading, ignored);
  });
  std::vector<Problem> problems = values.problems().take();
  std::erase_if(problems, [](const Problem& p) { return p.code == ProblemCode::kUnknownMember; });
  if (reading.version > kSetupVersion) {
    Problem newer;
    newer.code = ProblemCode::kNewerVersion;
    newer.pointer = "/version";
    newer.expected = expectVersion();
    newer.found = std::to_string(reading.version);
    problems = {newer};
  }
  if (!problems.empty()) return tl::unexpected(std::move(problems));
  return reading.setup;
}

ReadSetup readSetupFile(const std::string& path) {
  const auto text = readRegularFile(path, kSetupBytes);
  if (!text) return tl::unexpected(std::vector<Problem>{text.error()});
  return readSetup(*text);
}

std::string writeSetup(const Setup& setup) {
  const Display& display = setup.display;
  Writer w;
  w.open([&] {
    w.text("format", kFormat);
    w.number("version", kSetupVersion);
    w.text("language", nameOf(kLanguages, display.language));
    w.text("theme", nameOf(kThemes, display.theme));
    w.text("units", nameOf(kUnits, display.units));
    if (display.contentScale > 0.0) w.number("content_scale", display.contentScale);
    w.boolean(kGlide, display.glide);
    w.number("ghost_every", display.shown.ghostEvery);
    w.number("grid_step", display.gridStep);
    w.object("sizes", [&] {
      for (const ElementSize& size : kElementSizes) w.number(size.name, display.sizes.*size.size);
    });
    w.object("shown", [&] { writeShown(w, setup); });
    w.object("colours", [&] {
      for (std::size_t i = 0; i < kColourRoles; ++i) {
        if (display.colours[i]) w.colour(name(static_cast<ColourRole>(i)), *display.colours[i]);
      }
    });
    if (!setup.importUp.empty()) {
      w.object("import_up", [&] {
        for (const auto& [ending, axis] : setup.importUp) w.text(ending, name(axis));
      });
    }
    w.object("layout", [&] { writeLayout(w, setup.layout); });
    w.object("view", [&] {
      w.number("turn", setup.turn);
      w.number("tilt", setup.tilt);
      w.number("size", setup.size);
      w.boolean("perspective", setup.perspective);
    });
  });
  return w.take();
}

std::optional<Problem> saveSetup(const Setup& setup, const std::string& path) {
  if (auto why = obstacleToWriting(path)) return why;
  // What can't be made is told by the file that can't be opened in it.
  std::error_code ignored;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), ignored);
  AtomicFile file(path);
  file.write(writeSetup(setup));
  if (const auto done = file.commit(); !done) return problemOf(done.error());
  return std::nullopt;
}

}  // namespace vides
