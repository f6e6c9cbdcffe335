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
  // Another object may stand where one was that is gone.
  if (entry.buffer.id() != 0 && entry.geometry.lock() == geometry) {
    entry.buffer.bind();
    return;
  }
  entry.geometry = geometry;
  if (entry.buffer.id() == 0 && !spare_.empty()) {
    entry.buffer = std::move(spare_.back());
    spare_.pop_back();
  }
  if (entry.buffer.id() == 0) entry.buffer = Buffer(*gl_, GL_ARRAY_BUFFER);
  const auto bytes = std::as_bytes(std::span(geometry->points));
  entry.buffer.upload(bytes, GL_STATIC_DRAW);
  ++uploads_;
  uploadedBytes_ += bytes.size();
}

void SceneBuffers::collect() {
  for (auto i = entries_.begin(); i != entries_.end();) {
    if (!i->second.geometry.expired()) {
      ++i;
      continue;
    }
    if (spare_.size() < kMostSpare) spare_.push_back(std::move(i->second.buffer));
    i = entries_.erase(i);
  }
}

}  // namespace vides
