// SPDX-License-Identifier: MIT
// Uploads geometry once and finds it again.
#include "render/scene_buffers.hpp"

#include <span>
#include <utility>

namespace vides {
namespace {

// More would hold memory for nothing.
constexpr std::size_t kMostSpare = 32;

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
  texels.buffer.upload(bytes, GL_STATIC_DRAW);
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
