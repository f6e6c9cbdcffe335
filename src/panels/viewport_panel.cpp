// SPDX-License-Identifier: MIT
// Around the viewport.
#include "panels/viewport_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "panels/left_panels.hpp"

namespace vides {

bool roomForSliders(const Ui& ui, const Rect& rect) {
  return rect.width >= ui.px(150) && rect.height >= ui.px(200);
}

// About the middle, and no longer than looks well: the sketch's proportions.
SliderPlaces sliderPlaces(const Ui& ui, const Rect& rect) {
  const float thick = ui.px(18);
  const float width = std::clamp(rect.width - ui.px(400), ui.px(120), ui.px(480));
  const float turnWidth = std::clamp(rect.width - ui.px(120), ui.px(120), ui.px(720));
  const float tiltHeight = std::clamp(rect.height - ui.px(180), ui.px(80), ui.px(480));
  return {
      {std::round(rect.centreX() - width / 2), rect.y + ui.px(11), width, thick},
      {std::round(rect.centreX() - turnWidth / 2), rect.bottom() - ui.px(29), turnWidth, thick},
      {rect.right() - ui.px(26), std::round(rect.centreY() - tiltHeight / 2), thick, tiltHeight}};
}

std::optional<EditorView> viewportSliders(Ui& ui, const Rect& rect, const Session& session) {
  const EditorView& view = session.view().view;
  EditorView next = view;
  const auto [size, turn, tilt] = sliderPlaces(ui, rect);
  if (const auto change = ui.slider(
          "view/size", size, view.size,
          {.least = kMinViewSize, .most = kMaxViewSize, .logarithmic = true, .decimals = 2})) {
    next.size = std::clamp(change->value, kMinViewSize, kMaxViewSize);
  }
  if (const auto change =
          ui.slider("view/turn", turn, view.turn,
                    {.least = -180.0, .most = 180.0, .decimals = 1, .snap = 15.0})) {
    next = turnedTo(view, session.view().pivot, change->value, view.tilt);
  }
  if (const auto change = ui.slider(
          "view/tilt", tilt, view.tilt,
          {.least = -90.0, .most = 90.0, .vertical = true, .decimals = 1, .snap = 15.0})) {
    next = turnedTo(view, session.view().pivot, view.turn, change->value);
  }
  return next == view ? std::nullopt : std::optional(next);
}

void readingSign(Ui& ui, const Rect& viewport, const Session& session, Actions& actions) {
  const auto reading = session.reading();
  if (!reading) return;
  const std::string words =
      ui.tell(reading->files == 1 ? Text("view.reading", {reading->file})
                                  : Text("view.reading-more", {reading->file, reading->files - 1}));
  const float pad = ui.px(8), button = ui.px(96), number = ui.px(52);
  const float most = viewport.width - 2 * pad;
  const float width =
      std::min(most, std::max(ui.px(320), ui.textWidth(words) + number + button + 6 * pad));
  const Rect box{std::round(viewport.centreX() - width / 2), viewport.y + ui.px(44), width,
                 ui.px(40)};
  if (width < number + button + 4 * pad || box.bottom() > viewport.bottom()) return;
  ui.fill(box, ColourRole::kPanel, 4.0f, 0.94);
  ui.outline(box, ColourRole::kEdge, 4.0f);
  const Rect stop{box.right() - pad - button, box.y + ui.px(7), button, ui.px(26)};
  const Rect label{box.x + pad, box.y + ui.px(6), stop.x - box.x - number - 3 * pad, ui.px(20)};
  ui.text(label, words, {.mayShorten = true});
  const Rect track{label.x, box.bottom() - ui.px(11), label.width + pad + number, ui.px(4)};
  const std::string share = progressBar(ui, track, reading->share);
  ui.text({label.right() + pad, label.y, number, label.height}, share, {.align = Align::kRight});
  ui.shows("view/reading", track, share);
  commandButton(ui, "view/stop_reading", stop, "cancel-reading", session, actions);
}

SplitterChange splitter(Ui& ui, std::string_view id, const Rect& rect, bool vertical) {
  const auto state = ui.area(id, rect);
  SplitterChange change;
  if (state.hovered || state.held) {
    ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    const float thick = ui.px(2);
    ui.fill(vertical ? Rect{std::round(rect.centreX() - thick / 2), rect.y, thick, rect.height}
                     : Rect{rect.x, std::round(rect.centreY() - thick / 2), rect.width, thick},
            ColourRole::kControlActive);
  }
  if (state.doubleClicked) {
    change.fold = true;
  } else if (state.held) {
    const ImVec2 delta = ImGui::GetIO().MouseDelta;
    change.by = (vertical ? delta.x : delta.y) / ui.scale();
  }
  return change;
}

}  // namespace vides
