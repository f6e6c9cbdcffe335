// SPDX-License-Identifier: MIT
// Answers from the tree of records: frames by number, sections, the curve.
#include "evaluate/evaluation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "evaluate/builder.hpp"
#include "evaluate/evaluation_state.hpp"
#include "flight/fetch.hpp"
#include "math/quaternion.hpp"

namespace vides {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

// Sums inside one record, up to an orientation.
struct Inside {
  std::int64_t frames = 0;
  std::int64_t entries = 0;
};

Inside insideBefore(const KeyRecord& record, std::size_t orientation) {
  Inside sum;
  for (std::size_t j = 0; j < orientation; ++j) {
    const SectionRecord& s = record.sections[j];
    sum.frames += s.holdFrames + (s.exists ? s.frames : 0);
    sum.entries += (s.holdFrames > 0 ? 1 : 0) + (s.exists ? 1 : 0);
  }
  return sum;
}

// Where frame n falls: an orientation's hold, or the section that it begins.
struct FramePlace {
  OrientationPlace place;
  std::int64_t entry = 0;  // of the hold or section
  std::int64_t step = 0;   // from its first frame
  bool inHold = false;
  const KeyRecord* record = nullptr;
};

FramePlace findFrame(const EvaluationTree& tree, std::int64_t n) {
  const auto found = tree.findIndex(n);
  FramePlace at;
  at.place.key = found.index;
  at.entry = found.before.entries;
  std::int64_t left = n - found.before.frames;
  const KeyRecord& record = **found.item;
  at.record = &record;
  fetch(found.item->piece(), sizeof(CurvePiece));
  fetch(&record, sizeof(KeyRecord));
  while (true) {
    const SectionRecord& s = record.sections[at.place.orientation];
    if (left < s.holdFrames) {
      at.step = left;
      at.inHold = true;
      return at;
    }
    left -= s.holdFrames;
    at.entry += s.holdFrames > 0 ? 1 : 0;
    if (s.exists) {
      if (left < s.frames) break;
      left -= s.frames;
      ++at.entry;
    }
    ++at.place.orientation;
  }
  at.step = left;
  return at;
}

}  // namespace

std::string_view name(SectionKind kind) {
  switch (kind) {
    case SectionKind::kMove:
      return "move";
    case SectionKind::kPan:
      return "pan";
    case SectionKind::kRoll:
      return "roll";
    case SectionKind::kZoom:
      return "zoom";
    case SectionKind::kHold:
      break;
  }
  return "hold";
}

std::int64_t Evaluation::State::frameCount() const {
  const std::int64_t frames = tree.summary().frames;
  return flight.closed ? std::max<std::int64_t>(frames, 1) : frames + 1;
}

OrientationPlace Evaluation::State::lastPlace() const {
  return {tree.size() - 1, tree.back()->sections.size() - 1};
}

Section Evaluation::State::entryAt(const OrientationPlace& place, bool inHold) const {
  const RecordSummary before = tree.summaryBefore(place.key);
  const KeyRecord& record = *tree[place.key];
  const Inside inside = insideBefore(record, place.orientation);
  const SectionRecord& s = record.sections[place.orientation];
  Section section;
  section.index = before.entries + inside.entries;
  section.firstFrame = before.frames + inside.frames;
  section.from = section.to = place;
  section.frames = s.holdFrames;
  if (inHold) return section;
  if (s.holdFrames > 0) ++section.index;
  section.firstFrame += s.holdFrames;
  section.kind = s.kind;
  section.to = chain().after(place);
  section.length = record.lengthOf(s);
  section.angle = 2.0 * halfRotationAngle(s.q, s.qEnd) * kDegrees;
  section.frames = s.frames;
  return section;
}

const OrientationPath& pathOf(const Chain& chain, const OrientationPlace& place,
                              const SectionRecord& section, OrientationPath& made) {
  if (!section.signsDependOnChain) return section.path;
  const Neighbours beside = chain.neighbours(place);
  if (chain.linkSigns(place, beside) == section.signs) return section.path;
  made = chain.method().make(chain.pathInput(place, beside));
  return made;
}

Camera cameraAtStart(const KeyRecord& record, const SectionRecord& section) {
  const ViewDirection view = viewDirection(section.q);
  return {record.position, view.viewPlaneNormal, view.viewUpVector, section.zoom};
}

Camera cameraInSection(const KeyRecord& record, const SectionRecord& section,
                       const OrientationPath& path, double step) {
  if (step == 0.0) return cameraAtStart(record, section);
  const double tau = step / static_cast<double>(section.frames);
  const double progress = section.speed.progress(tau);
  Camera camera;
  if (section.kind == SectionKind::kMove) {
    const CurvePiece& piece = *record.piece;
    camera.viewReferencePoint =
        piece.curve.point(piece.arc.parameterAt(piece.curve, progress * piece.length));
  } else {
    camera.viewReferencePoint =
        record.position + progress * (section.positionEnd - record.position);
  }
  const ViewDirection view = path.at({progress, camera.viewReferencePoint});
  camera.viewPlaneNormal = view.viewPlaneNormal;
  camera.viewUpVector = view.viewUpVector;
  camera.zoom = section.zoom + progress * (section.zoomEnd - section.zoom);
  return camera;
}

Evaluation::Evaluation() : Evaluation(newFlight()) {}

Evaluation::Evaluation(const Flight& flight)
    : state_(std::make_shared<const State>(State{flight, buildTree(flight)})) {}

Evaluation Evaluation::updated(const Flight& flight) const {
  return Evaluation(std::make_shared<const State>(
      State{flight, updateTree(state_->tree, state_->flight, flight)}));
}

const Flight& Evaluation::flight() const { return state_->flight; }
std::int64_t Evaluation::frameCount() const { return state_->frameCount(); }

Frame Evaluation::frame(std::int64_t n) const {
  const EvaluationTree& tree = state_->tree;
  n = std::clamp<std::int64_t>(n, 0, frameCount() - 1);
  Frame frame;
  frame.number = n;
  frame.time = static_cast<double>(n) / state_->flight.frameRate;
  const Chain chain = state_->chain();
  if (n >= tree.summary().frames) {
    // The one last frame of an open flight, or the only one of a flight without sections.
    const OrientationPlace last = state_->flight.closed ? OrientationPlace{} : state_->lastPlace();
    frame.camera = cameraAt(last);
    if (const std::int64_t entries = sectionCount(); entries > 0) {
      frame.section = entries - 1;
      frame.kind = section(entries - 1).kind;
    }
    return frame;
  }
  const FramePlace at = findFrame(tree, n);
  const KeyRecord& record = *at.record;
  const SectionRecord& s = record.sections[at.place.orientation];
  frame.section = at.entry;
  if (at.inHold) {
    frame.camera = cameraAtStart(record, s);
    return frame;
  }
  OrientationPath made;
  frame.kind = s.kind;
  frame.camera =
      cameraInSection(record, s, pathOf(chain, at.place, s, made), static_cast<double>(at.step));
  return frame;
}

Camera Evaluation::cameraBetween(double position) const {
  if (!(position > 0.0)) return frame(0).camera;
  if (position >= static_cast<double>(state_->tree.summary().frames)) {
    return frame(frameCount() - 1).camera;
  }
  const auto n = static_cast<std::int64_t>(position);
  const FramePlace at = findFrame(state_->tree, n);
  const SectionRecord& s = at.record->sections[at.place.orientation];
  if (at.inHold) return cameraAtStart(*at.record, s);
  OrientationPath made;
  return cameraInSection(*at.record, s, pathOf(state_->chain(), at.place, s, made),
                         static_cast<double>(at.step) + (position - static_cast<double>(n)));
}

std::int64_t Evaluation::sectionCount() const { return state_->tree.summary().entries; }

Section Evaluation::section(std::int64_t index) const {
  const auto found =
      state_->tree.find([&](const RecordSummary& sum) { return sum.entries > index; });
  std::int64_t left = index - found.before.entries;
  OrientationPlace place{found.index, 0};
  while (true) {
    const SectionRecord& s = (*found.item)->sections[place.orientation];
    if (s.holdFrames > 0 && left-- == 0) return state_->entryAt(place, true);
    if (s.exists && left-- == 0) break;
    ++place.orientation;
  }
  return state_->entryAt(place, false);
}

std::optional<Section> Evaluation::sectionAtFrame(std::int64_t n) const {
  const std::int64_t frames = state_->tree.summary().frames;
  if (frames == 0) return std::nullopt;
  const FramePlace at = findFrame(state_->tree, std::clamp<std::int64_t>(n, 0, frames - 1));
  return state_->entryAt(at.place, at.inHold);
}

std::optional<Section> Evaluation::sectionFrom(const OrientationPlace& place) const {
  if (!state_->chain().at(place).exists) return std::nullopt;
  return state_->entryAt(place, false);
}

double Evaluation::length() const {
  return std::ldexp(static_cast<double>(state_->tree.summary().length), -60);
}

std::int64_t Evaluation::frameOf(const OrientationPlace& place) const {
  const std::int64_t before = state_->tree.summaryBefore(place.key).frames;
  const std::int64_t inside = insideBefore(*state_->tree[place.key], place.orientation).frames;
  return std::min(before + inside, frameCount() - 1);
}

Camera Evaluation::cameraAt(const OrientationPlace& place) const {
  const KeyRecord& record = *state_->tree[place.key];
  return cameraAtStart(record, record.sections[place.orientation]);
}

OrientationPlace Evaluation::next(const OrientationPlace& place) const {
  if (!state_->flight.closed && place == state_->lastPlace()) return place;
  return state_->chain().after(place);
}

std::size_t Evaluation::pieceCount() const {
  return state_->flight.closed ? state_->tree.size() : state_->tree.size() - 1;
}

const CubicSegment& Evaluation::piece(std::size_t k) const { return state_->tree[k]->piece->curve; }
double Evaluation::pieceLength(std::size_t k) const { return state_->tree[k]->piece->length; }

double Evaluation::pieceParameter(std::size_t k, double fraction) const {
  const CurvePiece& piece = *state_->tree[k]->piece;
  if (!(piece.length > 0.0)) return std::clamp(fraction, 0.0, 1.0);
  return piece.arc.parameterAt(piece.curve, fraction * piece.length);
}

Vec3 Evaluation::piecePoint(std::size_t k, double fraction) const {
  return piece(k).point(pieceParameter(k, fraction));
}

const void* Evaluation::pieceIdentity(std::size_t k) const { return state_->tree[k]->piece.get(); }

void Evaluation::forEachPiece(std::size_t first, std::size_t last,
                              const PieceVisitor& visit) const {
  std::size_t k = first;
  state_->tree.forEach(first, std::min(last, pieceCount()), [&](const RecordPointer& record) {
    visit(k++, record.piece(), record.piece()->curve);
  });
}

std::vector<Evaluation::PieceRange> Evaluation::changedPieces(const Evaluation& other) const {
  assert(other.state_->tree.size() == state_->tree.size());
  std::vector<PieceRange> ranges;
  for (const auto& change : EvaluationTree::changes(other.state_->tree, state_->tree)) {
    const std::size_t last = std::min(change.newLast, pieceCount());
    if (change.first < last) ranges.push_back({change.first, last});
  }
  return ranges;
}

const SpeedCurve& Evaluation::speedCurve(const OrientationPlace& place) const {
  return state_->tree[place.key]->sections[place.orientation].speed;
}

std::optional<double> Evaluation::speedBefore(const OrientationPlace& place) const {
  return state_->chain().speedBefore(place);
}

std::optional<double> Evaluation::speedAfter(const OrientationPlace& place) const {
  return state_->chain().speedAfter(place);
}

}  // namespace vides
