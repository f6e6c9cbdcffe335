// SPDX-License-Identifier: MIT
// The document: a flight and its parts as plain values (3-vid-format).
//
// Positions and aims are in cube coordinates, the working space [-1, 1]^3; `space` maps them to
// scene units. Angles are degrees, times seconds. Defaults are those of the file format. Nothing
// here is evaluated, and nothing evaluated is stored here. Copies share their keys.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "flight/orientation_method.hpp"
#include "flight/shared_sequence.hpp"
#include "math/kochanek_bartels.hpp"
#include "math/lens.hpp"
#include "math/speed_curve.hpp"
#include "math/vector.hpp"

namespace vides {

// Members of the file that vides doesn't know (names that begin with "x_"), kept as they were: the
// name's JSON text, with its quotes, and the value's. Null where there are none.
using ExtraMembers = std::vector<std::pair<std::string, std::string>>;
using Extra = std::shared_ptr<const ExtraMembers>;
bool sameExtra(const Extra& a, const Extra& b);

enum class AimMode { kAbsolute, kRelative };

// Aim, roll, zoom, and the speed curve, duration and hold of the section that it begins.
struct Orientation {
  Vec3 aim{0.0};  // cube coordinates, or the offset from the key
  AimMode aimMode = AimMode::kAbsolute;
  double roll = 0.0;   // degrees, -36,000 to 36,000
  double zoom = 12.0;  // 1 to 100
  SpeedValues speed{50, 50, 50, 50, 50, 50, 50, 50, 50, 50};
  std::optional<double> duration;  // seconds; overrides the rate
  double hold = 0.0;               // seconds of rest before the section
  Extra extra;
  bool operator==(const Orientation& other) const;
};

// Either one of the flight's presets or the key's own.
struct KeyShape {
  static constexpr int kOwn = -1;
  int preset = 0;  // 0 to 9, or kOwn
  Shape own;       // counts where preset == kOwn
  Extra extra;
  bool operator==(const KeyShape& other) const;
};

// A position that the curve passes through, with 1 to 10 orientations.
struct Key {
  Vec3 position{0.0};
  KeyShape shape;
  std::vector<Orientation> orientations{Orientation{}};
  Extra extra;
  bool operator==(const Key& other) const;
};

// Keys are immutable and shared between the copies of a flight. Compares by value, quickly where
// the key is the same object.
class KeyPointer {
 public:
  KeyPointer() = default;
  explicit KeyPointer(Key key) : key_(std::make_shared<const Key>(std::move(key))) {}
  const Key& operator*() const { return *key_; }
  const Key* operator->() const { return key_.get(); }
  bool operator==(const KeyPointer& other) const {
    return key_ == other.key_ || (key_ && other.key_ && *key_ == *other.key_);
  }

 private:
  std::shared_ptr<const Key> key_;
};

struct KeySummary {
  std::size_t orientations = 0;
  static KeySummary of(const KeyPointer& key) { return {key->orientations.size()}; }
  KeySummary operator+(const KeySummary& o) const { return {orientations + o.orientations}; }
  std::int64_t index() const { return static_cast<std::int64_t>(orientations); }
};

// The keys of a flight in order. Copies are O(1), edits O(log n).
class KeyList {
 public:
  using Sequence = SharedSequence<KeyPointer, KeySummary>;

  KeyList() = default;
  KeyList(std::initializer_list<Key> keys);
  explicit KeyList(const std::vector<KeyPointer>& keys) : sequence_(keys) {}

  std::size_t size() const { return sequence_.size(); }
  bool empty() const { return sequence_.empty(); }
  const Key& operator[](std::size_t i) const { return *sequence_[i]; }
  const Key& front() const { return *sequence_.front(); }
  const Key& back() const { return *sequence_.back(); }
  // All orientations of all keys, and those of the keys [0, i).
  std::size_t orientations() const { return sequence_.summary().orientations; }
  std::size_t orientationsBefore(std::size_t i) const {
    return sequence_.summaryBefore(i).orientations;
  }

  void set(std::size_t i, Key key) { sequence_.set(i, KeyPointer(std::move(key))); }
  void insert(std::size_t i, Key key) { sequence_.insert(i, KeyPointer(std::move(key))); }
  void erase(std::size_t i) { sequence_.erase(i); }
  void push_back(Key key) { insert(size(), std::move(key)); }

  // visit(const Key&) for the keys [first, last).
  template <class Visit>
  void forEach(std::size_t first, std::size_t last, Visit visit) const {
    sequence_.forEach(first, last, [&](const KeyPointer& key) { visit(*key); });
  }
  template <class Visit>
  void forEach(Visit visit) const {
    forEach(0, size(), visit);
  }
  const Sequence& sequence() const { return sequence_; }
  bool operator==(const KeyList& other) const = default;

 private:
  Sequence sequence_;
};

// The size of the film's pictures. (A picture's pixels are render's Picture.)
struct PictureFormat {
  int width = 1920;  // pixels
  int height = 1080;
  bool operator==(const PictureFormat&) const = default;
};

// world = center + halfSize * cube.
struct Space {
  Vec3 center{0.0};
  double halfSize = 1.0;
  Vec3 toWorld(const Vec3& cube) const { return center + halfSize * cube; }
  Vec3 toCube(const Vec3& world) const { return (world - center) / halfSize; }
  bool operator==(const Space&) const = default;
};

// Frames per unit of change at base speed.
struct Rates {
  double move = 100.0;  // frames per cube unit of arc length
  double pan = 100.0;   // frames per 90 degrees of half the rotation angle
  double roll = 100.0;  // frames per 90 degrees of roll
  double zoom = 100.0;  // frames per 99 steps of zoom
  bool operator==(const Rates&) const = default;
};

struct SceneFile {
  std::string file;  // relative to the flight's folder where such a path exists
  Extra extra;
  bool operator==(const SceneFile& other) const;
};

inline constexpr std::size_t kPresets = 10;
inline constexpr std::size_t kMostOrientations = 10;
// The paper's ten (A.6.1).
std::array<Shape, kPresets> paperPresets();

struct Flight {
  std::string name;
  double frameRate = 25.0;  // frames per second
  PictureFormat picture;
  Lens lens;
  Space space;
  Rates rates;
  bool closed = false;  // after the last key the flight goes on to the first
  const OrientationMethod* orientationCurve = orientationMethods().front();  // never null
  std::array<Shape, kPresets> presets = paperPresets();
  KeyList keys;
  std::vector<SceneFile> scene;

  // Unknown members of the document and of its small objects.
  struct Extras {
    Extra flight, picture, lens, space, rates;
    std::array<Extra, kPresets> presets;
    bool operator==(const Extras& other) const;
  };
  Extras extras;

  bool operator==(const Flight& other) const = default;
};

// What File > New makes: keys (-0.5, 0.2, 0.8) and (0.5, 0.2, 0.8) that aim at the origin.
Flight newFlight();

// The shape that holds at a key: its own or its preset's.
const Shape& shapeOf(const Flight& flight, const Key& key);
// Where the aim is, in cube coordinates.
Vec3 aimPoint(const Key& key, const Orientation& orientation);
// From the key to the aim.
Vec3 aimOffset(const Key& key, const Orientation& orientation);
// Sets the aim, given in cube coordinates, in the orientation's own mode.
void setAimPoint(const Key& key, Orientation& orientation, const Vec3& point);

}  // namespace vides
