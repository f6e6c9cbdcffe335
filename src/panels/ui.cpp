// SPDX-License-Identifier: MIT
// Places, texts, grounds and icons.
#include "panels/ui.hpp"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace vides {
namespace {

ImVec4 vectorOf(const Colour& c) {
  return {static_cast<float>(c.red) / 255.0f, static_cast<float>(c.green) / 255.0f,
          static_cast<float>(c.blue) / 255.0f, static_cast<float>(c.alpha) / 255.0f};
}

// Bytes of the longest beginning with at most `bytes` that ends between two characters.
std::size_t characterStart(std::string_view text, std::size_t bytes) {
  while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0) == 0x80) --bytes;
  return bytes;
}

// What the current window doesn't hide of it.
Rect visibleOf(const Rect& rect) {
  const ImRect& clip = ImGui::GetCurrentWindow()->ClipRect;
  return rect.intersect({clip.Min.x, clip.Min.y, clip.GetWidth(), clip.GetHeight()});
}

}  // namespace

float Ui::px(float atScale1) const { return std::round(atScale1 * setting_.scale); }

ImU32 Ui::colour(ColourRole role, double opacity) const {
  const Colour c = faded(setting_.theme[role], opacity);
  return IM_COL32(c.red, c.green, c.blue, c.alpha);
}

std::string Ui::words(std::string_view key) const {
  return shown(setting_.fonts, setting_.words(key));
}

std::string Ui::number(double value, int decimals) const {
  std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
  if (setting_.decimalComma) std::replace(digits.begin(), digits.end(), '.', ',');
  const bool zero = digits.find_first_of("123456789") == std::string::npos;
  return shown(setting_.fonts, value < 0.0 && !zero ? "\u2212" + digits : digits);
}

ImFont* Ui::font(Weight weight) const {
  switch (weight) {
    case Weight::kSemibold:
      return setting_.fonts.semibold;
    case Weight::kSmall:
      return setting_.fonts.small;
    case Weight::kRegular:
      break;
  }
  return setting_.fonts.regular;
}

float Ui::textWidth(std::string_view text, Weight weight) const {
  const ImFont* used = font(weight);
  return used->CalcTextSizeA(used->FontSize, FLT_MAX, 0.0f, text.data(), text.data() + text.size())
      .x;
}

void Ui::text(const Rect& box, std::string_view given, const TextStyle& style) {
  std::string words = shown(setting_.fonts, given);
  if (words.empty()) return;
  float width = textWidth(words, style.weight);
  bool shortened = false;
  if (style.mayShorten && width > box.width) {
    shortened = true;
    const std::string ending = shown(setting_.fonts, "\u2026");
    std::size_t low = 0;
    std::size_t high = words.size();  // fits with `low` bytes, not with `high`
    while (high - low > 1) {
      const std::size_t middle = (low + high) / 2;
      const std::string tried = words.substr(0, characterStart(words, middle)) + ending;
      (textWidth(tried, style.weight) <= box.width ? low : high) = middle;
    }
    words = words.substr(0, characterStart(words, low)) + ending;
    width = textWidth(words, style.weight);
  }
  const ImFont* used = font(style.weight);
  float x = box.x;
  if (style.align == Align::kRight) x = box.right() - width;
  if (style.align == Align::kCentre) x = box.x + (box.width - width) / 2.0f;
  const float y = box.y + (box.height - used->FontSize) / 2.0f;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec4 clip(box.x - 1.0f, box.y - used->FontSize, box.right() + 1.0f,
                    box.bottom() + used->FontSize);
  list.AddText(used, used->FontSize, {std::round(x), std::round(y)}, colour(style.colour),
               words.data(), words.data() + words.size(), 0.0f,
               width > box.width ? &clip : nullptr);
  const Rect place{std::round(x), std::round(y), std::min(width, box.width), used->FontSize};
  setting_.registry.addText({std::move(words), width, box.width, shortened, visibleOf(place)});
}

void Ui::valueRow(const Rect& box, std::string_view id, std::string_view label,
                  std::string_view value) {
  // The value takes what it needs, the label the rest: so both are checked for room.
  const float valueWidth =
      std::min(box.width, textWidth(shown(setting_.fonts, value), Weight::kSemibold));
  const float gap = px(8);
  text({box.x, box.y, box.width - valueWidth - gap, box.height}, label,
       {.colour = ColourRole::kTextSecondary});
  text({box.right() - valueWidth, box.y, valueWidth, box.height}, value,
       {.weight = Weight::kSemibold, .align = Align::kRight});
  registerWidget(id, label, WidgetKind::kText, box, true, value);
}

float roundingOf(const Rect& rect, float radius) {
  const float rounding = std::min(radius, 0.5f * std::min(rect.width, rect.height) - 1.0f);
  return rounding < 0.5f ? 0.0f : rounding;
}

void Ui::fill(const Rect& rect, ColourRole role, float radius, double opacity) {
  ImGui::GetWindowDrawList()->AddRectFilled({rect.x, rect.y}, {rect.right(), rect.bottom()},
                                            colour(role, opacity),
                                            roundingOf(rect, radius * scale()));
}

void Ui::outline(const Rect& rect, ColourRole role, float radius, float width) {
  ImGui::GetWindowDrawList()->AddRect({rect.x, rect.y}, {rect.right(), rect.bottom()}, colour(role),
                                      roundingOf(rect, radius * scale()), 0, width * scale());
}

void Ui::icon(Icon icon, const Rect& box, ColourRole role) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 ink = colour(role);
  const float x = std::round(box.centreX());
  const float y = std::round(box.centreY());
  const float s = px(5);  // half the height
  const float bar = std::max(1.0f, px(2));
  // Clockwise, as Dear ImGui smooths edges.
  const auto triangle = [&](float from, float to) {
    list.AddTriangleFilled({from, y - s}, {to, y}, {from, y + s}, ink);
  };
  const auto rectangle = [&](float left, float width) {
    list.AddRectFilled({left, y - s}, {left + width, y + s}, ink);
  };
  const auto chevron = [&](ImVec2 a, ImVec2 b, ImVec2 c) {
    const ImVec2 points[] = {a, b, c};
    list.AddPolyline(points, 3, ink, 0, 1.5f * scale());
  };
  const float h = px(3);
  switch (icon) {
    case Icon::kPlay:
      triangle(x - px(3), x + px(5));
      break;
    case Icon::kPause:
      rectangle(x - px(4), px(3));
      rectangle(x + px(1), px(3));
      break;
    case Icon::kFirst:
      rectangle(x - px(6), bar);
      list.AddTriangleFilled({x + px(5), y - s}, {x + px(5), y + s}, {x - px(3), y}, ink);
      break;
    case Icon::kLast:
      triangle(x - px(5), x + px(3));
      rectangle(x + px(6) - bar, bar);
      break;
    case Icon::kChevronLeft:
      chevron({x + h / 2, y - h}, {x - h / 2, y}, {x + h / 2, y + h});
      break;
    case Icon::kChevronRight:
      chevron({x - h / 2, y - h}, {x + h / 2, y}, {x - h / 2, y + h});
      break;
    case Icon::kChevronDown:
      chevron({x - h, y - h / 2}, {x, y + h / 2}, {x + h, y - h / 2});
      break;
    case Icon::kChevronUp:
      chevron({x - h, y + h / 2}, {x, y - h / 2}, {x + h, y + h / 2});
      break;
    case Icon::kClose: {
      const float d = std::round(3.5f * setting_.scale);
      list.AddLine({x - d, y - d}, {x + d, y + d}, ink, 1.5f * scale());
      list.AddLine({x - d, y + d}, {x + d, y - d}, ink, 1.5f * scale());
      break;
    }
    case Icon::kInsert: {
      // The playhead, and a plus beside it.
      const float left = std::round(x - px(4)), half = px(5);
      const float line = std::max(1.0f, std::round(scale()));
      const float thick = std::max(1.0f, std::round(1.5f * scale()));
      list.AddTriangleFilled({left - half, y - px(6)}, {left + half, y - px(6)}, {left, y + px(1)},
                             ink);
      list.AddRectFilled({left - line / 2, y - px(2)}, {left + line / 2, y + px(7)}, ink);
      const float arm = px(3.5f), right = std::round(x + px(6));
      list.AddRectFilled({right - arm, y - thick / 2}, {right + arm, y + thick / 2}, ink);
      list.AddRectFilled({right - thick / 2, y - arm}, {right + thick / 2, y + arm}, ink);
      break;
    }
    case Icon::kLoop:
      list.PathArcTo({x, y}, s, -0.4f, 4.6f);
      list.PathStroke(ink, 0, 1.5f * scale());
      list.AddTriangleFilled({x - px(3), y - s}, {x + px(3), y - s - px(3)},
                             {x + px(3), y - s + px(3)}, ink);
      break;
  }
}

void Ui::registerWidget(std::string_view id, std::string_view label, WidgetKind kind,
                        const Rect& rect, bool enabled, std::string_view value, std::string tip) {
  setting_.registry.add({std::string(id), std::string(label), kind, rect, visibleOf(rect),
                         std::string(value), enabled, std::move(tip)});
}

void Ui::entry(std::string_view id, const Rect& rect, std::string_view label,
               std::string_view value) {
  registerWidget(id, label, WidgetKind::kEntry, rect, true, value);
}

void Ui::choice(std::string_view id, const Rect& rect, std::string_view value) {
  registerWidget(id, words(id), WidgetKind::kChoice, rect, true, value);
}

void Ui::shows(std::string_view id, const Rect& rect, std::string_view value) {
  registerWidget(id, words(id), WidgetKind::kText, rect, true, value);
}

void Ui::note(std::string_view id, std::string_view label, WidgetKind kind, bool enabled,
              std::string_view value) {
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 size = ImGui::GetItemRectSize();
  registerWidget(id, label, kind, {low.x, low.y, size.x, size.y}, enabled, value, tip(id));
  tooltip(id, {low.x, low.y, size.x, size.y}, {ImGui::IsItemHovered(), false, false}, {}, true);
}

void Ui::menu(std::string_view id, const Rect& rect, std::string_view label, bool enabled,
              bool open) {
  setting_.registry.add({std::string(id), std::string(label), WidgetKind::kMenu, rect, rect,
                         open ? "open" : "", enabled});
}

Rect Stack::row(float heightAtScale1) { return room(ui_->tall(heightAtScale1)); }

Rect Stack::room(float pixels) {
  const Rect result{x_, y_, width_, pixels};
  y_ += pixels;
  return result;
}

void Stack::gap(float heightAtScale1) { y_ += ui_->tall(heightAtScale1); }

std::vector<Rect> split(const Ui& ui, const Rect& row, int parts, float gapAtScale1) {
  std::vector<Rect> result;
  const float gap = ui.px(gapAtScale1);
  const float each = (row.width - gap * static_cast<float>(parts - 1)) / static_cast<float>(parts);
  for (int i = 0; i < parts; ++i) {
    const float left = std::round(row.x + static_cast<float>(i) * (each + gap));
    const float right = std::round(row.x + static_cast<float>(i) * (each + gap) + each);
    result.push_back({left, row.y, right - left, row.height});
  }
  return result;
}

std::vector<Rect> splitFor(const Ui& ui, const Rect& row, const std::vector<std::string>& labels) {
  std::vector<Rect> boxes = split(ui, row, static_cast<int>(labels.size()));
  float all = 0.0f;
  bool fit = true;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    all += ui.textWidth(labels[i]);
    fit = fit && ui.textWidth(labels[i]) + ui.px(4) <= boxes[i].width;
  }
  if (fit) return boxes;
  const auto count = static_cast<float>(labels.size());
  const float margin = (row.width - all - (count - 1.0f) * ui.px(4)) / count;
  float x = row.x;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    boxes[i] = {std::floor(x), row.y, std::floor(ui.textWidth(labels[i]) + margin), row.height};
    x += ui.textWidth(labels[i]) + margin + ui.px(4);
  }
  return boxes;
}

void panel(Ui& ui, Stack& column, std::string_view headingKey,
           const std::function<void(Stack&)>& content) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float padding = ui.px(8), foot = ui.tall(8);
  const float top = column.y();
  list.ChannelsSplit(2);
  list.ChannelsSetCurrent(1);
  Stack inner(ui, column.x() + padding, top + ui.tall(4), column.width() - 2 * padding);
  ui.text(inner.row(24), ui.words(headingKey), {.weight = Weight::kSemibold});
  inner.gap(2);
  content(inner);
  const float bottom = inner.y() + foot;
  list.ChannelsSetCurrent(0);
  const Rect ground{column.x(), top, column.width(), bottom - top};
  ui.fill(ground, ColourRole::kPanel, 5.0f);
  if (ui.divider() != ColourRole::kWindow) ui.outline(ground, ui.divider(), 5.0f);
  list.ChannelsMerge();
  column = Stack(ui, column.x(), bottom + foot, column.width());
}

float panelFoot(const Ui& ui) { return 2 * ui.tall(8); }

float panelHeight(const Ui& ui) { return ui.tall(4) + ui.tall(24) + ui.tall(2) + panelFoot(ui); }

Rect panelCaption(Ui& ui, const Stack& column, float top, std::string_view words) {
  const Rect heading{column.x() + ui.px(8), top + ui.tall(4), column.width() - 2 * ui.px(8),
                     ui.tall(24)};
  ui.text(heading, words, {.colour = ColourRole::kTextSecondary, .align = Align::kRight});
  return heading;
}

void applyStyle(ImGuiStyle& style, const Theme& theme, float scale) {
  style = ImGuiStyle();
  const auto px = [scale](float v) { return std::round(v * scale); };
  style.WindowPadding = {px(12), px(12)};
  style.FramePadding = {px(8), px(4)};
  style.ItemSpacing = {px(8), px(6)};
  style.ItemInnerSpacing = {px(8), px(4)};
  style.ScrollbarSize = px(8);
  style.ScrollbarRounding = px(4);
  style.WindowRounding = px(6);
  style.ChildRounding = 0.0f;
  style.PopupRounding = px(5);
  style.FrameRounding = px(3);
  style.GrabRounding = px(3);
  style.WindowBorderSize = 0.0f;
  style.ChildBorderSize = 0.0f;
  style.PopupBorderSize = std::max(1.0f, px(1));
  style.WindowMinSize = {1.0f, 1.0f};
  style.CurveTessellationTol = 1.0f;
  style.CircleTessellationMaxError = 0.2f;
  style.DisabledAlpha = 1.0f;  // disabled colours come from the theme
  const auto set = [&](ImGuiCol slot, ColourRole role, double opacity = 1.0) {
    style.Colors[slot] = vectorOf(faded(theme[role], opacity));
  };
  set(ImGuiCol_Text, ColourRole::kText);
  set(ImGuiCol_TextDisabled, ColourRole::kTextDisabled);
  set(ImGuiCol_WindowBg, ColourRole::kPanel);
  set(ImGuiCol_ChildBg, ColourRole::kColumn, 0.0);
  set(ImGuiCol_PopupBg, ColourRole::kPanel);
  set(ImGuiCol_Border, ColourRole::kBorder);
  set(ImGuiCol_FrameBg, ColourRole::kField);
  set(ImGuiCol_FrameBgHovered, ColourRole::kField);
  set(ImGuiCol_FrameBgActive, ColourRole::kField);
  set(ImGuiCol_TitleBg, ColourRole::kPanel);
  set(ImGuiCol_TitleBgActive, ColourRole::kPanel);
  set(ImGuiCol_TitleBgCollapsed, ColourRole::kPanel);
  set(ImGuiCol_MenuBarBg, ColourRole::kWindow);
  set(ImGuiCol_ScrollbarBg, ColourRole::kColumn, 0.0);
  set(ImGuiCol_ScrollbarGrab, ColourRole::kTextDisabled);
  set(ImGuiCol_ScrollbarGrabHovered, ColourRole::kTextSecondary);
  set(ImGuiCol_ScrollbarGrabActive, ColourRole::kTextSecondary);
  set(ImGuiCol_CheckMark, ColourRole::kText);
  set(ImGuiCol_SliderGrab, ColourRole::kSliderHandle);
  set(ImGuiCol_SliderGrabActive, ColourRole::kSliderHandle);
  set(ImGuiCol_Button, ColourRole::kControl);
  set(ImGuiCol_ButtonHovered, ColourRole::kControlHovered);
  set(ImGuiCol_ButtonActive, ColourRole::kControlActive);
  set(ImGuiCol_Header, ColourRole::kControl);
  set(ImGuiCol_HeaderHovered, ColourRole::kControlHovered);
  set(ImGuiCol_HeaderActive, ColourRole::kControlActive);
  set(ImGuiCol_Separator, ColourRole::kBorder);
  set(ImGuiCol_TextSelectedBg, ColourRole::kControlActive);
  set(ImGuiCol_ModalWindowDimBg, ColourRole::kWindow, 0.6);
}

}  // namespace vides
