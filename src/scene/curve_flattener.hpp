// SPDX-License-Identifier: MIT
// The flight's curve as polylines that stray less than a quarter of a pixel from it.
//
// A chord of a cubic piece strays at most |Q''| / (8 n^2) from it if the piece is cut into n equal
// parts; the view tells how many pixels that is at most. The scale is rounded up to a power of two
// for each piece, so that turning the view and small changes of its size make nothing new. Pieces
// are kept in chunks: only chunks with a piece that is new (Evaluation::pieceIdentity) or seen at
// another scale are made anew. Runs of pieces too short to be told apart become one chord.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "evaluate/evaluation.hpp"
#include "math/view_projection.hpp"
#include "scene/draw_list.hpp"

namespace vides {

// Pixels.
inline constexpr double kFlatteningError = 0.25;

class CurveFlattener {
 public:
  struct Piece {
    const void* identity = nullptr;
    int level = 0;  // the scale is 2^level pixels per unit
    bool operator==(const Piece&) const = default;
  };
  struct Chunk {
    std::size_t first = 0;  // piece
    // Its pieces, and one before and behind them (no identity where there is none).
    std::vector<Piece> signature;
    SharedGeometry geometry;            // polylines
    std::vector<std::uint32_t> begins;  // the element each piece begins at, and the end
    Vec3 low{0.0}, high{0.0};           // a box around its pieces

    std::size_t pieces() const { return begins.size() - 1; }
  };

  // Keeps a copy of the evaluation.
  void update(const Evaluation& evaluation, const ViewProjection& view);

  const std::vector<Chunk>& chunks() const { return chunks_; }
  // Those made anew by the last update().
  std::size_t rebuilt() const { return rebuilt_; }

  struct Nearest {
    std::size_t piece = 0;
    double parameter = 0.0;  // 0 to 1
    double distance = 0.0;   // pixels
  };
  // The place seen nearest to a pixel, within `reach`, in the view of the last update().
  std::optional<Nearest> nearest(const Vec2& pixel, double reach) const;

 private:
  Piece pieceAt(std::ptrdiff_t index) const;
  std::vector<Piece> signatureOf(std::size_t first, std::size_t count) const;
  bool fits(const Chunk& chunk, std::size_t first) const;
  void updateChunks(const std::vector<Evaluation::PieceRange>& changed);
  void divide(std::size_t first, std::size_t last, std::vector<Chunk>& chunks);
  void make(Chunk& chunk);
  double nearestParameter(std::size_t piece, const Vec2& pixel) const;

  Evaluation evaluation_;
  ViewProjection view_;
  std::optional<int> commonLevel_;  // of all pieces, in a parallel projection
  bool closed_ = false;
  std::vector<Piece> pieces_;
  std::vector<Chunk> chunks_;
  std::size_t rebuilt_ = 0;
};

// Whether a box can be seen: false only if it is certainly outside the view's pyramid or prism,
// widened by `margin` pixels.
bool mayBeSeen(const ViewProjection& view, const Vec3& low, const Vec3& high, double margin);

}  // namespace vides
