// SPDX-License-Identifier: MIT
// A host without a window.
#include "host/offscreen_host.hpp"

#include <cassert>
#include <utility>

namespace vides {

tl::expected<void, std::string> OffscreenHost::start(const GlLoader& loader,
                                                     const OffscreenOptions& options) {
  auto gl = loadGl(loader);
  if (!gl) return Failure(gl.error());
  gl_ = std::move(*gl);
  samples_ = options.samples;
  contentScale_ = options.contentScale;
  return makeFramebuffer(options.size);
}

void OffscreenHost::release() { framebuffer_ = Framebuffer(); }

tl::expected<void, std::string> OffscreenHost::makeFramebuffer(PixelSize size) {
  if (size.empty()) {
    framebuffer_ = Framebuffer();
    size_ = {};
    return {};
  }
  auto framebuffer = Framebuffer::create(gl_, size.width, size.height, samples_);
  if (!framebuffer) return Failure(framebuffer.error());
  framebuffer_ = std::move(*framebuffer);
  size_ = size;
  // A new framebuffer holds anything; what nobody draws must be the same in each run.
  framebuffer_.bind();
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.ClearColor(0, 0, 0, 0);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  framebuffer_.resolve();
  return {};
}

tl::expected<void, std::string> OffscreenHost::resize(PixelSize size, double contentScale) {
  assert(contentScale > 0.0);
  makeCurrent();
  const PixelSize oldSize = size_;
  const double oldScale = contentScale_;
  if (size.empty() ? !oldSize.empty() : size != oldSize) {
    if (auto made = makeFramebuffer(size); !made) return made;
  }
  contentScale_ = contentScale;
  if (size_ != oldSize || contentScale_ != oldScale) push(Resized{size_, contentScale_});
  return {};
}

void OffscreenHost::push(InputEvent event) { events_.push_back(std::move(event)); }

void OffscreenHost::advanceTime(double seconds) {
  assert(seconds >= 0.0);
  time_ += seconds;
}

bool OffscreenHost::beginDrawing() {
  if (size_.empty()) return false;
  bindAnew();
  framebuffer_.bind();
  return true;
}

void OffscreenHost::swap() {
  if (size_.empty()) return;
  makeCurrent();
  framebuffer_.resolve();
  // Nothing else would ever make the driver draw what it has put aside: llvmpipe collects 2 GB.
  gl_.Finish();
}

tl::expected<Picture, std::string> OffscreenHost::picture() {
  if (size_.empty()) return Picture();
  makeCurrent();
  return framebuffer_.read();
}

std::vector<InputEvent> OffscreenHost::takeEvents() { return std::exchange(events_, {}); }

void OffscreenHost::waitForEvents(std::chrono::duration<double> atMost) {
  std::unique_lock lock(wakeMutex_);
  if (events_.empty()) wakeCondition_.wait_for(lock, atMost, [this] { return awake_; });
  awake_ = false;
}

void OffscreenHost::wake() {
  {
    const std::lock_guard lock(wakeMutex_);
    awake_ = true;
  }
  wakeCondition_.notify_one();
}

}  // namespace vides
