// SPDX-License-Identifier: MIT
// The path of the VPN on the unit sphere, seen from the viewport's side, and the flight's measures.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "panels/quantities.hpp"
#include "panels/right_panels.hpp"

namespace vides {
namespace {

// The sphere turns with the viewport, without its pan, size and perspective.
struct SphereView {
  ImVec2 centre;
  float radius = 0.0f;
  Vec3 right{0.0}, up{0.0}, towards{0.0};

  SphereView(const EditorView& view, ImVec2 middle, float pixels) : centre(middle), radius(pixels) {
    const double turn = view.turn * std::numbers::pi / 180.0;
    const double tilt = view.tilt * std::numbers::pi / 180.0;
    right = {std::cos(turn), 0.0, -std::sin(turn)};
    towards = {std::sin(turn) * std::cos(tilt), std::sin(tilt), std::cos(turn) * std::cos(tilt)};
    up = glm::cross(towards, right);
  }
  ImVec2 place(const Vec3& v) const {
    return {centre.x + radius * static_cast<float>(glm::dot(v, right)),
            centre.y - radius * static_cast<float>(glm::dot(v, up))};
  }
  bool front(const Vec3& v) const { return glm::dot(v, towards) >= 0.0; }
};

// A circle of latitude, its front and back halves in their own strengths.
void latitude(ImDrawList& list, const SphereView& view, double degrees, ImU32 front, ImU32 back,
              float width) {
  constexpr int kSteps = 72;
  const double angle = degrees * std::numbers::pi / 180.0;
  Vec3 before{0.0};
  for (int i = 0; i <= kSteps; ++i) {
    const double around = 2.0 * std::numbers::pi * i / kSteps;
    const Vec3 at{std::cos(angle) * std::sin(around), std::sin(angle),
                  std::cos(angle) * std::cos(around)};
    if (i > 0) {
      const bool seen = view.front(0.5 * (at + before));
      list.AddLine(view.place(before), view.place(at), seen ? front : back, width);
    }
    before = at;
  }
}

constexpr float kMeasureRow = 19.0f;
constexpr float kPanelFoot = 16.0f;  // its lower padding and the gap to the next one

// With more keys the sphere shows where the path is dense, not each mark.
constexpr std::size_t kMostMarked = 400;

bool crowded(const Session& session) { return session.flight().keys.size() > kMostMarked; }

// Runs of the path that look the same are one polyline, so that joints have no dots.
void drawPath(Ui& ui, ImDrawList& list, const SphereView& view,
              const std::vector<FlightGraphs::PathPoint>& path, std::int64_t currentFirst,
              std::int64_t currentEnd, bool back, bool dense) {
  std::vector<ImVec2> run;
  bool runCurrent = false;
  const auto flush = [&] {
    if (run.size() > 1) {
      const ColourRole role = runCurrent ? ColourRole::kAccent : ColourRole::kAim;
      const double strength = (back ? 0.35 : 1.0) * (dense && !runCurrent ? 0.5 : 1.0);
      const float width = runCurrent ? 2.4f : dense ? 1.0f : 2.0f;
      list.AddPolyline(run.data(), static_cast<int>(run.size()), ui.colour(role, strength), 0,
                       width * ui.scale());
    }
    run.clear();
  };
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const auto& a = path[i];
    const auto& b = path[i + 1];
    const bool seen = view.front(0.5 * (a.direction + b.direction));
    const bool current = a.frame >= currentFirst && a.frame < currentEnd;
    if (seen == back) {
      flush();
      continue;
    }
    if (!run.empty() && current != runCurrent) flush();
    if (run.empty()) run.push_back(view.place(a.direction));
    runCurrent = current;
    run.push_back(view.place(b.direction));
  }
  flush();
}

// A circle at each orientation; of a long flight those of about as many keys as there is room for.
void drawMarks(Ui& ui, ImDrawList& list, const SphereView& view, const Session& session,
               bool back) {
  const KeyList& keys = session.flight().keys;
  const std::size_t step = keys.size() / kMostMarked + 1;
  const bool dense = crowded(session);
  const auto mark = [&](const OrientationPlace& place) {
    const Vec3 vpn = session.evaluation().cameraAt(place).viewPlaneNormal;
    if (view.front(vpn) == back) return;
    const bool current = place == session.current();
    const float radius = ui.scale() * (current ? 4.0f : dense ? 1.6f : 3.2f);
    const ImVec2 at = view.place(vpn);
    if (dense && !current) {
      list.AddCircleFilled(at, radius, ui.colour(ColourRole::kKey, back ? 0.35 : 0.85));
      return;
    }
    list.AddCircleFilled(at, radius, ui.colour(ColourRole::kHandleFill));
    list.AddCircle(at, radius,
                   ui.colour(current ? ColourRole::kAccent : ColourRole::kKey, back ? 0.45 : 1.0),
                   0, 1.5f * ui.scale());
  };
  for (std::size_t k = 0; k < keys.size(); k += step) {
    for (std::size_t o = 0; o < keys[k].orientations.size(); ++o) mark({k, o});
  }
  // Over the others, and also where its key is not among those marked.
  if (dense) mark(session.current());
}

// The orientation in front that is seen nearest to a place, if it is nearer than `reach` pixels.
std::optional<OrientationPlace> orientationAt(const SphereView& view, const Session& session,
                                              const ImVec2& place, float reach) {
  std::optional<OrientationPlace> nearest;
  const auto look = [&](const OrientationPlace& candidate) {
    const Vec3 vpn = session.evaluation().cameraAt(candidate).viewPlaneNormal;
    const ImVec2 at = view.place(vpn);
    const float distance = std::hypot(at.x - place.x, at.y - place.y);
    if (!view.front(vpn) || distance >= reach) return;
    reach = distance;
    nearest = candidate;
  };
  const KeyList& keys = session.flight().keys;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    for (std::size_t o = 0; o < keys[k].orientations.size(); ++o) look({k, o});
  }
  return nearest;
}

}  // namespace

void spherePanel(Ui& ui, Stack& column, float bottom, const Session& session, FlightGraphs& graphs,
                 Actions& actions) {
  panel(ui, column, "panel/sphere", [&](Stack& rows) {
    const float height = std::floor((bottom - rows.y()) / ui.scale()) - kPanelFoot;
    const float side = std::min(rows.width() / ui.scale(), std::clamp(height, 128.0f, 320.0f));
    const Rect room = rows.row(side);
    const auto state = ui.area("camera/sphere", room);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const SphereView view(session.view().view, {room.centreX(), room.centreY()},
                          room.height / 2.0f - ui.px(4));
    list.AddCircleFilled(view.centre, view.radius, ui.colour(ColourRole::kField));
    const ImU32 front = ui.colour(ColourRole::kCube, 0.45);
    const ImU32 back = ui.colour(ColourRole::kCube, 0.16);
    for (const double degrees : {-60.0, -30.0, 0.0, 30.0, 60.0}) {
      latitude(list, view, degrees, front, back, std::max(1.0f, ui.scale() * 0.9f));
    }
    list.AddCircle(view.centre, view.radius, ui.colour(ColourRole::kCube, 0.7), 0,
                   std::max(1.0f, ui.scale()));
    const auto section = session.evaluation().sectionFrom(session.current());
    const std::int64_t first = section ? section->firstFrame : 0;
    const std::int64_t end = section ? first + section->frames : 0;
    const bool dense = crowded(session);
    drawPath(ui, list, view, graphs.path(), first, end, true, dense);
    drawMarks(ui, list, view, session, true);
    drawPath(ui, list, view, graphs.path(), first, end, false, dense);
    drawMarks(ui, list, view, session, false);
    // Where the camera looks at the playhead.
    const Vec3 now = session.camera().viewPlaneNormal;
    const ImU32 ink = ui.colour(ColourRole::kPlayhead, view.front(now) ? 1.0 : 0.5);
    list.AddCircleFilled(view.place(now), 3.0f * ui.scale(), ink);
    if (!state.released) return;
    // A click makes the orientation under the pointer current.
    const auto nearest = orientationAt(view, session, ImGui::GetIO().MousePos, ui.px(8));
    if (nearest) actions.run(Command("make-current", nearest->key, nearest->orientation));
  });
}

float measuresPanelHeight(const Ui& ui) { return panelHeight(ui) + 4 * ui.px(kMeasureRow); }

void measuresPanel(Ui& ui, Stack& column, const Session& session, FlightGraphs& graphs) {
  const float top = column.y();
  const LengthUnit unit = lengthUnit(ui, session);
  panel(ui, column, "panel/measures", [&](Stack& rows) {
    const auto& quality = graphs.quality();
    const std::string waiting = "\u2026";
    // With the unit's name where there is room; the caption has it, too.
    const auto row = [&](const char* id, const std::string& value, const std::string& longer) {
      const float room = rows.width() - ui.textWidth(ui.words(id)) - ui.px(8);
      const bool fits = ui.textWidth(longer, Weight::kSemibold) <= room;
      ui.valueRow(rows.row(kMeasureRow), id, ui.words(id), fits ? longer : value);
    };
    const double seconds =
        static_cast<double>(session.evaluation().frameCount()) / session.flight().frameRate;
    const std::string length = measured(ui, session.evaluation().length() * unit.perCube);
    row("measures/length", length, withUnit(length, unit.brief));
    const std::string duration = timeText(ui, seconds, seconds, 2);
    row("measures/duration", duration, duration);
    const std::string speed =
        quality ? measured(ui, quality->maxSpeed * unit.perCube) : std::string();
    row("measures/speed", quality ? speed + " /s" : waiting,
        quality ? withUnit(speed, unit.brief + "/s") : waiting);
    const std::string turning =
        quality ? withUnit(ui.number(quality->maxAngularSpeed, 1), "\u00b0/s") : waiting;
    row("measures/turn_rate", turning, turning);
  });
  const Rect heading{column.x() + ui.px(8), top + ui.px(4), column.width() - ui.px(16), ui.px(24)};
  ui.text(heading, unit.whole, {.colour = ColourRole::kTextSecondary, .align = Align::kRight});
}

}  // namespace vides
