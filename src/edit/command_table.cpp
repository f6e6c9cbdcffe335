// SPDX-License-Identifier: MIT
// The table of commands.
#include "edit/command_table.hpp"

#include <unordered_map>

#include "edit/display.hpp"
#include "edit/ease.hpp"
#include "edit/flight_edits.hpp"
#include "edit/key_edits.hpp"
#include "edit/orientation_edits.hpp"
#include "edit/session.hpp"
#include "edit/session_actions.hpp"

namespace vides {
namespace {

using Argument = ArgumentSpecification;
using Table = std::vector<CommandSpecification>;
using Acts = SessionActions;

Argument number(const char* name) { return {name, ArgumentKind::kNumber, {}, false, false}; }
Argument index(const char* name) { return {name, ArgumentKind::kIndex, {}, false, false}; }
Argument text(const char* name) { return {name, ArgumentKind::kText, {}, false, false}; }
Argument choice(const char* name, std::vector<std::string> choices) {
  return {name, ArgumentKind::kChoice, std::move(choices), false, false};
}
Argument optional(Argument argument) {
  argument.optional = true;
  return argument;
}
Argument repeated(Argument argument) {
  argument.repeated = true;
  return argument;
}
Argument onOff() { return optional(choice("on|off|toggle", {"on", "off", "toggle"})); }

bool canUndo(const Session& s) { return s.undoName().has_value(); }
bool canRedo(const Session& s) { return s.redoName().has_value(); }
bool hasPath(const Session& s) { return !s.path().empty(); }
bool hasFreeCamera(const Session& s) { return s.freeCamera().has_value(); }
bool writesFrames(const Session& s) { return s.frameJob() != nullptr; }
bool readsScenes(const Session& s) { return s.reading().has_value(); }
bool writesNothing(const Session& s) { return s.frameJob() == nullptr; }
bool hasQuestion(const Session& s) { return s.question().has_value(); }
bool hasShapeWindow(const Session& s) { return s.inWindow() && s.windowOpen("shape"); }
bool hasRecent(const Session& s) { return !s.recentFiles().empty(); }

void addEdit(Table& table, const char* name, std::vector<Argument> arguments, EditFunction run) {
  table.push_back({name, std::move(arguments), run, true, nullptr});
}
void addAct(Table& table, const char* name, std::vector<Argument> arguments, ActFunction run,
            AvailableFunction available = nullptr) {
  table.push_back({name, std::move(arguments), run, false, available});
}
// An act that must not run within a gesture or before a question is answered.
void addExclusive(Table& table, const char* name, std::vector<Argument> arguments, ActFunction run,
                  AvailableFunction available = nullptr, const char* why = nullptr) {
  table.push_back({name, std::move(arguments), run, true, available, why});
}

void addFileCommands(Table& t) {
  addExclusive(t, "new", {}, Acts::newFlight);
  addExclusive(t, "open", {optional(text("FILE"))}, Acts::open);
  addExclusive(t, "open-recent", {index("NUMBER")}, Acts::openRecent, hasRecent);
  addExclusive(t, "save", {}, Acts::save);
  addExclusive(t, "save-as", {optional(text("FILE"))}, Acts::saveAs);
  addExclusive(t, "revert", {}, Acts::revert, hasPath);
  addExclusive(t, "quit", {}, Acts::quit);
  addAct(t, "answer",
         {choice("CHOICE", {"save", "discard", "overwrite", "save-as", "enlarge", "recover",
                            "forget", "later", "stop", "cancel"})},
         Acts::answer, hasQuestion);
  addExclusive(t, "import-scene", {optional(text("FILE"))}, Acts::importScene);
  addEdit(t, "add-scene",
          {text("FILE"), optional(number("LOW_X")), number("LOW_Y"), number("LOW_Z"),
           number("HIGH_X"), number("HIGH_Y"), number("HIGH_Z")},
          addSceneEdit);
  addAct(t, "cancel-reading", {}, Acts::cancelReading, readsScenes);
  addEdit(t, "remove-scene", {index("NUMBER")}, removeSceneEdit);
}

void addEditMenu(Table& t) {
  addExclusive(t, "undo", {}, Acts::undo, canUndo);
  addExclusive(t, "redo", {}, Acts::redo, canRedo);
  addExclusive(t, "cut", {}, Acts::cut);
  addAct(t, "copy", {}, Acts::copy);
  addExclusive(t, "paste", {}, Acts::paste);
  addEdit(t, "duplicate-keys", {}, duplicateKeysEdit);
  addEdit(t, "delete-keys", {}, deleteKeysEdit);
  addAct(t, "select-all", {}, Acts::selectAll);
  addAct(t, "select-key", {index("KEY"), optional(index("ORIENTATION"))}, Acts::selectKey);
  addAct(t, "make-current", {index("KEY"), optional(index("ORIENTATION"))}, Acts::makeCurrent);
  addAct(t, "toggle-select", {index("KEY")}, Acts::toggleSelect);
  addAct(t, "select-keys", {repeated(index("KEY"))}, Acts::selectKeys);
  addAct(t, "add-to-selection", {repeated(index("KEY"))}, Acts::addToSelection);
}

void addKeyCommands(Table& t) {
  addEdit(t, "insert-key", {}, insertKeyEdit);
  addEdit(t, "insert-keys", {index("COUNT")}, insertKeysEdit);
  addEdit(t, "insert-key-at", {index("SECTION"), number("FRACTION")}, insertKeyAtEdit);
  addEdit(t, "append-key", {}, appendKeyEdit);
  addAct(t, "previous-key", {}, Acts::previousKey);
  addAct(t, "next-key", {}, Acts::nextKey);
  addEdit(t, "move-key", {index("KEY"), number("X"), number("Y"), number("Z")}, moveKeyEdit);
  addEdit(t, "move-keys", {number("DX"), number("DY"), number("DZ")}, moveKeysEdit);
  addEdit(t, "set-preset", {index("PRESET")}, setPresetEdit);
  addEdit(t, "set-shape", {number("TENSION"), number("CONTINUITY"), number("BIAS")}, setShapeEdit);
  addEdit(t, "set-tension", {number("TENSION")}, setTensionEdit);
  addEdit(t, "set-continuity", {number("CONTINUITY")}, setContinuityEdit);
  addEdit(t, "set-bias", {number("BIAS")}, setBiasEdit);
  addEdit(t, "set-preset-shape",
          {index("PRESET"), number("TENSION"), number("CONTINUITY"), number("BIAS")},
          setPresetShapeEdit);
}

std::vector<Argument> speedArguments() { return std::vector<Argument>(kSpeedValues, number("V")); }

std::vector<std::string> easeChoices() { return {easeNames().begin(), easeNames().end()}; }

void addOrientationCommands(Table& t) {
  addEdit(t, "insert-orientation", {}, insertOrientationEdit);
  addEdit(t, "delete-orientation", {}, deleteOrientationEdit);
  addAct(t, "previous-orientation", {}, Acts::previousOrientation);
  addAct(t, "next-orientation", {}, Acts::nextOrientation);
  addEdit(t, "set-aim", {number("X"), number("Y"), number("Z")}, setAimEdit);
  addEdit(t, "move-aims", {number("DX"), number("DY"), number("DZ")}, moveAimsEdit);
  addEdit(t, "set-aim-mode", {choice("MODE", {"absolute", "relative"})}, setAimModeEdit);
  addEdit(t, "set-roll", {number("DEGREES")}, setRollEdit);
  addEdit(t, "set-zoom", {number("ZOOM")}, setZoomEdit);
  addEdit(t, "set-speed", speedArguments(), setSpeedEdit);
  addEdit(t, "set-speed-value", {index("NUMBER"), number("SPEED")}, setSpeedValueEdit);
  addEdit(t, "ease", {choice("PRESET", easeChoices())}, easeEdit);
  addEdit(t, "match-speed", {choice("NEIGHBOUR", {"before", "after"})}, matchSpeedEdit);
  addEdit(t, "set-duration", {number("SECONDS")}, setDurationEdit);
  addEdit(t, "set-duration-frames", {number("FRAMES")}, setDurationFramesEdit);
  addEdit(t, "clear-duration", {}, clearDurationEdit);
  addEdit(t, "set-hold", {number("SECONDS")}, setHoldEdit);
}

void addShapeCommands(Table& t) {
  std::vector<std::string> choices{"own"};
  for (std::size_t i = 0; i < kPresets; ++i) choices.push_back(std::to_string(i));
  addAct(t, "shape-choose", {choice("PRESET|own", choices)}, Acts::shapeChoose, hasShapeWindow);
  addAct(t, "shape-set", {choice("PARAMETER", {"tension", "continuity", "bias"}), number("VALUE")},
         Acts::shapeSet, hasShapeWindow);
  addAct(t, "shape-show", {}, Acts::shapeShow, hasShapeWindow);
  addAct(t, "shape-ok", {}, Acts::shapeOk, hasShapeWindow);
  addAct(t, "shape-cancel", {}, Acts::shapeCancel, hasShapeWindow);
}

void addFlightCommands(Table& t) {
  addEdit(t, "set-name", {text("NAME")}, setNameEdit);
  addEdit(t, "set-frame-rate", {number("RATE")}, setFrameRateEdit);
  addEdit(t, "set-picture", {index("WIDTH"), index("HEIGHT")}, setPictureEdit);
  addEdit(t, "set-lens", {number("SENSOR_WIDTH"), number("FOCAL_1"), number("FOCAL_100")},
          setLensEdit);
  addEdit(t, "set-rates", {number("MOVE"), number("PAN"), number("ROLL"), number("ZOOM")},
          setRatesEdit);
  addEdit(t, "set-closed", {choice("on|off|toggle", {"on", "off", "toggle"})}, setClosedEdit);
  std::vector<std::string> methods;
  for (const OrientationMethod* method : orientationMethods()) methods.emplace_back(method->name);
  addEdit(t, "set-orientation-curve", {choice("CURVE", methods)}, setOrientationCurveEdit);
  addEdit(t, "set-space",
          {number("CENTER_X"), number("CENTER_Y"), number("CENTER_Z"), number("HALF_SIZE")},
          setSpaceEdit);
}

void addPlayheadCommands(Table& t) {
  addAct(t, "play", {onOff()}, Acts::play);
  addAct(t, "previous-frame", {}, Acts::previousFrame);
  addAct(t, "next-frame", {}, Acts::nextFrame);
  addAct(t, "go-to-previous-orientation", {}, Acts::goToPreviousOrientation);
  addAct(t, "go-to-next-orientation", {}, Acts::goToNextOrientation);
  addAct(t, "first-frame", {}, Acts::firstFrame);
  addAct(t, "last-frame", {}, Acts::lastFrame);
  addAct(t, "go-to-frame", {index("FRAME")}, Acts::goToFrame);
  addAct(t, "loop", {onOff()}, Acts::loop);
}

void addViewCommands(Table& t) {
  addAct(t, "view", {choice("VIEW", {"iso", "front", "side", "top", "camera"})}, Acts::view);
  addAct(t, "view-opposite", {}, Acts::viewOpposite);
  addAct(t, "view-camera", {}, Acts::viewCamera);
  addAct(t, "perspective", {onOff()}, Acts::perspective);
  addAct(t, "set-view",
         {number("TURN"), number("TILT"), number("SIZE"), optional(number("TARGET_X")),
          number("TARGET_Y"), number("TARGET_Z")},
         Acts::setView);
  addAct(t, "set-turn", {number("TURN")}, Acts::setTurn);
  addAct(t, "set-tilt", {number("TILT")}, Acts::setTilt);
  addAct(t, "set-size", {number("SIZE")}, Acts::setSize);
  addAct(t, "frame-selection", {}, Acts::frameSelection);
  addAct(t, "frame-all", {}, Acts::frameAll);
  addAct(t, "swap-views", {}, Acts::swapViews);
}

void addCameraCommands(Table& t) {
  addExclusive(t, "use-view", {}, Acts::useView, hasFreeCamera, "refusal.no-free-view");
  addExclusive(t, "new-key-from-view", {}, Acts::newKeyFromView, hasFreeCamera,
               "refusal.no-free-view");
  addAct(t, "leave-view", {}, Acts::leaveView, hasFreeCamera);
  addAct(t, "set-free-view",
         {number("X"), number("Y"), number("Z"), number("VPN_X"), number("VPN_Y"), number("VPN_Z"),
          number("VUP_X"), number("VUP_Y"), number("VUP_Z"), number("ZOOM")},
         Acts::setFreeView);
  addAct(t, "fly-turn", {number("LEFT_DEGREES"), number("DOWN_DEGREES")}, Acts::flyTurn);
  addAct(t, "fly-move", {number("RIGHT"), number("UP"), number("AHEAD")}, Acts::flyMove);
  addAct(t, "fly-roll", {number("DEGREES")}, Acts::flyRoll);
  addAct(t, "fly-zoom", {number("STEPS")}, Acts::flyZoom);
}

std::vector<std::string> switchChoices() { return {switchNames().begin(), switchNames().end()}; }

std::vector<std::string> sizeChoices() {
  std::vector<std::string> names;
  for (const ElementSize& size : kElementSizes) names.emplace_back(size.name);
  return names;
}

std::vector<std::string> elementChoices() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kColourRoles; ++i) {
    const auto role = static_cast<ColourRole>(i);
    if (isElement(role)) names.emplace_back(name(role));
  }
  return names;
}

void addFrameCommands(Table& t) {
  std::vector<std::string> formats;
  for (const FrameFormat* format : frameFormats()) formats.emplace_back(format->name);
  addAct(t, "frames-format", {choice("FORMAT", formats)}, Acts::framesFormat);
  addAct(t, "frames-space", {choice("SPACE", {"cube", "world"})}, Acts::framesSpace);
  // Frames FIRST <= n < END, as on the command line; none: all.
  addAct(t, "frames-range", {optional(index("FIRST")), index("END")}, Acts::framesRange);
  addAct(t, "frames-first-number", {number("NUMBER")}, Acts::framesFirstNumber);
  addAct(t, "frames-file", {text("FILE")}, Acts::framesFile);
  addExclusive(t, "write-frames", {}, Acts::writeFrames, writesNothing);
  addAct(t, "cancel-frames", {}, Acts::cancelFrames, writesFrames);
}

void addDisplayCommands(Table& t) {
  const std::vector<std::string> windows = {"shape",         "speed",
                                            "flight",        "insert-keys",
                                            "frames",        "settings",
                                            "colours",       "shortcuts",
                                            "about",         "chooser-open",
                                            "chooser-save",  "chooser-import",
                                            "chooser-setup", "chooser-save-setup",
                                            "chooser-frames"};
  addAct(t, "show-element", {choice("ELEMENT", switchChoices()), onOff()}, Acts::showElement);
  addAct(t, "set-colour",
         {choice("ELEMENT", elementChoices()), index("RED"), index("GREEN"), index("BLUE")},
         Acts::setColour);
  addAct(t, "reset-colour", {optional(choice("ELEMENT", elementChoices()))}, Acts::resetColour);
  addAct(t, "theme", {choice("THEME", {"dark", "light", "high_contrast"})}, Acts::setTheme);
  addAct(t, "content-scale", {number("SCALE")}, Acts::contentScale);
  addAct(t, "element-size", {choice("ELEMENT", sizeChoices()), number("PIXELS")},
         Acts::elementSize);
  addAct(t, "reset-sizes", {}, Acts::resetSizes);
  addAct(t, "grid-step", {number("STEP")}, Acts::gridStep);
  addAct(t, "ghost-every", {index("FRAMES")}, Acts::ghostEvery);
  addAct(t, "units", {choice("UNITS", {"cube", "scene"})}, Acts::units);
  addAct(t, "language", {choice("LANGUAGE", {"en", "de"})}, Acts::language);
  addAct(t, "load-setup", {optional(text("FILE"))}, Acts::loadSetup);
  addAct(t, "save-setup", {optional(text("FILE"))}, Acts::saveSetup);
  addAct(t, "reset-setup", {}, Acts::resetSetup);
  addAct(t, "show-window", {choice("WINDOW", windows)}, Acts::showWindow);
  addAct(t, "close-window", {optional(choice("WINDOW", windows))}, Acts::closeWindow);
  addAct(t, "full-screen", {onOff()}, Acts::fullScreen);
  addAct(t, "escape", {}, Acts::escape);
}

Table makeTable() {
  Table table;
  addFileCommands(table);
  addEditMenu(table);
  addKeyCommands(table);
  addOrientationCommands(table);
  addShapeCommands(table);
  addFlightCommands(table);
  addPlayheadCommands(table);
  addViewCommands(table);
  addCameraCommands(table);
  addFrameCommands(table);
  addDisplayCommands(table);
  return table;
}

}  // namespace

const std::vector<CommandSpecification>& commandTable() {
  static const Table kTable = makeTable();
  return kTable;
}

const CommandSpecification* findCommand(std::string_view name) {
  static const auto kByName = [] {
    std::unordered_map<std::string_view, const CommandSpecification*> map;
    for (const CommandSpecification& command : commandTable()) map.emplace(command.name, &command);
    return map;
  }();
  const auto found = kByName.find(name);
  return found == kByName.end() ? nullptr : found->second;
}

std::string usage(const CommandSpecification& command) {
  std::string line = command.name;
  std::size_t open = 0;
  for (const ArgumentSpecification& argument : command.arguments) {
    line += ' ';
    if (argument.optional) {
      line += '[';
      ++open;
    }
    line += argument.name;
    if (argument.repeated) line += "...";
  }
  return line.append(open, ']');
}

}  // namespace vides
