// SPDX-License-Identifier: MIT
// The whole editor but for its window: input events and the time go in, one display frame comes
// out.
//
// The window (app/open_editor.hpp) and scripts (app/drive) run the same object. Belongs to the
// thread of its OpenGL context, and to no other while it exists. Several may share a thread, also
// with other users of Dear ImGui: whose context of it is current is the same after each call.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "edit/session.hpp"
#include "edit/shortcuts.hpp"
#include "input/input_event.hpp"
#include "panels/actions.hpp"
#include "panels/fonts.hpp"
#include "panels/widget_registry.hpp"
#include "render/failure.hpp"
#include "render/gl_functions.hpp"

struct ImGuiContext;

namespace vides {

struct EditorOptions {
  std::function<std::string()> clipboard;
  std::function<void(const std::string&)> setClipboard;
  // View changes by key glide in 150 ms; off where a script wants to see them at once.
  bool glide = true;
  // Work in threads is waited for in the display frame that began it: scripts see what came of it.
  bool waitForWork = false;
  FontSet fonts;  // built ahead, or empty
  // Makes the context of `gl` current where it isn't, at the beginning of each call, and at the end
  // of the editor; without it the caller does so.
  std::function<void()> makeCurrent;
  // Told of every command that did what it says, and of every shortcut that was pressed.
  std::function<void(const Command&)> ran;
  std::function<void(const Shortcut&)> pressed;
  // Told of everything that the session says in the output line.
  std::function<void(MessageKind, const Text&)> said;
};

// What one display frame is made from.
struct FrameInput {
  std::vector<InputEvent> events;  // since the last one, oldest first
  double time = 0.0;               // seconds, never less than before
  PixelSize size;
  double contentScale = 1.0;
};

enum class PointerShape { kArrow, kText, kHand, kHorizontal, kVertical, kMove };

struct FrameOutcome {
  // Seconds until the next display frame is wanted, 0 being at once; nothing: when something
  // happens.
  std::optional<double> nextFrameIn;
  PointerShape pointer = PointerShape::kArrow;
  std::string title;
  bool fullScreen = false;
  bool quit = false;
};

class Editor {
 public:
  // Error: a sentence, what OpenGL refused.
  static tl::expected<std::unique_ptr<Editor>, std::string> create(const Gl& gl,
                                                                   EditorOptions options);
  ~Editor();
  Editor(const Editor&) = delete;
  Editor& operator=(const Editor&) = delete;

  // Draws into the framebuffer that is bound, which has depth and stencil and is of that size. An
  // empty size draws nothing; events are taken all the same. Where it throws (memory, say), nothing
  // of the session is lost, the output line tells, and the next display frame may be drawn.
  FrameOutcome frame(const FrameInput& input);

  // Measures a long flight to the end without drawing: what display frames do in portions, where
  // the last one showed the measures. Reports frames done and frames altogether.
  void finishMeasures(const std::function<void(std::int64_t, std::int64_t)>& report);

  // A command by name, as from a menu: view changes may glide. False where it was refused or
  // failed.
  bool run(const Command& command);

  Session& session();
  const Session& session() const;
  // As of the last frame.
  const WidgetRegistry& widgets() const;
  // What the session says, in the current language.
  std::string words(const Text& text) const;
  // A widget's label, also of one that is not on screen.
  std::string label(std::string_view id) const;
  double contentScale() const;
  // Where the viewport's picture is.
  Rect viewport() const;
  // Whether the pointer is over one of the two pictures, where the wheel doesn't scroll.
  bool overPicture() const;
  Layout layout() const;
  void setLayout(const Layout& layout);
  // Display frames drawn so far.
  std::int64_t framesDrawn() const;
  // Dear ImGui's, for looking at what was drawn; current only while a call of the editor runs.
  ImGuiContext* context() const;
  struct Parts;  // of editor_parts.hpp

 private:
  explicit Editor(std::unique_ptr<Parts> parts);
  FrameOutcome frameOrThrow(const FrameInput& input);
  std::unique_ptr<Parts> parts_;
};

}  // namespace vides
