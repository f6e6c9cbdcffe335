// SPDX-License-Identifier: MIT
// Feeds what the user did to Dear ImGui.
#include "app/imgui_input.hpp"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <optional>
#include <utility>

namespace vides {
namespace {

void setModifiers(ImGuiIO& io, const Modifiers& modifiers) {
  io.KeyCtrl = modifiers.control;
  io.KeyShift = modifiers.shift;
  io.KeyAlt = modifiers.alt;
  io.KeySuper = modifiers.super;
}

template <class... Cases>
struct Match : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Match(Cases...) -> Match<Cases...>;

// Pixels and steps that no screen and no wheel has.
constexpr double kFarthestPixel = 1e5;
constexpr double kMostSteps = 1e3;

// What a window system (or a script) says, bounded; nothing where it says no number.
std::optional<InputEvent> withinReason(const InputEvent& event) {
  const auto bounded = [](double value, double most) { return std::clamp(value, -most, most); };
  if (const auto* moved = std::get_if<PointerMoved>(&event)) {
    if (std::isnan(moved->x) || std::isnan(moved->y)) return std::nullopt;
    return PointerMoved{bounded(moved->x, kFarthestPixel), bounded(moved->y, kFarthestPixel)};
  }
  if (const auto* wheel = std::get_if<WheelTurned>(&event)) {
    if (std::isnan(wheel->x) || std::isnan(wheel->y)) return std::nullopt;
    return WheelTurned{bounded(wheel->x, kMostSteps), bounded(wheel->y, kMostSteps)};
  }
  return event;
}

// Whether the event ends a portion.
bool apply(ImGuiIO& io, const InputEvent& event,
           const std::function<std::string(std::string_view)>& folded) {
  return std::visit(
      Match{[&](const PointerMoved& moved) {
              io.MousePos = {static_cast<float>(moved.x), static_cast<float>(moved.y)};
              return false;
            },
            [&](const PointerLeft&) {
              io.MousePos = {-FLT_MAX, -FLT_MAX};
              return false;
            },
            [&](const ButtonChanged& change) {
              // Dear ImGui: 0 left, 1 right, 2 middle.
              constexpr int kIndex[] = {0, 2, 1};
              io.MouseDown[kIndex[static_cast<int>(change.button)]] = change.pressed;
              setModifiers(io, change.modifiers);
              return true;
            },
            [&](const WheelTurned& wheel) {
              io.MouseWheel += static_cast<float>(wheel.y);
              io.MouseWheelH += static_cast<float>(wheel.x);
              return true;
            },
            [&](const KeyChanged& change) {
              io.KeysDown[static_cast<std::size_t>(change.key)] = change.pressed;
              setModifiers(io, change.modifiers);
              return true;
            },
            [&](const TextTyped& typed) {
              io.AddInputCharactersUTF8(folded(typed.text).c_str());
              return true;
            },
            [](const auto&) { return true; }},
      event);
}

}  // namespace

void ImguiInput::announce(ImGuiIO& io) {
  static_assert(kKeyCount < static_cast<int>(IM_ARRAYSIZE(ImGuiIO::KeysDown)));
  const std::pair<ImGuiKey, KeyboardKey> keys[] = {
      {ImGuiKey_Tab, KeyboardKey::kTab},
      {ImGuiKey_LeftArrow, KeyboardKey::kLeft},
      {ImGuiKey_RightArrow, KeyboardKey::kRight},
      {ImGuiKey_UpArrow, KeyboardKey::kUp},
      {ImGuiKey_DownArrow, KeyboardKey::kDown},
      {ImGuiKey_PageUp, KeyboardKey::kPageUp},
      {ImGuiKey_PageDown, KeyboardKey::kPageDown},
      {ImGuiKey_Home, KeyboardKey::kHome},
      {ImGuiKey_End, KeyboardKey::kEnd},
      {ImGuiKey_Insert, KeyboardKey::kInsert},
      {ImGuiKey_Delete, KeyboardKey::kDelete},
      {ImGuiKey_Backspace, KeyboardKey::kBackspace},
      {ImGuiKey_Space, KeyboardKey::kSpace},
      {ImGuiKey_Enter, KeyboardKey::kEnter},
      {ImGuiKey_Escape, KeyboardKey::kEscape},
      {ImGuiKey_KeyPadEnter, KeyboardKey::kPadEnter},
      {ImGuiKey_A, KeyboardKey::kA},
      {ImGuiKey_C, KeyboardKey::kC},
      {ImGuiKey_V, KeyboardKey::kV},
      {ImGuiKey_X, KeyboardKey::kX},
      {ImGuiKey_Y, KeyboardKey::kY},
      {ImGuiKey_Z, KeyboardKey::kZ},
  };
  for (const auto& [theirs, ours] : keys) io.KeyMap[theirs] = static_cast<int>(ours);
  io.MousePos = {-FLT_MAX, -FLT_MAX};
}

void ImguiInput::add(const std::vector<InputEvent>& events) {
  for (const InputEvent& event : events) {
    if (auto good = withinReason(event)) events_.push_back(std::move(*good));
  }
}

void ImguiInput::feed(ImGuiIO& io, const std::function<bool(const InputEvent&)>& seen,
                      const std::function<std::string(std::string_view)>& folded) {
  bool moved = false;
  while (!events_.empty()) {
    // What is pressed is found under the pointer: it has to have got there before.
    const bool moves = std::holds_alternative<PointerMoved>(events_.front());
    if (moved && !moves) return;
    moved = moves;
    const InputEvent event = std::move(events_.front());
    events_.pop_front();
    if (seen(event) || apply(io, event, folded)) return;
  }
}

void ImguiInput::release(ImGuiIO& io) {
  std::fill(std::begin(io.MouseDown), std::end(io.MouseDown), false);
  std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
  setModifiers(io, {});
}

}  // namespace vides
