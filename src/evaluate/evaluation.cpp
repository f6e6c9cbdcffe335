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

// Where frame n falls: an orientation's hold, or the section that it begins.
struct FramePlace {
  OrientationPlace place;
  std::int32_t entries = 0;  // before the hold or section
  std::int64_t step = 0;     // from its first frame
  std::int64_t frames = 0;   // that it has
  bool inHold = false;
  const KeyRecord* record = nullptr;

  double tau() const { return static_cast<double>(step) / static_cast<double>(frames); }
};

FramePlace findFrame(const EvaluationTree& tree, std::int64_t n) {
  const auto found = tree.findIndex(n);
  FramePlace at;
  at.place.key = found.index;
  at.entries = found.before.entries;
  const KeyRecord& record = **found.item;
  at.record = &record;
  fetch(found.item->piece(), sizeof(CurvePiece));
  fetch(&record, sizeof(KeyRecord));
  FrameSum sum = found.before.frames;
  std::int64_t start = sum.frames();
  // Whether frame n falls into what adds `part`.
  const auto enter = [&](const FrameSum& part) {
    sum = sum + part;
    const std::int64_t end = sum.frames();
    at.step = n - start;
    at.frames = end - start;
    start = end;
    return n < end;
  };
  while (true) {
    const SectionRecord& s = record.sections[at.place.orientation];
    if (s.holds()) {
      at.inHold = enter(s.ofHold());
      if (at.inHold) return at;
      ++at.entries;
    }
    if (s.exists) {
      if (enter(s.ofSection())) return at;
      ++at.entries;
    }
    ++at.place.orientation;
  }
}

// The sum over all that stands before an orientation's hold.
RecordSummary summaryBefore(const EvaluationTree& tree, const OrientationPlace& place) {
  RecordSummary sum = tree.summaryBefore(place.key);
  const KeyRecord& record = *tree[place.key];
  for (std::size_t j = 0; j < place.orientation; ++j) sum = sum + RecordSummary::of(record, j);
  return sum;
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
  const std::int64_t frames = tree.summary().index();
  return flight.closed ? std::max<std::int64_t>(frames, 1) : frames + 1;
}

OrientationPlace Evaluation::State::lastPlace() const {
  return {tree.size() - 1, tree.back()->sections.size() - 1};
}

Section Evaluation::State::entryAt(const OrientationPlace& place, bool inHold) const {
  const RecordSummary before = summaryBefore(tree, place);
  const KeyRecord& record = *tree[place.key];
  const SectionRecord& s = record.sections[place.orientation];
  const FrameSum afterHold = before.frames + s.ofHold();
  Section section;
  section.from = section.to = place;
  if (inHold) {
    section.index = indexAfter(before.entries);
    section.firstFrame = before.frames.frames();
    section.frames = afterHold.frames() - section.firstFrame;
    return section;
  }
  section.index = indexAfter(before.entries + (s.holds() ? 1 : 0));
  section.firstFrame = afterHold.frames();
  section.frames = (afterHold + s.ofSection()).frames() - section.firstFrame;
  section.kind = s.kind;
  section.to = chain().after(place);
  section.length = record.lengthOf(s);
  section.angle = 2.0 * halfRotationAngle(s.q, s.qEnd) * kDegrees;
  return section;
}

const OrientationPath& pathOf(const Chain& chain, const OrientationPlace& place,
                              const SectionRecord& section, OrientationPath& made) {
  if (!section.signsDependOnChain) return section.path;
  const Neighbours beside = chain.neighbours(place);
  if (chain.linkSigns(place, beside) == section.signs) return section.path;
  made = makeOrientationPath(chain.pathInput(place, beside));
  return made;
}

Camera cameraAtStart(const KeyRecord& record, const SectionRecord& section) {
  const ViewDirection view = viewDirection(section.q);
  return {record.position, view.viewPlaneNormal, view.viewUpVector, section.zoom};
}

Camera cameraInSection(const KeyRecord& record, const SectionRecord& section,
                       const OrientationPath& path, double tau) {
  if (tau == 0.0) return cameraAtStart(record, section);
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
  const ViewDirection view = path.at(progress, camera.viewReferencePoint);
  camera.viewPlaneNormal = view.viewPlaneNormal;
  camera.viewUpVector = view.viewUpVector;
  camera.zoom = section.zoom + progress * (section.zoomEnd - section.zoom);
  return camera;
}

Evaluation::Evaluation() : Evaluation(newFlight()) {}

Evaluation::Evaluation(const Flight& flight)
    : state_(std::make_shared<const State>(flight, buildTree(flight))) {}

Evaluation Evaluation::updated(const Flight& flight) const {
  return Evaluation(
      std::make_shared<const State>(flight, updateTree(state_->tree, state_->flight, flight)));
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
  if (n >= tree.summary().index()) {
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
  frame.section = state_->indexAfter(at.entries);
  if (at.inHold) {
    frame.camera = cameraAtStart(record, s);
    return frame;
  }
  OrientationPath made;
  frame.kind = s.kind;
  frame.camera = cameraInSection(record, s, pathOf(chain, at.place, s, made), at.tau());
  return frame;
}

Camera Evaluation::cameraBetween(double position) const {
  if (!(position > 0.0)) return frame(0).camera;
  if (position >= static_cast<double>(state_->tree.summary().index())) {
    return frame(frameCount() - 1).camera;
  }
  const auto n = static_cast<std::int64_t>(position);
  const FramePlace at = findFrame(state_->tree, n);
  const SectionRecord& s = at.record->sections[at.place.orientation];
  if (at.inHold) return cameraAtStart(*at.record, s);
  OrientationPath made;
  const double step = static_cast<double>(at.step) + (position - static_cast<double>(n));
  return cameraInSection(*at.record, s, pathOf(state_->chain(), at.place, s, made),
                         step / static_cast<double>(at.frames));
}

std::int64_t Evaluation::sectionCount() const {
  return state_->indexAfter(state_->tree.summary().entries);
}

Section Evaluation::section(std::int64_t index) const {
  // Also counting the holds that vanish, so many entries stand before it.
  const auto entries = state_->vanished.entriesBefore(index, state_->tree);
  const auto found =
      state_->tree.find([&](const RecordSummary& sum) { return sum.entries > entries; });
  std::int64_t left = entries - found.before.entries;
  OrientationPlace place{found.index, 0};
  while (true) {
    const SectionRecord& s = (*found.item)->sections[place.orientation];
    if (s.holds() && left-- == 0) return state_->entryAt(place, true);
    if (s.exists && left-- == 0) break;
    ++place.orientation;
  }
  return state_->entryAt(place, false);
}

std::optional<Section> Evaluation::sectionAtFrame(std::int64_t n) const {
  const std::int64_t frames = state_->tree.summary().index();
  if (frames == 0) return std::nullopt;
  const FramePlace at = findFrame(state_->tree, std::clamp<std::int64_t>(n, 0, frames - 1));
  return state_->entryAt(at.place, at.inHold);
}

std::optional<Section> Evaluation::sectionFrom(const OrientationPlace& place) const {
  if (!state_->chain().at(place).exists) return std::nullopt;
  return state_->entryAt(place, false);
}

std::optional<Section> Evaluation::holdBefore(const OrientationPlace& place) const {
  if (!state_->chain().at(place).holds()) return std::nullopt;
  const Section hold = state_->entryAt(place, true);
  return hold.frames > 0 ? std::optional(hold) : std::nullopt;
}

double Evaluation::length() const {
  return std::ldexp(static_cast<double>(state_->tree.summary().length), -60);
}

std::int64_t Evaluation::frameOf(const OrientationPlace& place) const {
  return std::min(summaryBefore(state_->tree, place).index(), frameCount() - 1);
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

Evaluation::Beyond Evaluation::before(const OrientationPlace& place) const {
  const Chain chain = state_->chain();
  const Neighbours beside = chain.neighbours(place);
  return {beside.previous, chain.restsBefore(place, beside)};
}

Evaluation::Beyond Evaluation::after(const OrientationPlace& place) const {
  const Chain chain = state_->chain();
  const Neighbours beside = chain.neighbours(place);
  return {beside.next, chain.restsAfter(place, beside)};
}

std::int64_t Evaluation::idleTurns(const OrientationPlace& place) const {
  const Chain chain = state_->chain();
  const OrientationPlace end = next(place);
  if (end == place || chain.at(place).kind != SectionKind::kHold) return 0;
  return std::llround(std::abs(chain.at(end).roll - chain.at(place).roll) / 360.0);
}

}  // namespace vides
