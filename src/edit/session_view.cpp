// SPDX-License-Identifier: MIT
// Commands for the view, the free camera, display and windows.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "edit/free_camera.hpp"
#include "edit/session_actions.hpp"

namespace vides {
namespace {

using Result = SessionActions::Result;

constexpr double kDegree = std::numbers::pi / 180.0;

// The box around points.
struct Box {
  Vec3 low{1e300}, high{-1e300};
  void add(const Vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
};

// The camera view has the viewport's place until a named view is asked for.
void lookThroughCamera(ViewState& state) { state.swapped = state.throughCamera = true; }

void leaveCamera(ViewState& state) {
  if (state.throughCamera) state.swapped = state.throughCamera = false;
}

}  // namespace

// --- The view ---

Result SessionActions::view(Session& session, const Arguments& arguments) {
  ViewState& state = session.view_;
  if (arguments.text(0) == "camera") {
    if (!state.swapped) lookThroughCamera(state);
    return {};
  }
  const NamedView named = *namedView(arguments.text(0));
  state.view = turnedTo(state.view, state.pivot, named.turn, named.tilt);
  leaveCamera(state);
  return {};
}

Result SessionActions::viewOpposite(Session& session, const Arguments&) {
  session.view_.view = opposite(session.view_.view, session.view_.pivot);
  leaveCamera(session.view_);
  return {};
}

Result SessionActions::viewCamera(Session& session, const Arguments&) {
  ViewState& state = session.view_;
  if (!state.swapped) {
    lookThroughCamera(state);
  } else {
    state.swapped = state.throughCamera = false;
  }
  return {};
}

Result SessionActions::perspective(Session& session, const Arguments& arguments) {
  ProjectionType& type = session.view_.view.type;
  const bool on = switched(arguments, 0, type == ProjectionType::Perspective);
  type = on ? ProjectionType::Perspective : ProjectionType::Parallel;
  return {};
}

Result SessionActions::setView(Session& session, const Arguments& arguments) {
  EditorView view = session.view_.view;
  view.turn = arguments.number(0);
  view.tilt = arguments.number(1);
  view.size = arguments.number(2);
  if (arguments.has(5)) view.target = arguments.point(3);
  session.view_.view = limited(view);
  return {};
}

Result SessionActions::setTurn(Session& session, const Arguments& arguments) {
  ViewState& state = session.view_;
  state.view = turnedTo(state.view, state.pivot, arguments.number(0), state.view.tilt);
  return {};
}

Result SessionActions::setTilt(Session& session, const Arguments& arguments) {
  ViewState& state = session.view_;
  state.view = turnedTo(state.view, state.pivot, state.view.turn, arguments.number(0));
  return {};
}

Result SessionActions::setSize(Session& session, const Arguments& arguments) {
  EditorView view = session.view_.view;
  view.size = arguments.number(0);
  session.view_.view = limited(view);
  return {};
}

Result SessionActions::frameSelection(Session& session, const Arguments&) {
  Box box;
  for (const std::size_t k : session.selected().keys()) box.add(session.flight().keys[k].position);
  session.view_.view = framed(session.view_.view, box.low, box.high);
  session.view_.pivot = session.view_.view.target;
  return {};
}

Result SessionActions::frameAll(Session& session, const Arguments&) {
  EditorView& view = session.view_.view;
  view.target = Vec3(0.0);
  view.size = 1.0;
  session.view_.pivot = Vec3(0.0);
  return {};
}

Result SessionActions::swapViews(Session& session, const Arguments&) {
  session.view_.swapped = !session.view_.swapped;
  session.view_.throughCamera = false;
  return {};
}

// --- The free camera ---

Result SessionActions::fly(Session& session, const Camera& camera) {
  session.playback_.stop();
  session.freeCamera_ = camera;
  Vec3& place = session.freeCamera_->viewReferencePoint;
  place = withinReach(place);
  session.output_ = {};
  return {};
}

Result SessionActions::setFreeView(Session& session, const Arguments& arguments) {
  Camera camera{arguments.point(0), arguments.point(3), arguments.point(6), arguments.number(9)};
  if (glm::length(camera.viewPlaneNormal) < 1e-9) return tl::unexpected(Text("refusal.vpn-zero"));
  return fly(session, zoomedCamera(normalized(camera), 0.0));
}

Result SessionActions::flyTurn(Session& session, const Arguments& arguments) {
  return fly(session, turnedCamera(session.camera(), arguments.number(0) * kDegree,
                                   arguments.number(1) * kDegree));
}

Result SessionActions::flyMove(Session& session, const Arguments& arguments) {
  return fly(session, movedCamera(session.camera(), arguments.number(0), arguments.number(1),
                                  arguments.number(2)));
}

Result SessionActions::flyRoll(Session& session, const Arguments& arguments) {
  return fly(session, rolledCamera(session.camera(), arguments.number(0) * kDegree));
}

Result SessionActions::flyZoom(Session& session, const Arguments& arguments) {
  return fly(session, zoomedCamera(session.camera(), arguments.number(0)));
}

Result SessionActions::leaveView(Session& session, const Arguments&) {
  session.freeCamera_.reset();
  return {};
}

// --- Display and windows ---

Result SessionActions::showElement(Session& session, const Arguments& arguments) {
  bool* shown = switchOf(session.display_, arguments.text(0));
  *shown = switched(arguments, 1, *shown);
  return {};
}

Result SessionActions::setColour(Session& session, const Arguments& arguments) {
  for (std::size_t i = 1; i <= 3; ++i) {
    if (arguments.number(i) > 255) {
      return tl::unexpected(Text("refusal.colour", {arguments.number(i)}));
    }
  }
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(arguments.number(i)); };
  const auto role = static_cast<std::size_t>(*colourRole(arguments.text(0)));
  session.display_.colours[role] = Colour{byte(1), byte(2), byte(3), 255};
  return {};
}

Result SessionActions::resetColour(Session& session, const Arguments& arguments) {
  auto& colours = session.display_.colours;
  if (!arguments.has(0)) {
    colours.fill(std::nullopt);
    return {};
  }
  colours[static_cast<std::size_t>(*colourRole(arguments.text(0)))].reset();
  return {};
}

Result SessionActions::setTheme(Session& session, const Arguments& arguments) {
  session.display_.theme = *themeKind(arguments.text(0));
  return {};
}

Result SessionActions::contentScale(Session& session, const Arguments& arguments) {
  const double scale = arguments.number(0);
  if (scale != 0.0 && !kContentScale.contains(scale)) {
    return tl::unexpected(Text("refusal.content-scale", {scale}));
  }
  session.display_.contentScale = scale;
  return {};
}

Result SessionActions::ghostEvery(Session& session, const Arguments& arguments) {
  const double frames = arguments.number(0);
  if (!kGhostEvery.contains(frames)) return tl::unexpected(Text("refusal.ghost-every", {frames}));
  session.display_.shown.ghostEvery = static_cast<int>(frames);
  return {};
}

Result SessionActions::elementSize(Session& session, const Arguments& arguments) {
  const auto* const size = std::ranges::find(kElementSizes, arguments.text(0), &ElementSize::name);
  const double pixels = arguments.number(1);
  if (!size->range.contains(pixels)) {
    return tl::unexpected(Text("refusal.element-size", {size->range.min, size->range.max, pixels}));
  }
  session.display_.sizes.*size->size = pixels;
  return {};
}

Result SessionActions::resetSizes(Session& session, const Arguments&) {
  session.display_.sizes = {};
  return {};
}

Result SessionActions::gridStep(Session& session, const Arguments& arguments) {
  const double step = arguments.number(0);
  if (!kGridSteps.contains(step)) return tl::unexpected(Text("refusal.grid-step", {step}));
  session.display_.gridStep = step;
  return {};
}

Result SessionActions::units(Session& session, const Arguments& arguments) {
  session.display_.units = arguments.text(0) == "scene" ? Units::kScene : Units::kCube;
  return {};
}

Result SessionActions::language(Session& session, const Arguments& arguments) {
  session.display_.language = arguments.text(0) == "de" ? Language::kGerman : Language::kEnglish;
  return {};
}

void SessionActions::openWindow(Session& session, const std::string& name) {
  const bool opens = !session.windowOpen(name);
  std::erase(session.windows_, name);
  session.windows_.push_back(name);
  if (name == "shape" && opens) beginShape(session);
}

void SessionActions::hideWindow(Session& session, const std::string& name) {
  // As its Cancel does; its OK has ended the step before.
  if (name == "shape" && session.windowOpen(name)) endShape(session);
  std::erase(session.windows_, name);
  // Whoever closes the chooser doesn't want to go on with what was to follow the saving.
  if (name == "chooser-save" && !session.question()) session.dialogue_.reset();
}

Result SessionActions::showWindow(Session& session, const Arguments& arguments) {
  // Asking how many makes no sense where there is no place for any.
  if (arguments.text(0) == "insert-keys" && !session.flight().closed &&
      session.current().key + 1 == session.flight().keys.size()) {
    return tl::unexpected(Text("refusal.after-last-key"));
  }
  openWindow(session, arguments.text(0));
  return {};
}

Result SessionActions::closeWindow(Session& session, const Arguments& arguments) {
  if (arguments.has(0)) {
    hideWindow(session, arguments.text(0));
  } else if (!session.windows_.empty()) {
    hideWindow(session, std::string(session.windows_.back()));
  }
  return {};
}

Result SessionActions::fullScreen(Session& session, const Arguments& arguments) {
  session.fullScreen_ = switched(arguments, 0, session.fullScreen_);
  return {};
}

Result SessionActions::escape(Session& session, const Arguments&) {
  if (session.gesture_ && !session.gesture_->window) {
    session.cancel();
  } else if (session.question()) {
    return answer(session, Arguments(Command("answer", session.question()->choices.back())));
  } else if (session.freeCamera_) {
    session.freeCamera_.reset();
  } else if (!session.windows_.empty()) {
    hideWindow(session, std::string(session.windows_.back()));
  } else {
    session.output_ = {};
  }
  return {};
}

}  // namespace vides
