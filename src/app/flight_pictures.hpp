// SPDX-License-Identifier: MIT
// The viewport's and the camera's picture inside the window.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "edit/session.hpp"
#include "panels/ui.hpp"
#include "render/failure.hpp"
#include "render/scene_renderer.hpp"
#include "scene/camera_scene.hpp"
#include "scene/viewport_scene.hpp"

namespace vides {

// The two pictures of a display frame, and how they get into Dear ImGui's draw lists. Each function
// adds its picture at once and draws it when the lists are drawn, straight into the window: what it
// was made of must live so long, and prepare() come before. (A framebuffer of its own for the
// smaller one would double what a software driver compiles before the first picture.)
class FlightPictures {
 public:
  static tl::expected<std::unique_ptr<FlightPictures>, std::string> create(const Gl& gl);

  // The flight from outside, or, with camera view and viewport swapped, what the camera sees.
  void viewport(const Ui& ui, ImDrawList& list, const Rect& rect, const Session& session,
                const std::vector<PlacedScene>& scenes, const ViewportState& state);
  // The other one, in the column.
  void camera(const Ui& ui, ImDrawList& list, const Rect& rect, const Session& session,
              const std::vector<PlacedScene>& scenes, const ViewportState& state);
  // Before the lists are drawn: the size of the framebuffer in pixels.
  void prepare(int width, int height);

  // At the beginning of a display frame: neither picture is on screen so far.
  void begin();

  // Where the flight is seen from outside, and where what the camera sees, in the window; empty
  // where they are not on screen.
  const Rect& flightRect() const { return flightRect_; }
  const Rect& filmRect() const { return filmRect_; }
  // What lies under a pixel of the window, of the flight as drawn last.
  std::optional<HandleId> handleUnder(const Vec2& pixel, std::size_t currentKey,
                                      double contentScale) const;
  // Where the handles of the flight's picture are; none where it isn't drawn.
  std::span<const Handle> handles() const {
    return flightList_ ? std::span<const Handle>(flightList_->handles) : std::span<const Handle>();
  }
  std::optional<CurveHit> curveUnder(const Vec2& pixel, double reach) const;

 private:
  explicit FlightPictures(SceneRenderer renderer) : renderer_(std::move(renderer)) {}
  void add(bool film, const Ui& ui, ImDrawList& list, const Rect& rect, const Session& session,
           const std::vector<PlacedScene>& scenes, const ViewportState& state);
  template <const DrawList* FlightPictures::*kPicture>
  static void draw(const ImDrawList* list, const ImDrawCmd* command);

  SceneRenderer renderer_;
  ViewportScene flightScene_;
  CameraScene filmScene_;
  const DrawList* flightList_ = nullptr;
  const DrawList* filmList_ = nullptr;
  Rect flightRect_, filmRect_;
  int width_ = 0, height_ = 0;
};

}  // namespace vides
