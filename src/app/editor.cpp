// SPDX-License-Identifier: MIT
// One display frame of the editor.
#include "app/editor.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "app/editor_parts.hpp"
#include "scene/scene_reader.hpp"

namespace vides {
namespace {

constexpr double kGlideSeconds = 0.15;
constexpr double kDisplayFrame = 1.0 / 60.0;
// Pixels at content scale 1 that the settings window takes, where the scale is chosen.
constexpr struct { double width = 640.0, height = 540.0; } kSettingsNeed;
constexpr double kTooltipDelay = 0.65;
// Seconds of a walk at most in one display frame: after a hitch the camera must not leap.
constexpr double kMostWalk = 0.1;

PointerShape pointerShape(ImGuiMouseCursor cursor) {
  switch (cursor) {
    case ImGuiMouseCursor_TextInput:
      return PointerShape::kText;
    case ImGuiMouseCursor_ResizeNS:
      return PointerShape::kVertical;
    case ImGuiMouseCursor_ResizeEW:
      return PointerShape::kHorizontal;
    case ImGuiMouseCursor_Hand:
      return PointerShape::kHand;
    case ImGuiMouseCursor_ResizeAll:
      return PointerShape::kMove;
    default:
      return PointerShape::kArrow;
  }
}

// Dear ImGui's text fields use the same clipboard as keys do.
void shareClipboard(ImGuiIO& io, Editor::Parts& parts) {
  io.ClipboardUserData = &parts;
  io.GetClipboardTextFn = [](void* data) -> const char* {
    auto& self = *static_cast<Editor::Parts*>(data);
    self.clipboardBuffer =
        self.memory.wide.folded(self.options.clipboard ? self.options.clipboard() : "");
    return self.clipboardBuffer.c_str();
  };
  io.SetClipboardTextFn = [](void* data, const char* text) {
    auto& self = *static_cast<Editor::Parts*>(data);
    if (self.options.setClipboard) self.options.setClipboard(self.memory.wide.unfolded(text));
  };
}

SessionSeams seamsOf(const EditorOptions& options) {
  SessionSeams seams;
  seams.clipboard = options.clipboard;
  seams.setClipboard = options.setClipboard;
  seams.ran = options.ran;
  seams.said = options.said;
  seams.readsInBackground = !options.waitForWork;
  return seams;
}

// For as long as one of the editor's functions runs: its contexts, of OpenGL and Dear ImGui, are
// the current ones, and the latter is again who it was afterwards.
class Turn {
 public:
  Turn(const EditorOptions& options, ImGuiContext* context) {
    if (options.makeCurrent) options.makeCurrent();
    if (context != nullptr) ImGui::SetCurrentContext(context);
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;
  ~Turn() { ImGui::SetCurrentContext(before_); }

 private:
  ImGuiContext* before_ = ImGui::GetCurrentContext();
};

}  // namespace

Editor::Parts::Parts(const Gl& table, EditorOptions given)
    : gl(table),
      options(std::move(given)),
      fonts(options.fonts.atlas ? std::move(options.fonts) : buildFonts(1.0)),
      context(ImGui::CreateContext(fonts.atlas.get())),
      session(seamsOf(options)) {
  words = [this](std::string_view key) { return std::string(texts.words(key)); };
  tell = [this](const Text& text) { return texts.tell(text); };
  hint = [this](std::string_view line) { return shortcutOf(line); };
  parse = [](std::string_view text) { return parseNumber(text); };
  ImGui::SetCurrentContext(context);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.MouseDragThreshold = 3.0f;
  ImguiInput::announce(io);
  ImguiRenderer::announce(io);
  shareClipboard(io, *this);
}

Editor::Parts::~Parts() { ImGui::DestroyContext(context); }

tl::expected<std::unique_ptr<Editor>, std::string> Editor::create(const Gl& gl,
                                                                  EditorOptions options) {
  const Turn turn(options, nullptr);
  auto parts = std::make_unique<Parts>(gl, std::move(options));
  auto renderer = ImguiRenderer::create(gl);
  if (!renderer) return Failure(renderer.error());
  parts->imguiRenderer.emplace(std::move(*renderer));
  auto pictures = FlightPictures::create(gl);
  if (!pictures) return Failure(pictures.error());
  parts->pictures = std::move(*pictures);
  return std::unique_ptr<Editor>(new Editor(std::move(parts)));
}

Editor::Editor(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Editor::~Editor() {
  const Turn turn(parts_->options, nullptr);
  parts_.reset();
}

// Fonts and style for the scale and theme at hand. Error: no room for the fonts' texture.
void Editor::Parts::fitScale(double contentScale, PixelSize size) {
  // A chosen scale keeps the settings reachable, or nobody could take it back.
  const double chosen = std::min(session.display().contentScale,
                                 std::max(1.0, std::min(size.width / kSettingsNeed.width,
                                                        size.height / kSettingsNeed.height)));
  const double wanted =
      std::clamp(chosen > 0.0 ? chosen : contentScale, kLeastContentScale, kMostContentScale);
  const Theme wantedColours = themeOf(session.display());
  const bool otherColours = !(wantedColours == colours);
  const bool otherScale = wanted != scale;
  const bool otherLetters = memory.foreign != fonts.others;
  if (!otherColours && !otherScale && !otherLetters) return;
  scale = wanted;
  colours = wantedColours;
  applyStyle(ImGui::GetStyle(), colours, static_cast<float>(scale));
  if (!otherScale && !otherLetters) return;
  ImGuiIO& io = ImGui::GetIO();
  if (fonts.scale != scale || otherLetters) fonts = buildFonts(scale, memory.foreign);
  io.Fonts = fonts.atlas.get();
  io.FontDefault = fonts.fonts.regular;
  if (auto uploaded = imguiRenderer->uploadFonts(*io.Fonts); !uploaded) {
    session.say(MessageKind::kError, Text("output.fonts-failed", {uploaded.error()}));
  }
}

void Editor::Parts::apply(const Actions& actions) {
  for (const Actions::Step& step : actions.steps) {
    if (step.window) {
      session.preview(step.command);
      continue;
    }
    if (!step.gesture) {
      run(step.command);
      continue;
    }
    if (!session.inDrag()) session.begin({});
    session.preview(step.command);
    if (step.phase == Phase::kCommit) session.commit();
    if (step.phase == Phase::kCancel) session.cancel();
  }
  if (actions.refusal) session.say(MessageKind::kRefusal, *actions.refusal);
  if (actions.noNumber) {
    session.say(MessageKind::kRefusal, Text("refusal.no-number", {*actions.noNumber}));
  }
  if (actions.layout) session.setLayout(*actions.layout);
}

// View changes by a command glide there.
bool Editor::Parts::run(const Command& command) {
  const bool swapped = session.view().swapped;
  const EditorView before = session.view().view;
  const bool done = session.execute(command);
  const EditorView after = session.view().view;
  if (session.view().swapped != swapped) {
    // What is under the pointer is another picture now.
    tools.cancel();
    cameraTools.stop();
  }
  if (!options.glide || !session.display().glide || before == after || before.type != after.type) {
    return done;
  }
  ViewState shown = session.view();
  shown.view = before;
  session.setView(shown);
  glide = Glide{before, after, time};
  return done;
}

void Editor::Parts::stepGlide() {
  if (!glide) return;
  const double share = std::clamp((time - glide->since) / kGlideSeconds, 0.0, 1.0);
  if (share >= 1.0) return endGlide();
  ViewState state = session.view();
  state.view = glided(glide->from, glide->to, share);
  session.setView(state);
}

void Editor::Parts::endGlide() {
  if (!glide) return;
  ViewState state = session.view();
  state.view = glide->to;
  session.setView(state);
  glide.reset();
}

EditorView glided(const EditorView& from, const EditorView& to, double share) {
  const double eased = share * share * (3.0 - 2.0 * share);
  EditorView view = to;
  // The shorter way round.
  view.turn = from.turn + eased * std::remainder(to.turn - from.turn, 360.0);
  view.tilt = from.tilt + eased * (to.tilt - from.tilt);
  view.size = from.size * std::pow(to.size / from.size, eased);
  view.target = from.target + eased * (to.target - from.target);
  return limited(view);
}

bool Editor::Parts::pass(const FrameInput& given) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(given.size.width), static_cast<float>(given.size.height)};
  ImGui::NewFrame();
  registry.beginFrame();
  pictures->begin();
  graphs.follow(session.evaluation());
  Actions actions;
  Ui ui(uiSetting());
  overViewport = overCamera = false;
  scenes = session.scenes();
  window(ui, actions);
  // A field whose panel is gone is not being typed into.
  if (!memory.editing.empty() && registry.find(memory.editing) == nullptr) memory.editing.clear();
  ImGui::Render();
  // The picture may have changed under a pointer that rests, or the pointer come into it.
  const bool hovers =
      tools.hover(viewportPlace(), overViewport ? std::optional(pointerAt) : std::nullopt);
  pointer = pointerShape(ImGui::GetMouseCursor());
  const EditorView view = session.view().view;
  const bool changed = !actions.steps.empty() || actions.noNumber || actions.refusal ||
                       actions.layout || (actions.view && *actions.view != view);
  apply(actions);
  if (options.waitForWork) session.finishFrames();
  if (actions.view) {
    ViewState state = session.view();
    state.view = *actions.view;
    session.setView(state);
    glide.reset();
  }
  return changed || hovers;
}

FrameOutcome Editor::frame(const FrameInput& given) {
  const Turn turn(parts_->options, parts_->context);
  try {
    return frameOrThrow(given);
  } catch (const std::exception& error) {
    parts_->mend(error.what());
    throw;
  }
}

// After an exception anywhere in a display frame: the next one begins as if there had been none.
void Editor::Parts::mend(const std::string& why) {
  if (context->WithinFrameScope) {
    ImGui::ErrorCheckEndFrameRecover(nullptr, nullptr);
    ImGui::EndFrame();
  }
  session.abandon(Text("output.went-wrong", {why}));
  settling = kSettlingFrames;
}

FrameOutcome Editor::frameOrThrow(const FrameInput& given) {
  Parts& p = *parts_;
  if (p.texts.language() != p.session.display().language) {
    p.texts = Texts(p.session.display().language);
  }
  ImGuiIO& io = ImGui::GetIO();
  io.DeltaTime = static_cast<float>(std::max(1e-4, given.time - p.time));
  // Walking goes on from the last display frame, if the camera walked in it.
  p.cameraTools.advance(std::clamp(given.time - p.time, 0.0, kMostWalk));
  p.time = std::max(p.time, given.time);
  p.input.add(given.events);
  if (!given.events.empty()) p.settling = kSettlingFrames;
  p.fitScale(given.contentScale, given.size);
  p.session.advance(p.time);
  p.stepGlide();
  if (given.size.empty()) {
    while (p.input.waiting()) p.feed(io);
    p.graphs.follow(p.session.evaluation());  // nobody sees them
    return p.outcome();
  }
  p.feed(io);
  if (p.options.waitForWork) p.session.finishFrames();
  // What a panel asked for is on screen in the same display frame.
  if (p.pass(given)) {
    io.DeltaTime = 1e-4f;
    p.settling = kSettlingFrames;
    p.pass(given);
  }
  p.draw(given);
  ++p.framesDrawn;
  if (p.settling > 0) --p.settling;
  if (p.memory.foreign != p.fonts.others) p.settling = kSettlingFrames;  // drawn with their letters
  // What is kept of the view is where it was going.
  if (p.session.quitRequested()) p.endGlide();
  return p.outcome();
}

void Editor::finishMeasures(const std::function<void(std::int64_t, std::int64_t)>& report) {
  parts_->graphs.finish(report);
}

void Editor::Parts::draw(const FrameInput& given) {
  const Colour ground = colours[ColourRole::kWindow];
  pictures->prepare(given.size.width, given.size.height);
  gl.Disable(GL_SCISSOR_TEST);
  gl.ClearColor(static_cast<float>(ground.red) / 255.0f, static_cast<float>(ground.green) / 255.0f,
                static_cast<float>(ground.blue) / 255.0f, 1.0f);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  imguiRenderer->draw(*ImGui::GetDrawData());
}

FrameOutcome Editor::Parts::outcome() {
  FrameOutcome result;
  const auto want = [&](double seconds) {
    result.nextFrameIn = std::min(result.nextFrameIn.value_or(seconds), std::max(0.0, seconds));
  };
  if (input.waiting()) want(0.0);
  if (settling > 0 || glide || graphs.measuring() || cameraTools.walking() || session.frameJob() ||
      session.reading())
    want(kDisplayFrame);
  if (const auto due = session.playback().nextFrameAt(session.flight().frameRate)) {
    want(*due - time);
  }
  if (!memory.tooltipFor.empty() && time - memory.tooltipSince < kTooltipDelay) {
    want(kTooltipDelay - (time - memory.tooltipSince));
  }
  if (const auto note = tools.note(time)) want(note->until - time);
  result.pointer = pointer;
  result.title = tell(session.title());
  result.fullScreen = session.fullScreen();
  result.quit = session.quitRequested();
  return result;
}

bool Editor::run(const Command& command) {
  const Turn turn(parts_->options, parts_->context);
  return parts_->run(command);
}
std::string Editor::words(const Text& text) const { return parts_->tell(text); }
std::string Editor::label(std::string_view id) const { return parts_->words(id); }
double Editor::contentScale() const { return parts_->scale; }
Session& Editor::session() { return parts_->session; }
const Session& Editor::session() const { return parts_->session; }
const WidgetRegistry& Editor::widgets() const { return parts_->registry; }
Rect Editor::viewport() const { return parts_->pictures->flightRect(); }
bool Editor::overPicture() const { return parts_->overViewport || parts_->overCamera; }
Layout Editor::layout() const { return parts_->session.layout(); }
void Editor::setLayout(const Layout& layout) { parts_->session.setLayout(layout); }
ImGuiContext* Editor::context() const { return parts_->context; }
std::int64_t Editor::framesDrawn() const { return parts_->framesDrawn; }

}  // namespace vides
