// SPDX-License-Identifier: MIT
// A window through GLFW.
#include "host/glfw_host.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>
#include <thread>
#include <utility>

#include "host/current_context.hpp"
#include "host/glfw_keys.hpp"
#include "host/lost_display.hpp"

namespace vides {
namespace {

using Clock = std::chrono::steady_clock;

std::string lastError() {
  const char* text = nullptr;
  const int code = glfwGetError(&text);
  if (code == GLFW_NO_ERROR) return "no reason given";
  return text == nullptr ? "error " + std::to_string(code) : std::string(text);
}

// GLFW as long as somebody holds one. The library's own state is one a process, and so is this
// count, without which the second window's end would close the first one.
class GlfwUse {
 public:
  GlfwUse() {
    if (count()++ == 0) started() = glfwInit() == GLFW_TRUE;
  }
  GlfwUse(const GlfwUse&) = delete;
  GlfwUse& operator=(const GlfwUse&) = delete;
  ~GlfwUse() {
    if (--count() == 0 && started()) glfwTerminate();
  }
  bool ok() const { return started(); }

 private:
  static int& count() {
    static int value = 0;
    return value;
  }
  static bool& started() {
    static bool value = false;
    return value;
  }
};

Modifiers modifiersOf(int bits) {
  Modifiers result;
  result.shift = (bits & GLFW_MOD_SHIFT) != 0;
  result.control = (bits & GLFW_MOD_CONTROL) != 0;
  result.alt = (bits & GLFW_MOD_ALT) != 0;
  result.super = (bits & GLFW_MOD_SUPER) != 0;
  return result;
}

void setHints(const WindowOptions& options) {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SAMPLES, options.samples < 2 ? 0 : options.samples);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "vides");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "vides");
}

// Why there is no context of OpenGL 3.3: whatever context there is says what it is.
std::string whyNoContext(const std::string& reason) {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  GLFWwindow* const window = glfwCreateWindow(16, 16, "vides", nullptr, nullptr);
  std::string sentence = "OpenGL 3.3 is needed, and none was found: " + reason;
  if (window != nullptr) {
    glfwMakeContextCurrent(window);
    setCurrentContext(nullptr);
    if (const auto gl = loadGl(&glfwGetProcAddress); !gl) sentence = gl.error();
    glfwDestroyWindow(window);
  }
  return sentence;
}

class GlfwHost final : public Host {
 public:
  GlfwHost() = default;
  ~GlfwHost() override {
    for (GLFWcursor* cursor : cursors_) {
      if (cursor != nullptr) glfwDestroyCursor(cursor);
    }
    if (window_ == nullptr) return;
    if (isCurrentContext(window_)) setCurrentContext(nullptr);
    glfwDestroyWindow(window_);
  }

  tl::expected<void, std::string> open(const WindowOptions& options);

  const Gl& gl() const override { return gl_; }
  void makeCurrent() override {
    if (!isCurrentContext(window_) || glfwGetCurrentContext() != window_) bind();
  }
  PixelSize size() const override;
  double contentScale() const override;
  bool beginDrawing() override;
  GLuint framebuffer() const override { return 0; }
  void swap() override;
  std::vector<InputEvent> takeEvents() override;
  void waitForEvents(std::chrono::duration<double> atMost) override;
  void wake() override;
  double time() const override {
    return std::chrono::duration<double>(Clock::now() - opened_).count();
  }
  std::string clipboard() const override;
  void setClipboard(const std::string& text) override {
    glfwSetClipboardString(window_, text.c_str());
  }
  void setCursor(CursorShape shape) override;
  void setTitle(const std::string& title) override { glfwSetWindowTitle(window_, title.c_str()); }
  bool fullScreen() const override { return glfwGetWindowMonitor(window_) != nullptr; }
  void setFullScreen(bool on) override;
  void onLost(std::function<void()> last) override {
    watch_.reset();
    watch_.emplace(std::move(last));
  }

 private:
  static GlfwHost& of(GLFWwindow* window) {
    return *static_cast<GlfwHost*>(glfwGetWindowUserPointer(window));
  }
  void bind() {
    glfwMakeContextCurrent(nullptr);  // it does nothing for a context that it takes for current
    glfwMakeContextCurrent(window_);
    setCurrentContext(window_);
  }
  void listen();
  void onKey(int token, int scancode, int action, int bits);
  void onPointer(double x, double y);
  void onDrop(int count, const char** paths);
  void onResized() { push(Resized{size(), contentScale()}); }
  void push(InputEvent event) { events_.push_back(std::move(event)); }
  GLFWmonitor* monitorUnderWindow() const;
  std::chrono::duration<double> framePeriod() const;

  GlfwUse use_;
  std::optional<LostDisplay> watch_;  // ends before GLFW does
  GLFWwindow* window_ = nullptr;
  Gl gl_;
  std::vector<InputEvent> events_;
  std::atomic<bool> awake_ = false;
  Clock::time_point opened_ = Clock::now();
  Clock::time_point lastSwap_ = opened_;
  std::array<GLFWcursor*, 6> cursors_{};
  CursorShape cursor_ = CursorShape::kArrow;
  struct Place {
    int x = 0, y = 0, width = 0, height = 0;
  };
  Place windowed_;  // before full screen
};

tl::expected<void, std::string> GlfwHost::open(const WindowOptions& options) {
  if (!use_.ok()) return Failure("no window can be opened: " + lastError());
  setHints(options);
  window_ = glfwCreateWindow(std::max(1, options.size.width), std::max(1, options.size.height),
                             options.title.c_str(), nullptr, nullptr);
  if (window_ == nullptr) return Failure(whyNoContext(lastError()));
  bind();
  auto gl = loadGl(&glfwGetProcAddress);
  if (!gl) return Failure(gl.error());
  gl_ = std::move(*gl);
  glfwSwapInterval(1);
  listen();
  return {};
}

void GlfwHost::listen() {
  glfwSetWindowUserPointer(window_, this);
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int token, int scancode, int action,
                                 int bits) { of(window).onKey(token, scancode, action, bits); });
  glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned int character) {
    if (std::string text = utf8(character); !text.empty()) of(window).push(TextTyped{text});
  });
  glfwSetCursorPosCallback(
      window_, [](GLFWwindow* window, double x, double y) { of(window).onPointer(x, y); });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int entered) {
    if (entered == GLFW_FALSE) of(window).push(PointerLeft{});
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int number, int action, int bits) {
    constexpr std::array kButtons = {PointerButton::kLeft, PointerButton::kRight,
                                     PointerButton::kMiddle};  // GLFW's order
    const auto index = static_cast<std::size_t>(number);
    if (index >= kButtons.size()) return;
    of(window).push(ButtonChanged{kButtons[index], action == GLFW_PRESS, modifiersOf(bits)});
  });
  // GLFW's x grows to the left, as the wheel's own coordinates do under X11 and Wayland.
  glfwSetScrollCallback(window_, [](GLFWwindow* window, double x, double y) {
    of(window).push(WheelTurned{-x, y});
  });
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    of(window).onDrop(count, paths);
  });
  glfwSetFramebufferSizeCallback(window_,
                                 [](GLFWwindow* window, int, int) { of(window).onResized(); });
  glfwSetWindowContentScaleCallback(
      window_, [](GLFWwindow* window, float, float) { of(window).onResized(); });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int focused) {
    of(window).push(FocusChanged{focused == GLFW_TRUE});
  });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { of(window).push(Exposed{}); });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* window) {
    glfwSetWindowShouldClose(window, GLFW_FALSE);  // the editor decides
    of(window).push(CloseRequested{});
  });
}

void GlfwHost::onKey(int token, int scancode, int action, int bits) {
  const char* printed = glfwGetKeyName(token, scancode);
  KeyChanged event;
  event.key = keyFromGlfw(token, printed == nullptr ? "" : printed);
  event.pressed = action != GLFW_RELEASE;
  event.repeated = action == GLFW_REPEAT;
  event.modifiers = modifiersOf(bits);
  // X11 tells the modifiers before the change; Wayland and others those after it.
  const auto held = [this](int left, int right) {
    return glfwGetKey(window_, left) == GLFW_PRESS || glfwGetKey(window_, right) == GLFW_PRESS;
  };
  const Modifiers own = modifierOf(event.key);
  Modifiers& after = event.modifiers;
  if (own.shift) after.shift = held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
  if (own.control) after.control = held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
  if (own.alt) after.alt = held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
  if (own.super) after.super = held(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
  push(event);
}

// GLFW's places are in the window system's units, which need not be pixels.
void GlfwHost::onPointer(double x, double y) {
  int width = 0;
  int height = 0;
  glfwGetWindowSize(window_, &width, &height);
  const PixelSize pixels = size();
  if (width < 1 || height < 1 || pixels.empty()) return;
  push(PointerMoved{x * pixels.width / width, y * pixels.height / height});
}

void GlfwHost::onDrop(int count, const char** paths) {
  FilesDropped event;
  for (int i = 0; i < count; ++i) event.paths.emplace_back(paths[i]);
  push(std::move(event));
}

PixelSize GlfwHost::size() const {
  PixelSize result;
  glfwGetFramebufferSize(window_, &result.width, &result.height);
  return result;
}

double GlfwHost::contentScale() const {
  float x = 1.0f;
  float y = 1.0f;
  glfwGetWindowContentScale(window_, &x, &y);
  // Some screens tell nonsense about their size.
  return x >= 0.25f && x <= 8.0f ? static_cast<double>(x) : 1.0;
}

bool GlfwHost::beginDrawing() {
  const PixelSize pixels = size();
  if (pixels.empty()) return false;
  bind();
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl_.Viewport(0, 0, pixels.width, pixels.height);
  return true;
}

std::chrono::duration<double> GlfwHost::framePeriod() const {
  const GLFWvidmode* mode = nullptr;
  if (GLFWmonitor* const monitor = monitorUnderWindow()) mode = glfwGetVideoMode(monitor);
  const int rate = mode == nullptr || mode->refreshRate < 1 ? 60 : mode->refreshRate;
  return std::chrono::duration<double>(1.0 / rate);
}

void GlfwHost::swap() {
  makeCurrent();
  glfwSwapBuffers(window_);
  // Some drivers do not wait for the screen though asked to: no more pictures than it can show.
  const std::chrono::duration<double> period = framePeriod();
  const Clock::time_point earliest =
      lastSwap_ + std::chrono::duration_cast<Clock::duration>(period);
  if (Clock::now() < lastSwap_ + std::chrono::duration_cast<Clock::duration>(period * 0.75)) {
    std::this_thread::sleep_until(earliest);
  }
  lastSwap_ = Clock::now();
}

std::vector<InputEvent> GlfwHost::takeEvents() {
  glfwPollEvents();
  if (watch_) watch_->check();
  return std::exchange(events_, {});
}

void GlfwHost::waitForEvents(std::chrono::duration<double> atMost) {
  constexpr double kLongest = 3600.0;  // GLFW refuses infinity
  if (!events_.empty() || awake_.exchange(false)) return;
  glfwWaitEventsTimeout(std::clamp(atMost.count(), 0.0, kLongest));
  awake_ = false;
}

// The flag serves a wait that has not begun; the empty event one that has.
void GlfwHost::wake() {
  awake_ = true;
  glfwPostEmptyEvent();
}

std::string GlfwHost::clipboard() const {
  const char* text = glfwGetClipboardString(window_);
  return text == nullptr ? std::string() : text;
}

void GlfwHost::setCursor(CursorShape shape) {
  if (shape == cursor_) return;
  cursor_ = shape;
  const bool hidden = shape == CursorShape::kHidden;
  glfwSetInputMode(window_, GLFW_CURSOR, hidden ? GLFW_CURSOR_HIDDEN : GLFW_CURSOR_NORMAL);
  if (hidden) return;
  constexpr std::array kShapes = {GLFW_ARROW_CURSOR, GLFW_IBEAM_CURSOR,   GLFW_CROSSHAIR_CURSOR,
                                  GLFW_HAND_CURSOR,  GLFW_HRESIZE_CURSOR, GLFW_VRESIZE_CURSOR};
  const auto index = static_cast<std::size_t>(shape);
  if (cursors_[index] == nullptr) cursors_[index] = glfwCreateStandardCursor(kShapes[index]);
  glfwSetCursor(window_, cursors_[index]);
}

// The screen that shows most of the window; null where there is none.
GLFWmonitor* GlfwHost::monitorUnderWindow() const {
  Place window;
  glfwGetWindowPos(window_, &window.x, &window.y);
  glfwGetWindowSize(window_, &window.width, &window.height);
  int count = 0;
  GLFWmonitor** const monitors = glfwGetMonitors(&count);
  GLFWmonitor* best = glfwGetPrimaryMonitor();
  long bestArea = 0;
  for (int i = 0; i < count; ++i) {
    const GLFWvidmode* const mode = glfwGetVideoMode(monitors[i]);
    if (mode == nullptr) continue;
    Place screen;
    glfwGetMonitorPos(monitors[i], &screen.x, &screen.y);
    const long width =
        std::min(window.x + window.width, screen.x + mode->width) - std::max(window.x, screen.x);
    const long height =
        std::min(window.y + window.height, screen.y + mode->height) - std::max(window.y, screen.y);
    if (width > 0 && height > 0 && width * height > bestArea) {
      bestArea = width * height;
      best = monitors[i];
    }
  }
  return best;
}

void GlfwHost::setFullScreen(bool on) {
  if (on == fullScreen()) return;
  if (!on) {
    glfwSetWindowMonitor(window_, nullptr, windowed_.x, windowed_.y, windowed_.width,
                         windowed_.height, GLFW_DONT_CARE);
    return;
  }
  GLFWmonitor* const monitor = monitorUnderWindow();
  const GLFWvidmode* const mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
  if (mode == nullptr) return;
  glfwGetWindowPos(window_, &windowed_.x, &windowed_.y);
  glfwGetWindowSize(window_, &windowed_.width, &windowed_.height);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

}  // namespace

tl::expected<std::unique_ptr<Host>, std::string> openGlfwHost(const WindowOptions& options) {
  auto host = std::make_unique<GlfwHost>();
  if (const auto opened = host->open(options); !opened) return Failure(opened.error());
  return host;
}

}  // namespace vides
