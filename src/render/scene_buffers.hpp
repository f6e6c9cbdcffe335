// SPDX-License-Identifier: MIT
// Geometry on the GPU: uploaded when it is first drawn, kept for as long as the object lives.
#pragma once

#include <cstddef>
#include <memory>
#include <unordered_map>
#include <vector>

#include "render/gl_objects.hpp"
#include "scene/draw_list.hpp"

namespace vides {

class SceneBuffers {
 public:
  explicit SceneBuffers(const Gl& gl) : gl_(&gl) {}

  // Binds the buffer texture that holds the geometry's points, a texel each, to the active unit.
  void bind(const SharedGeometry& geometry);
  // Takes back the buffers of geometry that is gone, for the next that comes.
  void collect();

  std::size_t uploads() const { return uploads_; }
  std::size_t uploadedBytes() const { return uploadedBytes_; }
  void resetCounts() { uploads_ = uploadedBytes_ = 0; }

 private:
  struct Texels {
    Buffer buffer;
    TextureHandle texture;
  };
  struct Entry {
    std::weak_ptr<const Geometry> geometry;
    Texels texels;
  };

  const Gl* gl_;
  std::unordered_map<const Geometry*, Entry> entries_;
  std::vector<Texels> spare_;
  std::size_t uploads_ = 0;
  std::size_t uploadedBytes_ = 0;
};

}  // namespace vides
