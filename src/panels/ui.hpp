// SPDX-License-Identifier: MIT
// What panels are made of: places on the 4-pixel grid, texts in boxes, and our own widgets.
//
// Dear ImGui carries input, text editing, menus and draw lists; how things look and where they
// stand is decided here. All places are in pixels of the picture. Each widget has an identifier
// AREA/NAME, which is the ### part of its label, and tells the registry where it stands.
#pragma once

#include <imgui.h>

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "edit/text.hpp"
#include "panels/fonts.hpp"
#include "panels/wide_characters.hpp"
#include "panels/widget_registry.hpp"
#include "scene/theme.hpp"

namespace vides {

enum class Align { kLeft, kCentre, kRight };
enum class Weight { kRegular, kSemibold, kSmall };

struct TextStyle {
  ColourRole colour = ColourRole::kText;
  Weight weight = Weight::kRegular;
  Align align = Align::kLeft;
  bool mayShorten = false;  // a text of the user's: ends with … where it is too long
};

// What a hand does to a value: while it moves, previews; the last one commits.
enum class Phase { kPreview, kCommit, kCancel };
struct ValueChange {
  double value = 0.0;
  Phase phase = Phase::kCommit;
  bool typed = false;  // then all digits count, and it may lie outside the slider's range
};

struct ButtonStyle {
  bool enabled = true;
  bool on = false;      // a toggle's state
  bool toggle = false;  // tells lists of widgets that it is one
  bool quiet = false;   // no ground until the pointer is over it
  bool enter = false;   // the one that Enter stands for: it has a rim
  Align align = Align::kCentre;
  std::string tooltip = {};  // in words; empty: that of the identifier, if it has one
  std::string command = {};  // its line: its keys are told too, and its title where nothing is said
};

struct SliderStyle {
  double least = 0.0;
  double most = 1.0;
  bool logarithmic = false;
  bool vertical = false;  // the least is at the bottom
  bool enabled = true;
  int decimals = 2;
  double snap = 0.0;                // with Shift it is dragged in multiples of this; 0 = it is not
  std::optional<double> from = {};  // where its filled part begins; absent: at the least
};

struct FieldStyle {
  int decimals = 3;
  std::string prefix = {};  // in the secondary colour, at the left: "x"
  std::string suffix = {};  // behind the number: " s"
  bool enabled = true;
  bool readOnly = false;  // shown like text, without a ground
  Weight weight = Weight::kRegular;
  bool centred = false;  // else at the right, in line with numbers above and below
};

// The triangles and bars that the typeface lacks.
enum class Icon {
  kPlay,
  kPause,
  kFirst,
  kLast,
  kChevronLeft,
  kChevronRight,
  kChevronDown,
  kChevronUp,
  kLoop,
  kInsert,
  kClose
};

// What stays between display frames: the field that is being typed into, the slider being dragged.
struct UiMemory {
  std::string editing;  // identifier of the field or slider that takes text
  std::string buffer;   // what was typed
  WideCharacters wide;  // of what is being typed, wherever
  std::string before;   // what stood there
  bool editingStarted = false;
  std::string dragging;       // slider
  double dragStart = 0.0;     // its value at the press
  float dragOffset = 0.0f;    // from the pointer to its knob
  std::string tooltipFor;     // the widget under the pointer …
  double tooltipSince = 0.0;  // … and since when
  // Characters in names that the typeface has no sign for.
  std::set<char32_t> foreign;
};

// Words in the current language for a key of the translation table; empty where it has none.
using Words = std::function<std::string(std::string_view key)>;
// What the session says, in the current language.
using Tell = std::function<std::string(const Text&)>;
// What the keyboard has for a command's line ("Ctrl+Z"); empty where it has nothing.
using ShortcutHint = std::function<std::string(std::string_view commandLine)>;
// A number as typed by the user; nothing where it is none.
using NumberParser = std::function<std::optional<double>(std::string_view)>;

// How round a rectangle's corners can be: at most `radius`, and none rather than less than half a
// pixel. With a rounding of a millionth Dear ImGui 1.86 divides by zero.
float roundingOf(const Rect& rect, float radius);

class Ui {
 public:
  struct Setting {
    const Fonts& fonts;
    const Theme& theme;
    const Words& words;
    const Tell& tell;
    const NumberParser& parse;
    const ShortcutHint& hint;
    WidgetRegistry& registry;
    UiMemory& memory;
    float scale = 1.0f;
    double time = 0.0;
    bool decimalComma = false;
  };
  // At content scale 1: between a field's edge and its number where there is little room.
  static constexpr float kTightInset = 2.0f;

  explicit Ui(const Setting& setting) : setting_(setting) {}

  float scale() const { return setting_.scale; }
  // Pixels at the content scale, whole.
  float px(float atScale1) const;
  // Heights of panels' rows and the gaps between them: in a low column closer than drawn (1).
  float density() const { return density_; }
  void setDensity(float density) { density_ = density; }
  float tall(float atScale1) const { return px(atScale1 * density_); }
  // Where windows may stand: below the menu bar, apart from the edges.
  const Rect& workArea() const { return workArea_; }
  void setWorkArea(const Rect& area) { workArea_ = area; }
  double time() const { return setting_.time; }
  ImU32 colour(ColourRole role, double opacity = 1.0) const;
  const Theme& theme() const { return setting_.theme; }
  // Of the lines between grounds: darker than these, or bright where all grounds are black.
  ColourRole divider() const {
    const bool alike = theme()[ColourRole::kColumn] == theme()[ColourRole::kWindow];
    return alike ? ColourRole::kGuide : ColourRole::kWindow;
  }
  WidgetRegistry& registry() { return setting_.registry; }
  UiMemory& memory() { return setting_.memory; }
  bool typing() const { return !setting_.memory.editing.empty(); }

  std::string words(std::string_view key) const;
  std::string tell(const Text& text) const { return shown(setting_.fonts, setting_.tell(text)); }
  // The keys that run a command's line.
  std::string hint(std::string_view commandLine) const { return setting_.hint(commandLine); }
  // With the decimal sign of the language and a real minus.
  std::string number(double value, int decimals) const;

  const Fonts& fonts() const { return setting_.fonts; }
  ImFont* font(Weight weight) const;
  float textWidth(std::string_view text, Weight weight = Weight::kRegular) const;
  // In the middle of the box's height, kept inside its width and told to the registry.
  void text(const Rect& box, std::string_view text, const TextStyle& style = {});
  // A label at the left, in the secondary colour, and its value at the right.
  void valueRow(const Rect& box, std::string_view id, std::string_view label,
                std::string_view value);

  void fill(const Rect& rect, ColourRole role, float radius = 0.0f, double opacity = 1.0);
  void outline(const Rect& rect, ColourRole role, float radius = 0.0f, float width = 1.0f);
  // The line around a control or a field, in the themes whose grounds are all but alike.
  void edge(const Rect& rect);
  void icon(Icon icon, const Rect& box, ColourRole role);

  bool button(std::string_view id, const Rect& rect, const ButtonStyle& style = {});
  bool button(std::string_view id, const Rect& rect, std::string_view label,
              const ButtonStyle& style);
  bool iconButton(std::string_view id, const Rect& rect, Icon icon, const ButtonStyle& style = {});
  // The name of a list's column; a sign beside it tells which way the list is sorted by it.
  bool columnHead(std::string_view id, const Rect& rect, bool sorted, bool descending, Align align);
  // A square with a tick and a label behind it.
  bool checkBox(std::string_view id, const Rect& rect, bool on);
  // One row of a list of which one is chosen, with a colour before it.
  bool choiceRow(std::string_view id, const Rect& rect, std::string_view label, bool chosen,
                 ColourRole swatch);
  // Its label is only told: the caller draws a picture over it.
  bool pictureButton(std::string_view id, const Rect& rect, const ButtonStyle& style);
  // Dragged, clicked at, turned with the wheel's keys; double click or Ctrl + click types the
  // value.
  std::optional<ValueChange> slider(std::string_view id, const Rect& rect, double value,
                                    const SliderStyle& style);
  // Shows a number; a click lets it be typed. Enter or a click elsewhere commits, Escape cancels.
  // What is no number is told by the second member.
  struct Typed {
    std::optional<double> value;
    std::optional<std::string> refused;  // the text that is no number
  };
  Typed field(std::string_view id, const Rect& rect, double value, const FieldStyle& style = {});
  // The same for a text of any length; its beginning is shown, of a path its end. Nothing where it
  // stays the same.
  std::optional<std::string> textField(std::string_view id, const Rect& rect,
                                       std::string_view value, bool path = false);
  // Tells the registry of buttons of which one is on: theirs are ID_VALUE.
  void choice(std::string_view id, const Rect& rect, std::string_view value);
  // An area with a meaning of its own (a graph, the viewport); true while the pointer is over it.
  struct AreaState {
    bool hovered = false;
    bool pressed = false;  // in this frame, left button
    bool held = false;
    bool released = false;
    bool doubleClicked = false;
  };
  AreaState area(std::string_view id, const Rect& rect, std::string_view value = {},
                 bool tips = true);

  // Enter, of either kind, went down since the last display frame.
  bool enterPressed() const;

  // Tells the registry of a text that takes effect while it is typed.
  void entry(std::string_view id, const Rect& rect, std::string_view label, std::string_view value);

  // Tells the registry of a text that is only shown.
  void shows(std::string_view id, const Rect& rect, std::string_view value);

  // Widgets that Dear ImGui draws (menus): told to the registry after the fact.
  void note(std::string_view id, std::string_view label, WidgetKind kind, bool enabled,
            std::string_view value = {});
  // A menu, whose place is not Dear ImGui's last item any more once it is open.
  void menu(std::string_view id, const Rect& rect, std::string_view label, bool enabled, bool open);

 private:
  struct Press {
    bool hovered = false, held = false, pressed = false;
  };
  Press press(std::string_view id, const Rect& rect, WidgetKind kind, bool enabled);
  void registerWidget(std::string_view id, std::string_view label, WidgetKind kind,
                      const Rect& rect, bool enabled, std::string_view value, std::string tip = {});
  void ground(const Rect& rect, const Press& press, const ButtonStyle& style);
  // What is told of a widget: what it does, and by which keys; of a greyed one why it is, where the
  // table says so (tip/AREA/NAME#greyed).
  std::string tip(std::string_view id, const ButtonStyle& style = {}) const;
  void tooltip(std::string_view id, const Rect& about, const Press& press,
               const ButtonStyle& style = {}, bool beside = false);
  std::optional<std::string> textEditor(std::string_view id, const Rect& rect, bool& ended);
  Typed typeNumber(std::string_view id, const Rect& rect);
  void startTyping(std::string_view id, std::string text);

  Setting setting_;
  Rect workArea_;
  float density_ = 1.0f;
};

// Rows of a panel, one under the other, as close as the Ui's density says.
class Stack {
 public:
  Stack(const Ui& ui, float x, float y, float width) : ui_(&ui), x_(x), y_(y), width_(width) {}
  Rect row(float heightAtScale1);
  void gap(float heightAtScale1);
  // A row of so many pixels, whatever the density: a picture's.
  Rect room(float pixels);
  float y() const { return y_; }
  float x() const { return x_; }
  float width() const { return width_; }

 private:
  const Ui* ui_;
  float x_, y_, width_;
};

// A row cut into equal parts with gaps of 4.
std::vector<Rect> split(const Ui& ui, const Rect& row, int parts, float gapAtScale1 = 4.0f);

// The same for labels: equal parts where they fit, else each as wide as its label needs.
std::vector<Rect> splitFor(const Ui& ui, const Rect& row, const std::vector<std::string>& labels);

// A panel: a ground with a heading. `content` draws into the stack; the ground takes its height.
void panel(Ui& ui, Stack& column, std::string_view headingKey,
           const std::function<void(Stack&)>& content);

// Of a panel, with the gap to the next one, apart from what is in it.
float panelHeight(const Ui& ui);
// Of that, what stands below its content.
float panelFoot(const Ui& ui);
// Words at the right end of the heading of a panel that begins at `top`; gives back the heading's
// place.
Rect panelCaption(Ui& ui, const Stack& column, float top, std::string_view words);

// Dear ImGui's own parts (menus, text fields, tooltips, scroll bars) in the theme's colours.
void applyStyle(ImGuiStyle& style, const Theme& theme, float scale);

}  // namespace vides
