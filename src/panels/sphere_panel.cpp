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
// So that a mark on the rim is whole.
constexpr float kRim = 8.0f;

// Pixels between what is drawn of the path and the exact one, at most.
constexpr float kPathError = 0.5f;
constexpr float kDraggedPathError = 2.0f;
// A line that turns back sharper than this is cut: its joint would be a spike.
constexpr float kSharp = -0.2f;  // cosine

struct Stroke {
  ColourRole role;
  float width;  // at content scale 1
  double strength;
};

// The parts of the lines that lie in front, or at the back.
void drawLines(Ui& ui, ImDrawList& list, const SphereView& view,
               const std::vector<std::vector<Vec3>>& lines, bool back, const Stroke& stroke) {
  const ImU32 ink = ui.colour(stroke.role, stroke.strength);
  std::vector<ImVec2> run;
  const auto flush = [&] {
    if (run.size() > 1) {
      list.AddPolyline(run.data(), static_cast<int>(run.size()), ink, 0, stroke.width * ui.scale());
    }
    run.clear();
  };
  const auto add = [&](const ImVec2& from, const ImVec2& to) {
    if (run.empty()) run.push_back(from);
    const ImVec2 next(to.x - run.back().x, to.y - run.back().y);
    const float length = std::hypot(next.x, next.y);
    // What moves by less than that is not seen.
    if (length < 0.25f) return;
    if (run.size() > 1) {
      const ImVec2& before = run[run.size() - 2];
      const ImVec2 way(run.back().x - before.x, run.back().y - before.y);
      if (way.x * next.x + way.y * next.y < kSharp * length * std::hypot(way.x, way.y)) {
        const ImVec2 joint = run.back();
        flush();
        run.push_back(joint);
      }
    }
    run.push_back(to);
  };
  for (const std::vector<Vec3>& line : lines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      if (view.front(line[i] + line[i + 1]) == back) {
        flush();
      } else {
        add(view.place(line[i]), view.place(line[i + 1]));
      }
    }
    flush();
  }
}

// A circle at each orientation; of a long flight those of about as many keys as there is room for.
void drawMarks(Ui& ui, ImDrawList& list, const SphereView& view, const SpherePath& path,
               bool back) {
  for (const SpherePath::Mark& mark : path.marks()) {
    if (view.front(mark.direction) == back) continue;
    const ImVec2 at = view.place(mark.direction);
    if (path.thinned()) {
      list.AddCircleFilled(at, 1.6f * ui.scale(), ui.colour(ColourRole::kKey, back ? 0.35 : 0.85));
      continue;
    }
    list.AddCircleFilled(at, 3.2f * ui.scale(), ui.colour(ColourRole::kHandleFill));
    list.AddCircle(at, 3.2f * ui.scale(), ui.colour(ColourRole::kKey, back ? 0.45 : 1.0), 0,
                   1.5f * ui.scale());
  }
}

// The current section, dark around so that it is found among others.
void drawCurrentLines(Ui& ui, ImDrawList& list, const SphereView& view, const SpherePath& path,
                      bool back) {
  const auto& lines = path.currentLines();
  drawLines(ui, list, view, lines, back, {ColourRole::kField, 5.6f, back ? 0.5 : 0.8});
  drawLines(ui, list, view, lines, back, {ColourRole::kAccent, 2.4f, back ? 0.45 : 1.0});
}

void drawCurrentMark(Ui& ui, ImDrawList& list, const ImVec2& at, bool back) {
  list.AddCircleFilled(at, 4.0f * ui.scale(), ui.colour(ColourRole::kHandleFill));
  list.AddCircle(at, 4.0f * ui.scale(), ui.colour(ColourRole::kAccent, back ? 0.45 : 1.0), 0,
                 1.8f * ui.scale());
}

// Path, marks and what is current: those at the back, then those in front, the current ones last.
void drawOrientations(Ui& ui, ImDrawList& list, const SphereView& view, const SpherePath& path,
                      const Vec3& current) {
  const bool thin = path.thinned();
  const ImVec2 at = view.place(current);
  for (const bool back : {true, false}) {
    const bool here = view.front(current) != back;
    drawLines(ui, list, view, path.lines(), back,
              {ColourRole::kAim, thin ? 1.0f : 2.0f, (back ? 0.35 : 1.0) * (thin ? 0.6 : 1.0)});
    // A few marks are drawn over its ends, many would hide it.
    if (thin) drawMarks(ui, list, view, path, back);
    if (here) list.AddCircleFilled(at, 6.5f * ui.scale(), ui.colour(ColourRole::kField, 0.8));
    drawCurrentLines(ui, list, view, path, back);
    if (!thin) drawMarks(ui, list, view, path, back);
    if (here) drawCurrentMark(ui, list, at, back);
  }
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
    const float height = std::floor(bottom - panelFoot(ui) - rows.y());
    const float side = std::min(rows.width(), std::clamp(height, leastSphere(ui), mostSphere(ui)));
    const Rect room = rows.room(side);
    const auto state = ui.area("camera/sphere", room);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const SphereView view(session.view().view, {room.centreX(), room.centreY()},
                          room.height / 2.0f - ui.px(kRim));
    list.AddCircleFilled(view.centre, view.radius, ui.colour(ColourRole::kField));
    const ImU32 front = ui.colour(ColourRole::kCube, 0.45);
    const ImU32 back = ui.colour(ColourRole::kCube, 0.16);
    for (const double degrees : {-60.0, -30.0, 0.0, 30.0, 60.0}) {
      latitude(list, view, degrees, front, back, std::max(1.0f, ui.scale() * 0.9f));
    }
    list.AddCircle(view.centre, view.radius, ui.colour(ColourRole::kCube, 0.7), 0,
                   std::max(1.0f, ui.scale()));
    // During a drag the path is made anew for each display frame.
    const float error = session.inDrag() ? kDraggedPathError : kPathError;
    const SpherePath& path =
        graphs.path(session.current(), static_cast<double>(error / std::max(1.0f, view.radius)));
    const Vec3 current = session.evaluation().cameraAt(session.current()).viewPlaneNormal;
    drawOrientations(ui, list, view, path, current);
    // Where the camera looks at the playhead; on the current mark it is its middle.
    const Vec3 now = session.camera().viewPlaneNormal;
    const double strength = view.front(now) ? 1.0 : 0.5;
    const ImVec2 at = view.place(now), mark = view.place(current);
    if (std::hypot(at.x - mark.x, at.y - mark.y) > 2.0f * ui.scale()) {
      list.AddCircleFilled(at, 4.4f * ui.scale(), ui.colour(ColourRole::kField, 0.8 * strength));
    }
    list.AddCircleFilled(at, 3.0f * ui.scale(), ui.colour(ColourRole::kPlayhead, strength));
    if (!state.released) return;
    // A click makes the orientation under the pointer current.
    const auto nearest = orientationAt(view, session, ImGui::GetIO().MousePos, ui.px(8));
    if (nearest) actions.run(Command("make-current", nearest->key, nearest->orientation));
  });
}

float leastSphere(const Ui& ui) { return ui.tall(124); }
float mostSphere(const Ui& ui) { return ui.px(320); }

float measuresPanelHeight(const Ui& ui) { return panelHeight(ui) + 4 * ui.tall(kMeasureRow); }

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
    const std::string length = measured(ui, session.evaluation().length() * unit.perCube);
    row("measures/length", length, withUnit(length, unit.brief));
    const std::int64_t frames = session.evaluation().frameCount();
    const double fps = session.flight().frameRate;
    row("measures/duration", secondsText(ui, frames, fps), lengthText(ui, frames, fps));
    const std::string speed =
        quality ? measured(ui, quality->maxSpeed * unit.perCube) : std::string();
    row("measures/speed", quality ? speed + " /s" : waiting,
        quality ? withUnit(speed, unit.brief + "/s") : waiting);
    const std::string turning =
        quality ? withUnit(ui.number(quality->maxAngularSpeed, 1), "\u00b0/s") : waiting;
    row("measures/turn_rate", turning, turning);
  });
  panelCaption(ui, column, top, unit.whole);
}

}  // namespace vides
