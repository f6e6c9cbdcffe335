// SPDX-License-Identifier: MIT
// Our widgets: buttons, sliders, areas.
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "panels/ui.hpp"

namespace vides {
namespace {

constexpr double kTooltipDelay = 0.6;  // seconds

ImRect rectangle(const Rect& r) { return {r.x, r.y, r.right(), r.bottom()}; }

ImGuiID idOf(std::string_view id) {
  const std::string label = "###" + std::string(id);
  return ImGui::GetID(label.c_str());
}

bool over(const Rect& rect) {
  return ImGui::IsWindowHovered() &&
         ImGui::IsMouseHoveringRect({rect.x, rect.y}, {rect.right(), rect.bottom()});
}

double shareOf(double value, const SliderStyle& style) {
  const double share = style.logarithmic
                           ? std::log(value / style.least) / std::log(style.most / style.least)
                           : (value - style.least) / (style.most - style.least);
  return std::clamp(share, 0.0, 1.0);
}

double valueAt(double share, const SliderStyle& style) {
  const double in = std::clamp(share, 0.0, 1.0);
  return style.logarithmic ? style.least * std::pow(style.most / style.least, in)
                           : style.least + in * (style.most - style.least);
}

}  // namespace

Ui::Press Ui::press(std::string_view id, const Rect& rect, WidgetKind, bool enabled) {
  Press result;
  const ImRect box = rectangle(rect);
  const ImGuiID key = idOf(id);
  // One that was walked to is brought into sight before it does anything.
  if (!ImGui::ItemAdd(box, key)) return result;
  if (!enabled) {
    result.hovered = over(rect);
    return result;
  }
  result.pressed = ImGui::ButtonBehavior(box, key, &result.hovered, &result.held);
  KeyboardFocus& focus = setting_.memory.focus;
  if (result.pressed) focus.passed(id);
  result.pressed = result.pressed || focus.takeOperation(id);
  return result;
}

std::string Ui::tip(std::string_view id, const ButtonStyle& style) const {
  const std::string key = "tip/" + std::string(id);
  if (!style.enabled) {
    const std::string why = words(key + "#greyed");
    if (!why.empty()) return why;
  }
  std::string told = style.tooltip.empty() ? words(key) : style.tooltip;
  if (style.command.empty()) return told;
  if (told.empty()) {
    std::string title = "command." + style.command;
    std::replace(title.begin(), title.end(), ' ', '.');
    told = words(title);
    if (told.empty()) told = words(title.substr(0, title.find('.', sizeof "command.")));
  }
  const std::string keys = setting_.hint(style.command);
  return keys.empty() ? told : told + "  (" + keys + ")";
}

// What a tooltip tells of stays to be read: it stands below (or above) its widget, `beside` an
// entry of a menu, and at the pointer of what is larger than a row.
static ImVec2 tooltipPlace(const Ui& ui, const Rect& about, const ImVec2& size, bool beside) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const float gap = ui.px(4);
  const bool row = about.height <= ui.px(40);
  ImVec2 at{pointer.x, about.bottom() + gap};
  if (!row) at = {pointer.x + ui.px(16), pointer.y + ui.px(16)};
  if (beside) at = {about.right() + ui.px(16), about.y};
  if (at.y + size.y > screen.y - gap) at.y = (row ? about.y : pointer.y) - gap - size.y;
  return {std::round(std::max(gap, std::min(at.x, screen.x - gap - size.x))),
          std::round(std::max(gap, at.y))};
}

void Ui::tooltip(std::string_view id, const Rect& about, const Press& press,
                 const ButtonStyle& style, bool beside) {
  UiMemory& memory = setting_.memory;
  if (!press.hovered || press.held) {
    if (memory.tooltipFor == id) memory.tooltipFor.clear();
    return;
  }
  if (memory.tooltipFor != id) {
    memory.tooltipFor = id;
    memory.tooltipSince = setting_.time;
  }
  if (setting_.time - memory.tooltipSince < kTooltipDelay) return;
  const std::string told = tip(id, style);
  if (told.empty()) return;
  const ImVec2 padding(px(8), px(5));
  const float wrap = px(300);
  const ImVec2 text = ImGui::CalcTextSize(told.c_str(), nullptr, false, wrap - padding.x);
  ImGui::SetNextWindowPos(
      tooltipPlace(*this, about, {text.x + 2 * padding.x, text.y + 2 * padding.y}, beside));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(wrap);
  ImGui::TextUnformatted(told.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void Ui::tells(std::string_view what, const Rect& about, const std::string& words) {
  tooltip(what, about, {true, false, false}, {.tooltip = words});
}

void Ui::edge(const Rect& rect) {
  if (theme()[ColourRole::kEdge] == theme()[ColourRole::kControl]) return;
  outline(rect, ColourRole::kEdge, 3.0f);
}

void Ui::ground(const Rect& rect, const Press& press, const ButtonStyle& style) {
  if (!style.enabled) {
    if (style.on) {
      fill(rect, ColourRole::kControlActive, 3.0f, 0.6);
    } else if (!style.quiet) {
      fill(rect, ColourRole::kControl, 3.0f, 0.4);
    }
    return;
  }
  if (press.held || style.on) {
    fill(rect, ColourRole::kControlActive, 3.0f);
  } else if (press.hovered) {
    fill(rect, ColourRole::kControlHovered, 3.0f);
  } else if (!style.quiet) {
    fill(rect, ColourRole::kControl, 3.0f);
  }
  if (style.enter) {
    // Told apart from the edges that all have in some themes.
    const bool edged = theme()[ColourRole::kEdge] != theme()[ColourRole::kControl];
    outline(rect, edged ? ColourRole::kText : ColourRole::kTextSecondary, 3.0f,
            edged ? 2.0f : 1.0f);
  } else if (!style.quiet) {
    edge(rect);
  }
}

bool Ui::button(std::string_view id, const Rect& rect, std::string_view label,
                const ButtonStyle& style) {
  const Press state = press(id, rect, WidgetKind::kButton, style.enabled);
  registerWidget(id, label, style.toggle ? WidgetKind::kToggle : WidgetKind::kButton, rect,
                 style.enabled, style.toggle ? (style.on ? "on" : "off") : "", tip(id, style));
  ground(rect, state, style);
  const float inset = style.align == Align::kCentre ? 0.0f : px(6);
  text({rect.x + inset, rect.y, rect.width - 2 * inset, rect.height}, label,
       {.colour = style.enabled ? ColourRole::kText : ColourRole::kTextDisabled,
        .weight = style.on ? Weight::kSemibold : Weight::kRegular,
        .align = style.align});
  tooltip(id, rect, state, style);
  return state.pressed;
}

bool Ui::button(std::string_view id, const Rect& rect, const ButtonStyle& style) {
  return button(id, rect, words(id), style);
}

bool Ui::enterPressed() const {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) ||
         ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false);
}

bool Ui::iconButton(std::string_view id, const Rect& rect, Icon which, const ButtonStyle& style) {
  const Press state = press(id, rect, WidgetKind::kButton, style.enabled);
  registerWidget(id, style.label.empty() ? words(id) : style.label,
                 style.toggle ? WidgetKind::kToggle : WidgetKind::kButton, rect, style.enabled,
                 style.toggle ? (style.on ? "on" : "off") : "", tip(id, style));
  ground(rect, state, style);
  icon(which, rect, style.enabled ? ColourRole::kText : ColourRole::kTextDisabled);
  tooltip(id, rect, state, style);
  return state.pressed;
}

bool Ui::columnHead(std::string_view id, const Rect& rect, bool sorted, bool descending,
                    Align align) {
  const std::string label = words(id);
  const Press state = press(id, rect, WidgetKind::kToggle, true);
  registerWidget(id, label, WidgetKind::kToggle, rect, true, sorted ? "on" : "off", tip(id));
  ground(rect, state, {.quiet = true});
  const float inset = px(8);
  const Rect box{rect.x + inset, rect.y, rect.width - 2 * inset, rect.height};
  text(box, label, {.colour = ColourRole::kTextSecondary, .align = align});
  if (sorted) {
    const float side = px(12);
    const float gap = textWidth(label) + px(4);
    const float left = align == Align::kRight ? box.right() - gap - side : box.x + gap;
    icon(descending ? Icon::kChevronDown : Icon::kChevronUp, {left, rect.y, side, rect.height},
         ColourRole::kTextSecondary);
  }
  tooltip(id, rect, state);
  return state.pressed;
}

bool Ui::checkBox(std::string_view id, const Rect& rect, bool on) {
  const std::string label = words(id);
  const Press state = press(id, rect, WidgetKind::kToggle, true);
  registerWidget(id, label, WidgetKind::kToggle, rect, true, on ? "on" : "off", tip(id));
  if (state.hovered) fill(rect, ColourRole::kControlHovered, 3.0f, 0.5);
  const float side = px(14);
  const Rect box{rect.x + px(4), std::round(rect.centreY() - side / 2), side, side};
  fill(box, on ? ColourRole::kSlider : ColourRole::kField, 3.0f);
  outline(box, state.hovered ? ColourRole::kText : ColourRole::kSlider, 3.0f);
  if (on) {
    const ImVec2 tick[] = {{box.x + side * 0.22f, box.y + side * 0.52f},
                           {box.x + side * 0.43f, box.y + side * 0.73f},
                           {box.x + side * 0.79f, box.y + side * 0.29f}};
    ImGui::GetWindowDrawList()->AddPolyline(tick, 3, colour(ColourRole::kField), 0, 2.0f * scale());
  }
  const float left = box.right() + px(8);
  text({left, rect.y, rect.right() - left, rect.height}, label);
  tooltip(id, rect, state);
  return state.pressed;
}

bool Ui::choiceRow(std::string_view id, const Rect& rect, std::string_view label, bool chosen,
                   ColourRole swatch) {
  const Press state = press(id, rect, WidgetKind::kToggle, true);
  registerWidget(id, label, WidgetKind::kToggle, rect, true, chosen ? "on" : "off", tip(id));
  ground(rect, state, {.on = chosen, .quiet = true});
  const float side = px(14);
  const Rect box{rect.x + px(4), std::round(rect.centreY() - side / 2), side, side};
  fill(box, swatch, 3.0f);
  outline(box, ColourRole::kSlider, 3.0f);
  const float left = box.right() + px(8);
  text({left, rect.y, rect.right() - left, rect.height}, label,
       {.weight = chosen ? Weight::kSemibold : Weight::kRegular});
  tooltip(id, rect, state);
  return state.pressed;
}

bool Ui::pictureButton(std::string_view id, const Rect& rect, const ButtonStyle& style) {
  const Press state = press(id, rect, WidgetKind::kButton, style.enabled);
  registerWidget(id, style.label.empty() ? words(id) : style.label,
                 style.toggle ? WidgetKind::kToggle : WidgetKind::kButton, rect, style.enabled,
                 style.toggle ? (style.on ? "on" : "off") : "", tip(id, style));
  ground(rect, state, style);
  tooltip(id, rect, state, style);
  return state.pressed;
}

std::optional<ValueChange> Ui::slider(std::string_view id, const Rect& rect, double value,
                                      const SliderStyle& style) {
  UiMemory& memory = setting_.memory;
  registerWidget(id, words(id), WidgetKind::kSlider, rect, style.enabled,
                 style.differs ? "\u2013" : number(value, style.decimals), tip(id));
  const ImGuiIO& io = ImGui::GetIO();
  const bool asked = ImGui::IsMouseDoubleClicked(0) || (io.KeyCtrl && ImGui::IsMouseClicked(0));
  const Rect typingBox = [&] {
    const float width = std::min(px(80), std::max(rect.width, px(80)));
    return Rect{std::round(std::max(
                    0.0f, std::min(rect.centreX() - width / 2, io.DisplaySize.x - width - px(4)))),
                std::round(rect.centreY() - px(12)), width, px(24)};
  }();
  const bool keyed = style.enabled && memory.focus.takeOperation(id);
  if (memory.editing != id && style.enabled && ((asked && over(rect)) || keyed)) {
    startTyping(id, style.differs ? std::string() : number(value, style.decimals));
    memory.dragging.clear();
    ImGui::ClearActiveID();
  }
  if (memory.editing == id) {
    const Typed typed = typeNumber(id, typingBox, value);
    if (!typed.value) return std::nullopt;
    return ValueChange{*typed.value, Phase::kCommit, true, typed.sum};
  }

  const Press state = press(id, rect, WidgetKind::kSlider, style.enabled);
  const float knob = px(6);
  const float from = style.vertical ? rect.bottom() - knob : rect.x + knob;
  const float way = style.vertical ? -(rect.height - 2 * knob) : rect.width - 2 * knob;
  const float pointer = style.vertical ? io.MousePos.y : io.MousePos.x;
  std::optional<ValueChange> change;
  if (state.held && std::abs(way) > 1.0f) {
    if (memory.dragging != id) {
      memory.dragging = id;
      memory.dragStart = value;
      const float at = from + way * static_cast<float>(shareOf(value, style));
      memory.dragOffset = std::abs(pointer - at) <= knob ? at - pointer : 0.0f;
    }
    const double share = static_cast<double>((pointer + memory.dragOffset - from) / way);
    double next = valueAt(share, style);
    if (io.KeyShift && style.snap > 0.0) {
      next = std::clamp(std::round(next / style.snap) * style.snap, style.least, style.most);
    }
    const bool knobMoved =
        std::abs(shareOf(next, style) - shareOf(value, style)) * std::abs(way) >= 0.5;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
      change = ValueChange{memory.dragStart, Phase::kCancel};
      memory.dragging.clear();
      ImGui::ClearActiveID();
    } else if (knobMoved) {
      value = next;
      change = ValueChange{next, Phase::kPreview};
    }
  } else if (memory.dragging == id) {
    memory.dragging.clear();
    if (value != memory.dragStart) change = ValueChange{value, Phase::kCommit};
  }

  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float at = from + way * static_cast<float>(shareOf(value, style));
  const float thick = std::max(2.0f, px(4));
  const float middle = std::round(style.vertical ? rect.centreX() : rect.centreY());
  const auto bar = [&](float a, float b, ColourRole role) {
    const Rect r = style.vertical
                       ? Rect{middle - thick / 2, std::min(a, b), thick, std::abs(b - a)}
                       : Rect{std::min(a, b), middle - thick / 2, std::abs(b - a), thick};
    fill(r, role, 2.0f);
  };
  bar(from, from + way, ColourRole::kSliderTrack);
  const double origin = style.from.value_or(style.least);
  const float filledFrom = from + way * static_cast<float>(shareOf(origin, style));
  if (style.enabled) bar(filledFrom, at, ColourRole::kSlider);
  const ImVec2 centre = style.vertical ? ImVec2(middle, at) : ImVec2(at, middle);
  const bool lively = style.enabled && (state.hovered || state.held);
  list.AddCircleFilled(
      centre, lively ? knob + px(1) : knob,
      colour(style.enabled ? ColourRole::kSliderHandle : ColourRole::kTextDisabled));
  tooltip(id, rect, state);
  return change;
}

Ui::AreaState Ui::area(std::string_view id, const Rect& rect, std::string_view value, bool tips) {
  registerWidget(id, words(id), WidgetKind::kArea, rect, true, value,
                 tips ? tip(id) : std::string());
  const Press state = press(id, rect, WidgetKind::kArea, true);
  AreaState result;
  result.hovered = state.hovered;
  result.held = state.held;
  result.pressed = state.held && ImGui::IsMouseClicked(0);
  result.released = state.pressed;
  result.doubleClicked = state.hovered && ImGui::IsMouseDoubleClicked(0);
  if (tips) tooltip(id, rect, state);
  return result;
}

}  // namespace vides
