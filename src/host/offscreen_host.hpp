// SPDX-License-Identifier: MIT
// A host without a window: draws into a framebuffer of its own, and does what it is told.
//
// Its events are those pushed, its time is advanced by hand, its clipboard, title and cursor are
// only remembered: the same input gives the same picture. Derived classes bring the context.
#pragma once

#include <condition_variable>
#include <mutex>
#include <tl/expected.hpp>

#include "host/host.hpp"
#include "render/failure.hpp"
#include "render/framebuffer.hpp"
#include "render/picture.hpp"

namespace vides {

struct OffscreenOptions {
  PixelSize size{1280, 800};
  double contentScale = 1.0;
  int samples = 0;  // a pixel; 0 or 1: no multisampling, as the shaders smooth all edges
};

class OffscreenHost : public Host {
 public:
  // Takes effect at once and pushes Resized. Error: a size that this OpenGL cannot draw; the old
  // size stays. 0 × 0 is allowed.
  tl::expected<void, std::string> resize(PixelSize size, double contentScale);
  void push(InputEvent event);
  // `seconds` ≥ 0.
  void advanceTime(double seconds);
  // What was shown by the last swap(); transparent black before, 0 × 0 at that size.
  tl::expected<Picture, std::string> picture();

  const std::string& title() const { return title_; }
  CursorShape cursor() const { return cursor_; }

  const Gl& gl() const final { return gl_; }
  PixelSize size() const final { return size_; }
  double contentScale() const final { return contentScale_; }
  bool beginDrawing() final;
  GLuint framebuffer() const final { return framebuffer_.id(); }
  void swap() final;
  std::vector<InputEvent> takeEvents() final;
  void waitForEvents(std::chrono::duration<double> atMost) final;
  void wake() final;
  double time() const final { return time_; }
  std::string clipboard() const final { return clipboard_; }
  void setClipboard(const std::string& text) final { clipboard_ = text; }
  void setCursor(CursorShape shape) final { cursor_ = shape; }
  void setTitle(const std::string& title) final { title_ = title; }
  bool fullScreen() const final { return fullScreen_; }
  void setFullScreen(bool on) final { fullScreen_ = on; }

 protected:
  OffscreenHost() = default;
  // Once, when the context exists: fills the table and makes the framebuffer.
  tl::expected<void, std::string> start(const GlLoader& loader, const OffscreenOptions& options);
  // In the derived destructor, while the context still exists.
  void release();
  // Makes the context current even where it seems to be.
  virtual void bindAnew() = 0;

 private:
  tl::expected<void, std::string> makeFramebuffer(PixelSize size);

  Gl gl_;
  Framebuffer framebuffer_;
  PixelSize size_;
  double contentScale_ = 1.0;
  int samples_ = 0;
  double time_ = 0.0;
  bool fullScreen_ = false;
  std::string clipboard_;
  std::string title_;
  CursorShape cursor_ = CursorShape::kArrow;

  std::vector<InputEvent> events_;
  std::mutex wakeMutex_;
  std::condition_variable wakeCondition_;
  bool awake_ = false;  // guarded by wakeMutex_
};

}  // namespace vides
