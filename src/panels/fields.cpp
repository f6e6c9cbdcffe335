// SPDX-License-Identifier: MIT
// Fields: texts and numbers that are typed, dragged sideways and turned by the wheel.
#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "edit/sum.hpp"
#include "flight/printable.hpp"
#include "panels/file_names.hpp"
#include "panels/ui.hpp"

namespace vides {
namespace {

constexpr std::size_t kMostTyped = 4096;  // bytes: a name of 1,000 characters

// A value moved by units of its last decimal: one that has no more decimals gets none.
double inUnits(double value, double units, int decimals) {
  if (units == 0.0) return value;
  const double tens = std::pow(10.0, decimals);
  const double whole = std::round(value * tens);
  const bool plain = std::abs(whole / tens - value) <= 1e-12 * std::max(1.0, std::abs(value));
  return plain ? (whole + units) / tens : value + units / tens;
}

}  // namespace

bool Ui::opensByKeyboard(std::string_view id) {
  KeyboardFocus& focus = setting_.memory.focus;
  const bool arrived = focus.takeArrival(id);
  return arrived || focus.takeOperation(id);
}

void Ui::startTyping(std::string_view id, std::string words) {
  setting_.memory.editing = id;
  setting_.memory.focus.give(id);
  setting_.memory.before = words;
  setting_.memory.buffer = std::move(words);
  setting_.memory.editingStarted = true;  // it takes the keyboard as soon as it can
  // Room for a whole field; what is shown elsewhere is looked up anew.
  if (setting_.memory.wide.room() < kMostTyped / 3) setting_.memory.wide.clear();
}

// Nothing while it is typed; then the text, or nothing with `ended` where it was given up.
std::optional<std::string> Ui::textEditor(std::string_view id, const Rect& rect, bool& ended) {
  UiMemory& memory = setting_.memory;
  char buffer[kMostTyped] = {};
  memory.wide.foldedName(memory.buffer).copy(buffer, kMostTyped - 1);
  ImFont* used = font(Weight::kRegular);
  const float vertical = std::floor((rect.height - used->FontSize) / 2.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(6), vertical));
  ImGui::SetCursorScreenPos({rect.x, rect.y});
  ImGui::PushItemWidth(rect.width);
  const std::string label = "###" + std::string(id) + "/typing";
  if (memory.editingStarted && !ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
  const bool entered =
      ImGui::InputText(label.c_str(), buffer, kMostTyped,
                       ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue);
  const bool left = ImGui::IsItemDeactivated();
  if (ImGui::IsItemActive()) memory.editingStarted = true;
  ImGui::PopItemWidth();
  ImGui::PopStyleVar();
  outline(rect, ColourRole::kText, 3.0f);
  memory.buffer = memory.wide.unfolded(buffer);
  const bool asked = std::exchange(memory.endTyping, false);
  ended = entered || left || asked;
  if (!ended) return std::nullopt;
  if (asked) ImGui::ClearActiveID();
  memory.editing.clear();
  memory.editingStarted = false;
  // Tab goes on from here; Enter, Escape and a click elsewhere leave it.
  if (!memory.focus.walking()) memory.focus.drop();
  // Who only looked has typed nothing: what is shown may be rounded.
  const bool given =
      (entered || asked || !ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) &&
      memory.buffer != memory.before;
  return given ? std::optional(memory.buffer) : std::nullopt;
}

Ui::Typed Ui::typeNumber(std::string_view id, const Rect& rect, double own,
                         std::string_view suffix) {
  bool ended = false;
  const auto typed = textEditor(id, rect, ended);
  if (!ended || !typed) return {};
  std::string_view text = *typed;
  const auto trim = [&] {
    while (text.ends_with(' ')) text.remove_suffix(1);
    while (text.starts_with(' ')) text.remove_prefix(1);
  };
  // The field's unit may stand behind the number, as it is shown.
  const std::size_t unit = suffix.find_first_not_of(' ');
  trim();
  if (unit != std::string_view::npos && text.ends_with(suffix.substr(unit))) {
    text.remove_suffix(suffix.size() - unit);
    trim();
  }
  const auto value = evaluateSum(text, own);
  if (!value) {
    setting_.memory.refused = value.error();
    return {};
  }
  Typed result;
  result.value = *value;
  if (startsFromOwn(text)) result.sum = text;
  return result;
}

// What the hand does to a number without typing.
Ui::Typed Ui::turnNumber(std::string_view id, const Press& press, double value,
                         const FieldStyle& style) {
  UiMemory& memory = setting_.memory;
  const ImGuiIO& io = ImGui::GetIO();
  if (press.held && memory.held != id) {
    memory.held = id;
    memory.heldAt = io.MousePos.x;
    memory.dragStart = value;
  }
  if (memory.held == id) {
    const bool moved = std::abs(io.MousePos.x - memory.heldAt) >= io.MouseDragThreshold * scale();
    if (press.held && moved && memory.dragging != id) memory.dragging = id;
    if (memory.dragging == id) return dragNumber(value, style);
    if (!press.held) memory.held.clear();
    if (press.pressed)
      startTyping(id, style.differs ? std::string() : number(value, style.decimals));
    return {};
  }
  if (opensByKeyboard(id)) {
    startTyping(id, style.differs ? std::string() : number(value, style.decimals));
    return {};
  }
  if (press.hovered && io.KeyCtrl && io.MouseWheel != 0.0f && !press.held)
    return wheelNumber(id, value, style);
  if (!press.hovered && memory.wheeled == id) memory.wheeled.clear();
  return {};
}

Ui::Typed Ui::dragNumber(double value, const FieldStyle& style) {
  constexpr double kCoarse = 10.0;  // with Shift, in steps of as many units
  UiMemory& memory = setting_.memory;
  const ImGuiIO& io = ImGui::GetIO();
  ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  const auto to = [&](double next, Phase phase) {
    // Of several numbers each goes as far.
    Typed typed;
    typed.value = next;
    typed.gesture = true;
    typed.phase = phase;
    if (style.differs) typed.sum = fmt::format("+={}", next - value);
    return typed;
  };
  const auto end = [&] {
    memory.dragging.clear();
    memory.held.clear();
  };
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
    end();
    ImGui::ClearActiveID();
    return to(memory.dragStart, Phase::kCancel);
  }
  if (!io.MouseDown[0]) {
    end();
    return to(value, Phase::kCommit);
  }
  double units = std::trunc(static_cast<double>((io.MousePos.x - memory.heldAt) / scale()));
  if (io.KeyShift) units = std::trunc(units / kCoarse) * kCoarse;
  const double next = inUnits(memory.dragStart, units, style.decimals);
  return next == value ? Typed{} : to(next, Phase::kPreview);
}

Ui::Typed Ui::wheelNumber(std::string_view id, double value, const FieldStyle& style) {
  constexpr double kRunSeconds = 1.0;  // from a notch to the next of the same run
  UiMemory& memory = setting_.memory;
  const bool goesOn = memory.wheeled == id && setting_.time - memory.wheeledAt < kRunSeconds;
  // Wheels that turn in parts of notches count when a whole one is reached.
  const double turned =
      (goesOn ? memory.wheelRest : 0.0) + static_cast<double>(ImGui::GetIO().MouseWheel);
  const double notches = std::trunc(turned);
  memory.wheelRest = turned - notches;
  Typed typed;
  typed.continues = goesOn;
  if (notches != 0.0) {
    typed.value = inUnits(value, notches, style.decimals);
    if (style.differs) typed.sum = fmt::format("+={}", inUnits(0.0, notches, style.decimals));
  }
  memory.wheeled = id;
  memory.wheeledAt = setting_.time;
  return typed;
}

Ui::Typed Ui::field(std::string_view id, const Rect& rect, double value, const FieldStyle& style) {
  const std::string dash = "\u2013";
  const std::string shownValue = style.differs ? dash : number(value - style.base, style.decimals);
  const bool takesText = style.enabled && !style.readOnly;
  registerWidget(id, words(id), style.readOnly ? WidgetKind::kText : WidgetKind::kField, rect,
                 style.enabled, shownValue, tip(id));
  if (setting_.memory.editing == id) return typeNumber(id, rect, value, style.suffix);
  const Press state = press(id, rect, WidgetKind::kField, takesText);
  const bool hovered = state.hovered;
  Typed turned;
  if (takesText) {
    turned = turnNumber(id, state, value, style);
    if (setting_.memory.editing == id) return typeNumber(id, rect, value, style.suffix);
  }
  if (!style.readOnly) {
    fill(rect, ColourRole::kField, 3.0f);
    edge(rect);
  }
  if (takesText && (hovered || state.held)) {
    outline(rect, ColourRole::kControlHovered, 3.0f);
    if (setting_.memory.dragging != id) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
  }
  // A long number gives up the air around it, decimals but two, the words before it, then the last
  // decimals. It is typed with all of them.
  std::string tail = style.differs ? dash : shownValue + style.suffix;
  float words = style.prefix.empty() ? 0.0f : textWidth(style.prefix) + px(2);
  const auto fits = [&](float inset) {
    return textWidth(tail, style.weight) + words <= rect.width - 2 * inset;
  };
  const float inset = fits(px(4)) ? px(4) : kTightInset * scale();
  int decimals = style.decimals;
  const auto shorten = [&](int least) {
    while (!style.differs && decimals > least && !fits(inset)) {
      tail = number(value - style.base, --decimals) + style.suffix;
    }
  };
  shorten(2);
  if (!fits(inset)) words = 0.0f;
  shorten(0);
  const Rect inside{rect.x + inset, rect.y, rect.width - 2 * inset, rect.height};
  const float room = textWidth(tail, style.weight);
  if (words > 0.0f && room + words <= inside.width) {
    text({inside.x, inside.y, inside.width - room - px(2), inside.height}, style.prefix,
         {.colour = ColourRole::kTextSecondary});
  }
  const float taken = std::min(room, inside.width);
  const float left = (inside.width - taken) * (style.centred ? 0.5f : 1.0f);
  text({inside.x + left, inside.y, taken, inside.height}, tail,
       {.colour = style.enabled ? ColourRole::kText : ColourRole::kTextDisabled,
        .weight = style.weight,
        .align = Align::kRight,
        .mayShorten = true});
  const bool whole = style.base == 0.0 || style.differs;
  tooltip(id, rect, state, {.tooltip = whole ? std::string() : number(value, style.decimals)});
  return turned;
}

std::optional<std::string> Ui::textField(std::string_view id, const Rect& rect,
                                         std::string_view value, bool path) {
  registerWidget(id, words(id), WidgetKind::kField, rect, true, value, tip(id));
  Press state;
  if (setting_.memory.editing != id) {
    state = press(id, rect, WidgetKind::kField, true);
    if (state.pressed || opensByKeyboard(id)) startTyping(id, std::string(value));
  }
  if (setting_.memory.editing == id) {
    bool ended = false;
    return textEditor(id, rect, ended);
  }
  fill(rect, ColourRole::kField, 3.0f);
  edge(rect);
  if (state.hovered) {
    outline(rect, ColourRole::kControlHovered, 3.0f);
    ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
  }
  const float inset = px(6);
  const Rect room{rect.x + inset, rect.y, rect.width - 2 * inset, rect.height};
  const std::string whole = path ? shownName(*this, value) : printable(value);
  std::string shownText = whole;
  for (std::size_t slash = 0; path && textWidth(shownText) > room.width;) {
    slash = whole.find('/', slash + 1);
    if (slash == std::string::npos) break;
    shownText = "\u2026" + whole.substr(slash);
  }
  text(room, shownText, {.mayShorten = true});
  tooltip(id, rect, state);
  return std::nullopt;
}

}  // namespace vides
