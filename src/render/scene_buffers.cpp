// SPDX-License-Identifier: MIT
// Uploads geometry once and finds it again.
#include "render/scene_buffers.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace vides {
namespace {

// More would hold memory for nothing.
constexpr std::size_t kMostSpare = 32;

// Some more than `bytes`. Mesa's llvmpipe compiles the vertex shaders anew for buffers whose size
// is a power of two, and for those whose size has no bit set in its second byte: none of ours is
// either.
std::size_t roomFor(std::size_t bytes) {
  constexpr std::size_t kStep = 1024;
  return std::max<std::size_t>(1, (bytes + kStep / 2 - 1) / kStep) * kStep + kStep / 2;
}

}  // namespace

void SceneBuffers::bind(const SharedGeometry& geometry) {
  Entry& entry = entries_[geometry.get()];
  Texels& texels = entry.texels;
  // Another object may stand where one was that is gone.
  const bool known = texels.texture && entry.geometry.lock() == geometry;
  if (!texels.texture && !spare_.empty()) {
    texels = std::move(spare_.back());
    spare_.pop_back();
  }
  const bool fresh = !texels.texture;
  if (fresh) texels = {Buffer(*gl_, GL_TEXTURE_BUFFER), TextureHandle(*gl_)};
  gl_->BindTexture(GL_TEXTURE_BUFFER, texels.texture.id());
  if (known) return;

  entry.geometry = geometry;
  const auto bytes = std::as_bytes(std::span(geometry->points));
  texels.buffer.reserve(roomFor(bytes.size()), GL_STATIC_DRAW);
  texels.buffer.update(0, bytes);
  if (fresh) gl_->TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, texels.buffer.id());
  ++uploads_;
  uploadedBytes_ += bytes.size();
}

void SceneBuffers::collect() {
  for (auto i = entries_.begin(); i != entries_.end();) {
    if (!i->second.geometry.expired()) {
      ++i;
      continue;
    }
    if (spare_.size() < kMostSpare) spare_.push_back(std::move(i->second.texels));
    i = entries_.erase(i);
  }
}

}  // namespace vides
