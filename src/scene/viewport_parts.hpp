// SPDX-License-Identifier: MIT
// The parts that a viewport's list is made of. Each keeps the geometry that it hands out.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/crowding.hpp"
#include "scene/cube_part.hpp"
#include "scene/curve_flattener.hpp"
#include "scene/draw_list.hpp"
#include "scene/geometry_slot.hpp"
#include "scene/label_placer.hpp"
#include "scene/viewport_scene.hpp"

namespace vides {

// What all parts are made from, and what they add to.
struct ViewportContext {
  const ViewportInput& input;
  DrawList& list;
  LabelPlacer& labels;
  double signs = 1.0;  // signScale()
  // Crosses crowd: what belongs to the current key is drawn over them.
  bool crowded = false;

  const ViewProjection& view() const { return list.view; }
  const Flight& flight() const { return input.evaluation.flight(); }
  const Colour& colour(ColourRole role) const { return input.theme[role]; }
  double scale() const { return signs; }
  // A picture with room for what is current only.
  bool cramped() const { return signs < 0.75 * input.contentScale; }
  float pixels(double atScale1) const { return static_cast<float>(atScale1 * scale()); }
  // Of what can be taken hold of: grows with the chosen size of handles.
  double handleScale() const { return scale() * input.sizes.handles / ElementSizes().handles; }
  float handlePixels(double atScale1) const { return static_cast<float>(atScale1 * handleScale()); }
  DrawDepth depthOfCurrent() const { return crowded ? DrawDepth::kOnTop : DrawDepth::kTested; }
  bool hovered(const HandleId& id) const { return input.state.hovered == id; }
  // Whether a pixel lies in the rectangle, or at most `margin` outside.
  bool sees(const Vec2& pixel, double margin) const;
  // Around a handle: what the hand can do with doesn't shrink with the signs.
  double reach(double atScale1) const {
    return atScale1 * input.contentScale * input.sizes.handles / ElementSizes().handles;
  }
  // A text placed for what stands at `anchor`, with a line to it where it stands away. One that
  // must be read has a ground of its own where crosses crowd.
  void addLabel(DrawText text, const LabelPlacer::Place& place, const Vec2& anchor,
                const Vec2& size, bool needed) const;
};

inline ColourRole roleOf(Axis axis) {
  return static_cast<ColourRole>(static_cast<int>(ColourRole::kAxisX) + static_cast<int>(axis));
}

// The curve, the current section's piece of it in its own colour.
class CurvePart {
 public:
  void add(const ViewportContext& context);
  // The current section once more, over what has been drawn since.
  void addCurrentOnTop(const ViewportContext& context) const;
  const CurveFlattener& flattener() const { return flattener_; }

 private:
  void block(const ViewportContext& context) const;
  CurveFlattener flattener_;
  std::optional<DrawItem> current_;  // of the last add()
};

// The grid on the cube's floor: as fine as the view leaves room for, every fifth line stronger.
class GridPart {
 public:
  void add(const ViewportContext& context);

 private:
  GeometrySlot fine_, strong_;
};

// Crosses and their numbers.
class KeysPart {
 public:
  // Where the crosses are, and their handles; what others draw and label can be added between.
  void find(const ViewportContext& context);
  // Whether of the crosses found some are drawn smaller, so that they do not bury the curve.
  bool crowded() const { return crowded_; }
  // Of all keys but the current one; then the marks of the selected ones, the current key's cross
  // and the hovered one's.
  void addCrosses(const ViewportContext& context);
  void addMarks(const ViewportContext& context);
  void addNumbers(const ViewportContext& context) const;
  // At the picture's edge, where the current key lies outside.
  void addOutside(const ViewportContext& context);

 private:
  struct Place {
    std::size_t key;
    Vec2 pixel;
    GeometryPoint point;  // with the share by which its cross is smaller
    double share = 1.0;   // of its full size, as the crowd of all keys leaves it
  };
  std::optional<Place> placeOf(const ViewportContext& context, std::size_t index,
                               const Key& key) const;
  void findAll(const ViewportContext& context);
  // Whether what was found last holds but for a few keys; these are looked up again.
  bool findChanged(const ViewportContext& context);
  void giveRoom(const ViewportContext& context);
  void giveRoomToSelected(const ViewportContext& context);
  void addSelected(const ViewportContext& context);
  // Whether there was a place for it; for a needed one there always is, if it is seen at all.
  bool addNumber(const ViewportContext& context, const Place& place, bool needed) const;

  std::vector<Place> seen_;  // ascending
  // What they were found for.
  KeyList keys_;
  ViewProjection view_;
  double cell_ = 0.0;  // of the crowding; 0: no need to look
  Crowding crowding_, crowdingOfSelected_;
  bool crowded_ = false;
  GeometrySlot crosses_, selected_, current_, hovered_, outside_;
};

// Where a point outside the picture is told at its edge, `edge` pixels from it: on the way to the
// point from what is seen of `seenFrom`, else from the middle.
Vec2 edgePlace(const ViewProjection& view, const Vec3& point, const std::optional<Vec3>& seenFrom,
               double edge);

// The current orientation's VPN and VUP with their handles.
class AimPart {
 public:
  void add(const ViewportContext& context);

 private:
  void addAim(const ViewportContext& context, const Vec3& key, const Vec3& aim);
  void addUp(const ViewportContext& context, const Camera& camera);
  void addCircle(const ViewportContext& context, const Camera& camera, const Vec3& tip);

  GeometrySlot aimLine_, aimRing_, edgeRing_, upLine_, upRing_, circle_;
};

// The current key's other orientations.
class OtherOrientationsPart {
 public:
  // Before what is current; then handles and numbers behind those of what is current.
  void add(const ViewportContext& context);
  void addNumbers(const ViewportContext& context);

 private:
  struct Mark {
    std::size_t orientation;
    Vec2 pixel;   // of the aim, or at the picture's edge
    bool inside;  // the picture
  };
  std::vector<Mark> marks_;  // of the last add()
  GeometrySlot aims_, ups_, rings_;
};

// The curve's tangents at the current key.
class TangentsPart {
 public:
  void add(const ViewportContext& context);

 private:
  GeometrySlot lines_, incoming_, outgoing_;
};

// Ghost cameras along the flight, and the playhead's camera.
class CamerasPart {
 public:
  void add(const ViewportContext& context);

 private:
  void findGhosts(const ViewportContext& context);
  void addPlayhead(const ViewportContext& context);

  Evaluation evaluation_;  // of which the ghosts are
  std::int64_t every_ = 0;
  std::vector<Camera> ghosts_;
  double ghostSize_ = 0.0;
  SharedGeometry ghostGeometry_;
  GeometrySlot playhead_, dot_;
};

// What a drag shows, the plane squares, and the triad.
class DragPart {
 public:
  void addPlanes(const ViewportContext& context);
  void addSquares(const ViewportContext& context);
  void addTriad(const ViewportContext& context);
  // Labels keep off it.
  void blockTriad(const ViewportContext& context) const;

 private:
  void addPlane(const ViewportContext& context, Axis constant, const Vec3& point);
  void addCursor(const ViewportContext& context, const Vec3& point);

  GeometrySlot fill_, outline_;
  std::array<GeometrySlot, 3> axes_, squares_, squareFills_, triad_;
};

}  // namespace vides
