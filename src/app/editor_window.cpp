// SPDX-License-Identifier: MIT
// Where everything stands in the window (5-editor, "Layout").
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor_parts.hpp"
#include "panels/column_layout.hpp"
#include "panels/import_note.hpp"
#include "panels/menu_bar.hpp"
#include "panels/note_place.hpp"
#include "panels/quantities.hpp"
#include "panels/right_panels.hpp"
#include "panels/viewport_panel.hpp"
#include "panels/windows.hpp"
#include "scene/camera_scene.hpp"

namespace vides {
namespace {

// At content scale 1.
constexpr float kMenuHeight = 28.0f;
constexpr float kSplitter = 6.0f;
constexpr float kLeastForWords = 200.0f;
constexpr double kPlate = 0.7;  // of a text over the picture

// Room for words beside what is drawn.
bool roomy(const Ui& ui, const Rect& rect) {
  return std::min(rect.width, rect.height) >= ui.px(kLeastForWords);
}

Rect below(const Rect& rect, float height) {
  return {rect.x, rect.y + height, rect.width, std::max(0.0f, rect.height - height)};
}

}  // namespace

Ui::Setting Editor::Parts::uiSetting() {
  return {fonts.fonts, colours,
          words,       tell,
          hint,        registry,
          memory,      static_cast<float>(scale),
          time,        session.display().language != Language::kEnglish};
}

ViewportState Editor::Parts::viewportState() const {
  ViewportState state;
  state.current = session.current();
  state.selected = session.selected().keys();
  state.playhead = session.frame();
  state.freeCamera = session.freeCamera();
  state.hovered = tools.hovered();
  state.drag = tools.drag();
  return state;
}

// What the pointer can do here, what it can't, and the box that it draws: over all, since the
// viewport may be small.
void Editor::Parts::pointerSigns(Ui& ui) {
  const auto box = tools.box();
  const auto note = tools.note(time);
  // In a picture as small as that a hint would hide what it is about.
  const bool hints = !tools.drag() && roomy(ui, pictures->flightRect());
  const Text text = note ? note->text : hints ? tools.hint() : Text();
  if (!box && text.empty()) return;
  ImGui::SetNextWindowPos({0.0f, 0.0f});
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::Begin("###signs", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  if (box) {
    const ImVec2 low(static_cast<float>(box->x), static_cast<float>(box->y));
    const ImVec2 high(low.x + static_cast<float>(box->width),
                      low.y + static_cast<float>(box->height));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, ui.colour(ColourRole::kText, 0.08));
    list.AddRect(low, high, ui.colour(ColourRole::kText, 0.7), 0.0f, 0, ui.scale());
  }
  if (!text.empty())
    pointerNote(ui, ui.tell(text), note ? note->pixel : pointerAt, note.has_value());
  ImGui::End();
}

void Editor::Parts::pointerNote(Ui& ui, const std::string& told, const Vec2& at, bool refusal) {
  const float width = ui.textWidth(told) + ui.px(16);
  // In the viewport where it has room there: the columns stay readable.
  const Rect seen = pictures->flightRect();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const Rect room = seen.width > width + ui.px(8) ? seen : Rect{0.0f, 0.0f, screen.x, screen.y};
  const Rect box = notePlace(room.inset(ui.px(4)), {width, ui.px(24)},
                             {static_cast<float>(at.x), static_cast<float>(at.y)},
                             pictures->handles(), ui.scale());
  ui.shows("view/hint", box, told);
  ui.fill(box, ColourRole::kPanel, 4.0f, 0.94);
  ui.text({box.x + ui.px(8), box.y, width - ui.px(16), box.height}, told,
          {.colour = refusal ? ColourRole::kError : ColourRole::kTextSecondary});
}

void Editor::Parts::viewportArea(Ui& ui, const Rect& rect, Actions& actions) {
  region("###viewport", rect, [&](const Rect&) {
    const bool film = session.view().swapped;
    const bool bare = session.layout().bare;
    const bool sliders = !film && !bare && session.display().sliders && roomForSliders(ui, rect);
    // Not over what is being dragged, nor in a picture that it would fill.
    const bool captioned = !film && !bare && !tools.drag() && roomy(ui, rect);
    const Caption caption = captioned ? viewportCaption(ui, rect, sliders) : Caption();
    ViewportState state = viewportState();
    const auto cover = [&](const Rect& box) {
      state.covered.push_back({box.x, box.y, box.width, box.height});
    };
    if (!caption.words.empty()) cover(caption.box);
    if (sliders) {
      const auto [size, turn, tilt] = sliderPlaces(ui, rect);
      for (const Rect& box : {size, turn, tilt}) cover(box);
    }
    pictures->viewport(ui, *ImGui::GetWindowDrawList(), film && !bare ? filmRoom(ui, rect) : rect,
                       session, scenes, state);
    if (bare) return;
    if (sliders) {
      if (const auto next = viewportSliders(ui, rect, session)) actions.view = next;
    }
    if (film) filmText(ui, rect);
    if (!caption.words.empty()) {
      const float air = ui.px(4);
      ui.fill({caption.box.x - air, caption.box.y, caption.box.width + 2 * air, caption.box.height},
              ColourRole::kViewportTop, 3.0f, kPlate);
      ui.text(caption.box, caption.words, {.colour = ColourRole::kTextSecondary});
    }
    if (const auto centre = farCentre(session)) {
      const std::string told = ui.tell(Text("view.centre", {centreWords(ui, *centre)}));
      const Rect box{rect.x + ui.px(14), rect.y + ui.px(28),
                     std::min(ui.textWidth(told), rect.width - ui.px(28)), ui.px(18)};
      ui.text(box, told, {.colour = ColourRole::kTextSecondary, .mayShorten = true});
      ui.shows("view/centre", box, told);
    }
    const float signs = ui.px(44);
    readingSign(ui, rect, session, actions);
    importNote(ui, rect, session.reading() ? signs + ui.px(48) : signs, session, actions);
    pictureArea(ui, rect, film, false);
  });
}

// Whichever picture stands here has the pointer. Small ones tell what it does to them.
void Editor::Parts::pictureArea(Ui& ui, const Rect& rect, bool film, bool small) {
  const auto area = ui.area(film ? "camera/picture" : "view/picture", rect, {}, small);
  (film ? overCamera : overViewport) = area.hovered;
}

// In the viewport's upper left corner: which view it is, as much of it as there is room for beside
// the slider.
Editor::Parts::Caption Editor::Parts::viewportCaption(const Ui& ui, const Rect& rect,
                                                      bool sliders) const {
  const EditorView& view = session.view().view;
  const bool perspective = view.type == ProjectionType::Perspective;
  const std::string name = ui.words(perspective ? "view/perspective" : "view/parallel");
  const std::string angles = ui.words("view/turn_short") + " " + ui.number(view.turn, 0) +
                             "\u00b0 \u00b7 " + ui.words("view/tilt_short") + " " +
                             ui.number(view.tilt, 0) + "\u00b0";
  const float left = rect.x + ui.px(14);
  const float right = sliders ? sliderPlaces(ui, rect).size.x - ui.px(8) : rect.right() - ui.px(14);
  const std::string bare =
      ui.number(view.turn, 0) + "\u00b0 \u00b7 " + ui.number(view.tilt, 0) + "\u00b0";
  for (const std::string& label : {name + " \u00b7 " + angles, name + " \u00b7 " + bare, name}) {
    const float width = ui.textWidth(label);
    if (left + width <= right) return {{left, rect.y + ui.px(10), width, ui.px(20)}, label};
  }
  return {};
}

// What the camera sees keeps clear of the columns and of its caption.
Rect Editor::Parts::filmRoom(const Ui& ui, const Rect& rect) {
  const float air = std::min({ui.px(8), 0.1f * rect.width, 0.1f * rect.height});
  return {rect.x + air, rect.y + air, rect.width - 2 * air, rect.height - 2 * air};
}

// The same for what the camera sees, where it has the viewport's place.
void Editor::Parts::filmText(Ui& ui, const Rect& rect) {
  ui.text({rect.x + ui.px(14), rect.y + ui.px(10), rect.width - ui.px(28), ui.px(20)},
          ui.words("panel/camera") + " \u00b7 " + cameraCaption(ui, session),
          {.colour = ColourRole::kTextSecondary, .mayShorten = true});
  if (session.freeCamera()) freeViewSign(ui, filmRoom(ui, rect));
}

// A free view has a frame and a sign in the picture's corner.
void Editor::Parts::freeViewSign(Ui& ui, const Rect& rect) {
  const PixelRectangle room{static_cast<double>(rect.x), static_cast<double>(rect.y),
                            static_cast<double>(rect.width), static_cast<double>(rect.height)};
  const PixelRectangle inner = letterbox(room, session.flight().picture);
  const Rect picture{static_cast<float>(inner.x), static_cast<float>(inner.y),
                     static_cast<float>(inner.width), static_cast<float>(inner.height)};
  ui.outline(picture, ColourRole::kText, 0.0f);
  const std::string label = ui.words("camera/free");
  const float width = ui.textWidth(label, Weight::kSemibold) + ui.px(12);
  const Rect sign{picture.x, picture.y, std::min(width, picture.width), ui.px(20)};
  ui.fill(sign, ColourRole::kText);
  ui.text(sign, label,
          {.colour = ColourRole::kWindow, .weight = Weight::kSemibold, .align = Align::kCentre});
}

void Editor::Parts::splitters(Ui& ui, const Rect& all, const Rect& left, const Rect& right,
                              const Rect& timelineRect, bool both, Actions& actions) {
  const float thick = ui.px(kSplitter);
  const Layout& layout = session.layout();
  Layout next = layout;
  // A drag goes on from the size that is seen, which need not be the one that was chosen.
  const auto change = [&](const char* id, const Rect& rect, bool vertical, float seen, float& size,
                          bool& on, float sign, const Range& range) {
    // Above the regions beside it, which would have the pointer otherwise.
    SplitterChange by;
    region(("###" + std::string(id)).c_str(), rect,
           [&](const Rect&) { by = splitter(ui, id, rect, vertical); });
    if (by.fold) on = !on;
    if (by.by != 0.0f && on)
      size = std::clamp(seen / ui.scale() + sign * by.by, static_cast<float>(range.min),
                        static_cast<float>(range.max));
  };
  const float height = timelineRect.y - all.y;
  change("view/left_splitter", {left.right() - thick / 2, all.y, thick, height}, true, left.width,
         next.left, next.leftShown, 1.0f, kLeftWidth);
  if (!both) {
    change("view/right_splitter", {right.x - thick / 2, all.y, thick, height}, true, right.width,
           next.right, next.rightShown, -1.0f, kRightWidth);
  }
  change("view/timeline_splitter", {all.x, timelineRect.y - thick / 2, all.width, thick}, false,
         timelineRect.height, next.timeline, next.timelineShown, -1.0f, kTimelineHeight);
  if (next != layout) actions.layout = next;
}

// A drag's numbers, unless something is wrong.
OutputLine Editor::Parts::outputLine() const {
  const OutputLine said = session.output();
  if (said.kind == MessageKind::kRefusal || said.kind == MessageKind::kError) return said;
  return tools.output().value_or(said);
}

void Editor::Parts::window(Ui& ui, Actions& actions) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.0f, 0.0f});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
  const float menu = ui.px(kMenuHeight);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, 0);
  ImGui::Begin("###window", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoScrollWithMouse);
  float top = menu;
  if (!session.layout().bare) {
    top += menuBar(ui, session, outputLine(), menu, menus, actions);
  }
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  if (session.layout().bare) {
    viewportArea(ui, {0.0f, 0.0f, size.x, size.y}, actions);
  } else {
    arrange(ui, below({0.0f, 0.0f, size.x, size.y}, top), actions);
  }
  ImGui::End();
  if (session.layout().bare) return;
  // Windows keep a margin, which a screen without room for it makes less.
  const float margin = std::min(ui.px(8), std::floor(std::min(size.x, size.y) / 50.0f));
  ui.setWorkArea(below({0.0f, 0.0f, size.x, size.y}, top).inset(margin));
  pointerSigns(ui);
  windows(ui, session, texts, windowsMemory, actions);
  openMenu(ui, session, session.layout(), menus, actions);
}

void Editor::Parts::arrange(Ui& ui, const Rect& all, Actions& actions) {
  const Layout& layout = session.layout();
  // What is too large for the window gives way: columns before the viewport.
  const float bar = layout.timelineShown ? timelineHeight(ui, layout, all.height) : 0.0f;
  const Rect timelineRect{all.x, all.bottom() - bar, all.width, bar};
  const float middle = all.height - bar;
  const PictureFormat& format = session.flight().picture;
  const ColumnWidths widths = columnWidths(
      ui, layout, all.width, middle,
      static_cast<float>(static_cast<double>(format.width) / static_cast<double>(format.height)));
  const Rect left{all.x, all.y, widths.left, middle};
  const Rect right{all.right() - widths.right, all.y, widths.right, middle};
  const Rect view{left.right(), all.y, std::max(0.0f, right.x - left.right()), middle};

  ui.fill(left, ColourRole::kColumn);
  ui.fill(right, ColourRole::kColumn);
  ui.fill(timelineRect, ColourRole::kColumn);
  if (!view.empty()) viewportArea(ui, view, actions);
  if (!left.empty()) leftColumn(ui, left, widths.both, actions);
  if (!right.empty()) rightColumn(ui, right, actions);
  if (!timelineRect.empty()) {
    region("###timeline", timelineRect, [&](const Rect&) {
      timelinePanel(ui, timelineRect, session, graphs, timeline, actions);
    });
  }
  const float line = std::max(1.0f, ui.px(1));
  ui.fill({left.right(), all.y, layout.leftShown ? line : 0.0f, middle}, ui.divider());
  ui.fill({right.x - line, all.y, layout.rightShown && !widths.both ? line : 0.0f, middle},
          ui.divider());
  ui.fill({all.x, timelineRect.y, all.width, bar > 0.0f ? line : 0.0f}, ui.divider());
  splitters(ui, all, left, right, timelineRect, widths.both, actions);
}

}  // namespace vides
