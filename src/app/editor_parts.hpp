// SPDX-License-Identifier: MIT
// What the editor is made of; only its own files include this.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor.hpp"
#include "app/flight_pictures.hpp"
#include "app/imgui_input.hpp"
#include "edit/camera_tools.hpp"
#include "edit/texts.hpp"
#include "edit/viewport_tools.hpp"
#include "panels/flight_graphs.hpp"
#include "panels/timeline_panel.hpp"
#include "panels/ui.hpp"
#include "panels/windows.hpp"
#include "render/imgui_renderer.hpp"
#include "scene/theme.hpp"

struct ImGuiContext;

namespace vides {

// Display frames after the last event: hovering and menus take one or two to settle.
inline constexpr int kSettlingFrames = 3;

// Between two views, share 0 to 1, slow at both ends and the shorter way round.
EditorView glided(const EditorView& from, const EditorView& to, double share);

struct Editor::Parts {
  Parts(const Gl& table, EditorOptions given);
  ~Parts();
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  struct Glide {
    EditorView from, to;
    double since = 0.0;
  };

  const Gl& gl;
  EditorOptions options;
  std::string clipboardBuffer;
  FontSet fonts;  // before the context, which uses them
  ImGuiContext* context;
  Session session;
  std::optional<ImguiRenderer> imguiRenderer;
  std::unique_ptr<FlightPictures> pictures;
  std::vector<SharedDrawable> scenes;  // of both pictures, as far as they have been read
  FlightGraphs graphs;

  double scale = 0.0;  // 0 before the first frame
  Theme colours;       // the session's, as applied to Dear ImGui
  Texts texts{Language::kEnglish};
  Words words;
  Tell tell;
  NumberParser parse;
  ShortcutHint hint;

  ImguiInput input;
  UiMemory memory;
  WidgetRegistry registry;
  TimelineView timeline;
  WindowsMemory windowsMemory;
  ViewportTools tools{session};
  CameraTools cameraTools{session};
  Vec2 pointerAt{-1.0};
  Modifiers modifiers;
  // The pointer, as of the last pass: over the flight as seen from outside, over what the camera
  // sees; in whatever place each stands.
  bool overViewport = false;
  bool overCamera = false;
  PointerShape pointer = PointerShape::kArrow;

  std::optional<Glide> glide;
  double time = 0.0;
  int settling = 0;
  std::int64_t framesDrawn = 0;

  // editor.cpp
  void fitScale(double contentScale, PixelSize size);
  bool pass(const FrameInput& given);
  void draw(const FrameInput& given);
  void apply(const Actions& actions);
  bool run(const Command& command);
  void stepGlide();
  void endGlide();
  FrameOutcome outcome();
  void mend(const std::string& why);
  // editor_events.cpp
  bool notice(const InputEvent& event);
  void feed(ImGuiIO& io);
  void pointerMoved();
  bool wheelTurned(const WheelTurned& wheel);
  void focusChanged(bool focused);
  void buttonChanged(const ButtonChanged& change);
  ViewportPlace viewportPlace();
  ViewProjection filmView() const;
  PointerTarget pick(const Vec2& pixel) const;
  void keyChanged(const KeyChanged& change);
  bool countChosen(const KeyChanged& change);
  std::string shortcutOf(std::string_view commandLine) const;
  // editor_window.cpp
  Ui::Setting uiSetting();
  void window(Ui& ui, Actions& actions);
  void arrange(Ui& ui, const Rect& all, Actions& actions);
  // editor_columns.cpp
  void leftColumn(Ui& ui, const Rect& rect, bool both, Actions& actions);
  void leftPanels(Ui& ui, Stack& column, float bottom, Actions& actions);
  void rightPanels(Ui& ui, Stack& column, float bottom, Actions& actions);
  void rightColumn(Ui& ui, const Rect& rect, Actions& actions);
  // editor_window.cpp
  struct Caption {
    Rect box;
    std::string words;  // empty where there is no room
  };
  Caption viewportCaption(const Ui& ui, const Rect& rect, bool sliders) const;
  void filmText(Ui& ui, const Rect& rect);
  void freeViewSign(Ui& ui, const Rect& rect);
  void pictureArea(Ui& ui, const Rect& rect, bool film, bool small);
  void pointerSigns(Ui& ui);
  void pointerNote(Ui& ui, const std::string& told, const Vec2& at, bool refusal);
  void viewportArea(Ui& ui, const Rect& rect, Actions& actions);
  void splitters(Ui& ui, const Rect& all, const Rect& left, const Rect& right,
                 const Rect& timelineRect, bool both, Actions& actions);
  ViewportState viewportState() const;
  OutputLine outputLine() const;
  static Rect filmRoom(const Ui& ui, const Rect& rect);
};

}  // namespace vides
