// SPDX-License-Identifier: MIT
// What the viewport shows, by numbers: projections, edges behind, handles, labels, what is kept.
#include "scene/viewport_scene.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "math/projection.hpp"
#include "math/random_view.hpp"
#include "scene/cube_part.hpp"
#include "support/random_flight.hpp"

namespace vides {
namespace {

using test::Random;
constexpr double kDegree = std::numbers::pi / 180.0;

ViewportInput inputOf(const Flight& flight) {
  ViewportInput input;
  input.evaluation = Evaluation(flight);
  input.rectangle = {0, 0, 800, 600};
  return input;
}

Flight sixKeys() {
  Flight flight;
  const Vec3 places[] = {{0.9, -0.1, 0.2},  {0.55, 0.35, -0.75}, {-0.55, 0.35, -0.75},
                         {-0.9, -0.1, 0.2}, {0.3, -0.2, 0.9},    {0.0, 0.1, 0.5}};
  for (const Vec3& place : places) {
    Key key;
    key.position = place;
    key.orientations.front().aim = {0, 0.5, 0};
    flight.keys.push_back(key);
  }
  return flight;
}

EditorView randomEditorView(Random& random) {
  EditorView view;
  view.turn = random.between(-180, 180);
  view.tilt = random.between(-90, 90);
  view.size = std::exp(random.between(std::log(0.25), std::log(4)));
  view.target = 0.3 * random.inCube();
  view.type = random.coin() ? ProjectionType::Parallel : ProjectionType::Perspective;
  return view;
}

std::vector<Handle> handlesOf(const DrawList& list, HandleKind kind) {
  std::vector<Handle> result;
  for (const Handle& handle : list.handles) {
    if (handle.id.kind == kind) result.push_back(handle);
  }
  return result;
}

// The pixel of a point through the matrices of PHIGS, set up from the definition of the editor's
// view alone.
std::optional<Vec2> throughPhigs(const EditorView& view, const PixelRectangle& r, const Vec3& p) {
  const double turn = view.turn * kDegree, tilt = view.tilt * kDegree;
  const Vec3 normal{std::sin(turn) * std::cos(tilt), std::sin(tilt),
                    std::cos(turn) * std::cos(tilt)};
  const Vec3 up{-std::sin(turn) * std::sin(tilt), std::cos(tilt), -std::cos(turn) * std::sin(tilt)};
  const double smaller = std::min(r.width, r.height);
  ViewMapping mapping;
  mapping.type = view.type;
  double halfHeight;
  if (view.type == ProjectionType::Parallel) {
    halfHeight = std::sqrt(3.0) / view.size * r.height / smaller;
    mapping.projectionReferencePoint = {0, 0, 100};
    mapping.frontPlaneDistance = 50;
  } else {
    // The sphere touches the smaller side's edges: sin of half the angle is radius / distance.
    const double half = std::atan(std::tan(15 * kDegree) * smaller / r.height);
    const double distance = std::sqrt(3.0) / std::sin(half) / view.size;
    halfHeight = distance * std::tan(15 * kDegree);
    mapping.projectionReferencePoint = {0, 0, distance};
    mapping.frontPlaneDistance = 0.99 * distance;
  }
  mapping.backPlaneDistance = -100;
  mapping.window = {-halfHeight * r.width / r.height, halfHeight * r.width / r.height, -halfHeight,
                    halfHeight};
  const glm::dvec4 clip =
      *viewMapping(mapping) * viewOrientation(view.target, -normal, up) * glm::dvec4(p, 1.0);
  if (clip.w <= 0.0) return std::nullopt;
  return Vec2{r.x + r.width * (0.5 + 0.5 * clip.x / clip.w),
              r.y + r.height * (0.5 - 0.5 * clip.y / clip.w)};
}

TEST(ViewportScene, KeysAreWhereThePhigsMatricesPutThem) {
  Random random(2);
  int seen = 0, unseen = 0;
  for (int round = 0; round < 300; ++round) {
    ViewportInput input = inputOf(test::randomFlight(random, {}));
    input.view = randomEditorView(random);
    input.rectangle = {random.between(-50, 200), random.between(-50, 200),
                       random.between(100, 1500), random.between(100, 1500)};
    ViewportScene scene;
    const DrawList& list = scene.build(input);
    std::size_t next = 0;
    const auto handles = handlesOf(list, HandleKind::kKey);
    for (std::size_t k = 0; k < input.evaluation.flight().keys.size(); ++k) {
      const auto expected =
          throughPhigs(input.view, input.rectangle, input.evaluation.flight().keys[k].position);
      if (next < handles.size() && handles[next].id.key == k) {
        ASSERT_TRUE(expected);
        EXPECT_LT(glm::distance(*expected, handles[next].pixel), 0.01);
        ++next;
        ++seen;
        continue;
      }
      // Left out only where it is outside.
      if (expected) {
        const PixelRectangle& r = input.rectangle;
        EXPECT_FALSE(expected->x > r.x + 0.01 && expected->y > r.y + 0.01 &&
                     expected->x < r.x + r.width - 0.01 && expected->y < r.y + r.height - 0.01);
      }
      ++unseen;
    }
    EXPECT_EQ(next, handles.size());
  }
  EXPECT_GT(seen, 500);
  EXPECT_GT(unseen, 100);
}

TEST(ViewportScene, EdgesBehindAreThoseThatTheCubeWouldHide) {
  Random random(4);
  for (int round = 0; round < 500; ++round) {
    const ViewProjection view = test::randomView(random);
    const std::uint32_t behind = cubeEdgesBehind(view);
    for (std::size_t i = 0; i < kCubeEdges.size(); ++i) {
      // A step from the edge's middle towards the viewer leads into the cube, or it doesn't.
      const Vec3 middle = 0.5 * (cubeCorner(kCubeEdges[i][0]) + cubeCorner(kCubeEdges[i][1]));
      Vec3 toViewer = -view.viewingDirection();
      if (view.perspective()) toViewer = glm::normalize(view.referencePoint() - middle);
      const Vec3 step = middle + 1e-4 * toViewer;
      bool inside = true, unclear = false;
      for (int axis = 0; axis < 3; ++axis) {
        inside = inside && std::abs(step[axis]) < 1.0;
        unclear = unclear || std::abs(std::abs(step[axis]) - 1.0) < 1e-8;
      }
      if (unclear) continue;
      EXPECT_EQ((behind >> i & 1) != 0, inside) << round << " edge " << i;
    }
  }
}

TEST(ViewportScene, NamedViewsShowTheFrontSolid) {
  EditorView front;
  front.turn = front.tilt = 0;
  const std::uint32_t behind = cubeEdgesBehind(viewProjection(front, {0, 0, 800, 600}));
  for (std::size_t i = 0; i < kCubeEdges.size(); ++i) {
    const bool inFront = cubeCorner(kCubeEdges[i][0]).z > 0 && cubeCorner(kCubeEdges[i][1]).z > 0;
    EXPECT_EQ((behind >> i & 1) == 0, inFront) << i;
  }
  EXPECT_EQ(std::popcount(cubeEdgesBehind(viewProjection(EditorView{}, {0, 0, 800, 600}))), 3);
}

TEST(ViewportScene, TurningKeepsTheGeometry) {
  ViewportInput input = inputOf(sixKeys());
  SceneGeometry geometry;
  geometry.positions = {{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}};
  geometry.edges = {{0, 1}, {1, 2}};
  input.scenes = {DrawableScene::make(geometry)};
  ViewportScene scene;
  const auto big = [&] {
    std::set<const Geometry*> result;
    for (const DrawItem& item : scene.build(input).items) {
      if (item.space == DrawSpace::kCube && item.geometry->points.size() != 75) {
        result.insert(item.geometry.get());
      }
    }
    return result;
  };
  input.shown.upCircle = input.shown.up = input.shown.playhead = false;
  const auto before = big();
  for (int i = 0; i < 10; ++i) {
    input.view.turn += 2.0;
    EXPECT_EQ(big(), before);
  }
}

TEST(ViewportScene, TheCurrentSectionHasItsOwnColour) {
  ViewportInput input = inputOf(sixKeys());
  ViewportScene scene;
  for (std::size_t key = 0; key < 6; ++key) {
    input.state.current = {key, 0};
    std::size_t accent = 0, curve = 0;
    for (const DrawItem& item : scene.build(input).items) {
      const auto* style = std::get_if<LineStyle>(&item.style);
      if (style == nullptr || item.geometry->primitive != Primitive::kPolylines) continue;
      if (style->colour == input.theme[ColourRole::kAccent]) {
        accent += item.count;
        EXPECT_FLOAT_EQ(style->width, 3.0f);
        // It begins at the current key.
        const GeometryPoint& first = item.geometry->points[item.first + 1];
        EXPECT_FLOAT_EQ(first.x, static_cast<float>(sixKeys().keys[key].position.x));
      } else if (style->colour == input.theme[ColourRole::kCurve]) {
        curve += item.count;
        EXPECT_FLOAT_EQ(style->width, 2.2f);
      }
    }
    EXPECT_GT(curve, 0u);
    EXPECT_EQ(accent > 0, key < 5) << key;  // the last key of an open flight begins nothing
  }
}

TEST(ViewportScene, LabelsCoverNoCrossesAndNotEachOther) {
  Random random(8);
  int labels = 0;
  for (int round = 0; round < 60; ++round) {
    ViewportInput input = inputOf(test::randomFlight(random, {}));
    input.view = randomEditorView(random);
    input.view.size = 0.9;
    ViewportScene scene;
    const DrawList& list = scene.build(input);
    std::vector<std::pair<Vec2, Vec2>> boxes;
    for (const DrawText& text : list.texts) {
      const double width = input.text.digitWidth * static_cast<double>(text.text.size());
      boxes.emplace_back(text.pixel, text.pixel + Vec2{width, input.text.lineHeight});
    }
    labels += static_cast<int>(boxes.size());
    int covered = 0;
    for (const auto& [low, high] : boxes) {
      EXPECT_GE(low.x, 0);
      EXPECT_LE(high.y, 600);
      for (const Handle& handle : handlesOf(list, HandleKind::kKey)) {
        if (handle.pixel.x > low.x && handle.pixel.x < high.x && handle.pixel.y > low.y &&
            handle.pixel.y < high.y) {
          ++covered;
        }
      }
      for (const auto& [otherLow, otherHigh] : boxes) {
        if (otherLow != low && otherLow.x + 4 < high.x && low.x + 4 < otherHigh.x &&
            otherLow.y + 4 < high.y && low.y + 4 < otherHigh.y) {
          ++covered;
        }
      }
    }
    EXPECT_EQ(covered, 0) << round;
  }
  EXPECT_GT(labels, 300);
}

TEST(ViewportScene, LabelsKeepAwayFromWhatStandsOverThePicture) {
  Random random(9);
  int elsewhere = 0;
  for (int round = 0; round < 60; ++round) {
    ViewportInput input = inputOf(test::randomFlight(random, {}));
    input.view = randomEditorView(random);
    input.view.size = 0.9;
    ViewportScene scene;
    const std::vector<DrawText> before = scene.build(input).texts;
    if (before.empty()) continue;
    // Where a label stood.
    const DrawText& first = before.front();
    const double width = input.text.letterWidth * static_cast<double>(first.text.size());
    const PixelRectangle box{first.pixel.x, first.pixel.y, width, input.text.lineHeight};
    input.state.covered = {box};
    for (const DrawText& text : scene.build(input).texts) {
      const double own = input.text.letterWidth * static_cast<double>(text.text.size());
      const bool covers = text.pixel.x < box.x + box.width && box.x < text.pixel.x + own &&
                          text.pixel.y < box.y + box.height &&
                          box.y < text.pixel.y + input.text.lineHeight;
      EXPECT_FALSE(covers) << round << ": " << text.text;
      if (text.text == first.text && text.pixel != first.pixel) ++elsewhere;
    }
  }
  EXPECT_GT(elsewhere, 40);
}

TEST(ViewportScene, NumbersCountFromOne) {
  ViewportInput input = inputOf(sixKeys());
  ViewportScene scene;
  std::set<std::string> texts;
  for (const DrawText& text : scene.build(input).texts) texts.insert(text.text);
  EXPECT_EQ(texts,
            (std::set<std::string>{"1", "2", "3", "4", "5", "6", "VUP", "aim", "x", "y", "z"}));
  input.text.aim = "Blickpunkt";
  input.shown.axes = input.shown.numbers = false;
  texts.clear();
  for (const DrawText& text : scene.build(input).texts) texts.insert(text.text);
  EXPECT_EQ(texts, (std::set<std::string>{"VUP", "Blickpunkt"}));
}

TEST(ViewportScene, WhatIsHiddenIsNeitherDrawnNorPicked) {
  ViewportInput input = inputOf(sixKeys());
  input.shown = {};
  for (bool ShownElements::*element :
       {&ShownElements::cube, &ShownElements::scene, &ShownElements::curve, &ShownElements::keys,
        &ShownElements::aim, &ShownElements::up, &ShownElements::upCircle, &ShownElements::axes,
        &ShownElements::ghosts, &ShownElements::playhead}) {
    input.shown.*element = false;
  }
  ViewportScene scene;
  const DrawList& list = scene.build(input);
  EXPECT_TRUE(list.items.empty());
  EXPECT_TRUE(list.texts.empty());
  EXPECT_TRUE(list.handles.empty());
}

TEST(ViewportScene, PlaneSquaresStandSixteenPixelsAway) {
  ViewportInput input = inputOf(sixKeys());
  input.state.current = {2, 0};
  for (const double scale : {1.0, 2.0}) {
    input.contentScale = scale;
    ViewportScene scene;
    const DrawList& list = scene.build(input);
    const auto squares = handlesOf(list, HandleKind::kPlane);
    ASSERT_EQ(squares.size(), 3u);
    const Vec2 key = *list.view.project(input.evaluation.flight().keys[2].position);
    for (const Handle& square : squares) {
      EXPECT_NEAR(glm::distance(square.pixel, key), 16.0 * scale, 1e-9);
      for (const Handle& other : squares) {
        if (!(other.id == square.id)) {
          EXPECT_GT(glm::distance(square.pixel, other.pixel), 12.0 * scale);
        }
      }
    }
  }
  // From the front the planes x and y are seen edge-on: nothing can be dragged in them.
  input.view.turn = input.view.tilt = 0;
  ViewportScene scene;
  const auto squares = handlesOf(scene.build(input), HandleKind::kPlane);
  ASSERT_EQ(squares.size(), 1u);
  EXPECT_EQ(squares.front().id.axis, Axis::Z);
}

TEST(ViewportScene, TheVupIsAsLongInEveryView) {
  Camera camera;
  camera.viewReferencePoint = {0.3, 0.2, 0.1};
  EditorView view;
  view.turn = view.tilt = 0;  // VUP = y lies across the view
  for (const auto type : {ProjectionType::Parallel, ProjectionType::Perspective}) {
    for (const double size : {0.25, 1.0, 4.0}) {
      view.type = type;
      view.size = size;
      const ViewProjection projection = viewProjection(view, {0, 0, 800, 600});
      const Vec3 tip = upTip(projection, camera, 1.5);
      EXPECT_NEAR(
          glm::distance(*projection.project(tip), *projection.project(camera.viewReferencePoint)),
          1.5 * kUpPixels, 1e-6);
    }
  }
}

TEST(ViewportScene, AimsOutsideAreMarkedAtTheEdge) {
  const PixelRectangle r{100, 50, 800, 600};
  EditorView editor;
  editor.turn = editor.tilt = 0;
  const ViewProjection view = viewProjection(editor, r);
  AimMark mark = aimMark(view, {0, 0, 0}, {0.5, 0, 0}, 1.0);
  EXPECT_FALSE(mark.atEdge);
  EXPECT_NEAR(mark.pixel.y, 350, 1e-9);
  mark = aimMark(view, {0, 0, 0}, {100, 0, 0}, 1.0);  // to the right
  EXPECT_TRUE(mark.atEdge);
  EXPECT_NEAR(mark.pixel.x, 100 + 800 - 12, 1e-9);
  EXPECT_NEAR(mark.pixel.y, 350, 1e-9);
  mark = aimMark(view, {0, 0, 0}, {-50, 50, 0}, 1.0);  // 45 degrees up: the upper edge
  EXPECT_NEAR(mark.pixel.y, 50 + 12, 1e-9);
  EXPECT_NEAR(500 - mark.pixel.x, 350 - mark.pixel.y, 1e-9);

  // Behind the viewer of a perspective: where the arrow leaves the picture.
  editor.type = ProjectionType::Perspective;
  const ViewProjection perspective = viewProjection(editor, r);
  const Vec3 key{0.5, 0, 0}, aim{0.6, 0, 20};
  ASSERT_FALSE(perspective.project(aim));
  mark = aimMark(perspective, key, aim, 1.0);
  EXPECT_TRUE(mark.atEdge);
  EXPECT_NEAR(mark.pixel.x, 100 + 800 - 12, 1e-9);
  const Vec2 away = *perspective.project(key + 0.2 * (aim - key)) - *perspective.project(key);
  const Vec2 toMark = mark.pixel - *perspective.project(key);
  EXPECT_NEAR(away.x * toMark.y - away.y * toMark.x, 0.0, 1e-6);
  EXPECT_GT(glm::dot(away, toMark), 0.0);
}

TEST(ViewportScene, RingsAtTheEdgeCanBePicked) {
  Flight flight = sixKeys();
  Key key = flight.keys[1];
  setAimPoint(key, key.orientations.front(), {500, 20, 3});
  flight.keys.set(1, key);
  ViewportInput input = inputOf(flight);
  input.state.current = {1, 0};
  ViewportScene scene;
  const DrawList& list = scene.build(input);
  const auto aims = handlesOf(list, HandleKind::kAim);
  ASSERT_EQ(aims.size(), 1u);
  EXPECT_EQ(handleAt(list, aims[0].pixel + Vec2{3, 3}, 1, 1.0),
            (HandleId{HandleKind::kAim, 1, 0, Axis::X}));
}

TEST(ViewportScene, PickingPrefersTheNearestAndThenTheCurrent) {
  DrawList list;
  const auto handle = [](std::size_t key, double x) {
    return Handle{{HandleKind::kKey, key, 0, Axis::X}, {x, 0}, 10.0};
  };
  list.handles = {handle(0, 0), handle(1, 5), handle(2, 30)};
  const auto picked = [&](double x, std::size_t current) -> int {
    const auto id = handleAt(list, {x, 0}, current, 1.0);
    return id ? static_cast<int>(id->key) : -1;
  };
  EXPECT_EQ(picked(1.0, 2), 0);  // the nearest
  EXPECT_EQ(picked(1.0, 1), 1);  // within 3 pixels of equal: the current key's
  EXPECT_EQ(picked(0.9, 1), 0);  // 4.1 - 0.9 is more than 3
  EXPECT_EQ(picked(4.0, 0), 0);
  EXPECT_EQ(picked(14.9, 0), 1);  // the current one is beyond its radius
  EXPECT_EQ(picked(17.0, 0), -1);
}

TEST(ViewportScene, ADragShowsItsPlaneAndAxesOnTheFaces) {
  ViewportInput input = inputOf(sixKeys());
  const Vec3 point{0.25, -0.5, 0.75};
  input.state.drag = DragDisplay{point, Axis::Y};
  ViewportScene scene;
  bool outline = false;
  int axes = 0;
  for (const DrawItem& item : scene.build(input).items) {
    const auto* style = std::get_if<LineStyle>(&item.style);
    const auto& p = item.geometry->points;
    if (style == nullptr || item.space != DrawSpace::kCube) continue;
    for (int axis = 0; axis < 3; ++axis) {
      if (style->colour !=
          input.theme[static_cast<ColourRole>(static_cast<int>(ColourRole::kAxisX) + axis)]) {
        continue;
      }
      ++axes;
      Vec3 from = point, to = point;
      from[axis] = -1, to[axis] = 1;
      EXPECT_EQ(p[0], geometryPoint(from));
      EXPECT_EQ(p[1], geometryPoint(to));
    }
    if (style->colour == faded(input.theme[ColourRole::kAxisY], 0.9)) {
      outline = true;
      ASSERT_EQ(p.size(), 8u);
      for (const GeometryPoint& corner : p) {
        EXPECT_FLOAT_EQ(corner.y, -0.5f);
        EXPECT_EQ(std::abs(corner.x), 1.0f);
        EXPECT_EQ(std::abs(corner.z), 1.0f);
      }
    }
  }
  EXPECT_EQ(axes, 3);
  EXPECT_TRUE(outline);
}

TEST(ViewportScene, HoverShowsTheLeftButtonsPlane) {
  ViewportInput input = inputOf(sixKeys());
  ViewportScene scene;
  const auto fills = [&] {
    int count = 0;
    for (const DrawItem& item : scene.build(input).items) {
      const auto* style = std::get_if<FillStyle>(&item.style);
      if (style == nullptr || item.space != DrawSpace::kCube) continue;
      EXPECT_EQ(style->colour, faded(input.theme[ColourRole::kAxisX], 0.07));
      ++count;
    }
    return count;
  };
  EXPECT_EQ(fills(), 0);
  input.state.hovered = HandleId{HandleKind::kKey, 3, 0, Axis::X};
  EXPECT_EQ(fills(), 1);
  input.state.showHoverPlane = false;
  EXPECT_EQ(fills(), 0);
}

// The widest line of a colour, and the largest marker.
float widthOf(const DrawList& list, const Colour& colour) {
  float width = 0.0f;
  for (const DrawItem& item : list.items) {
    const auto* style = std::get_if<LineStyle>(&item.style);
    if (style != nullptr && style->colour == colour) width = std::max(width, style->width);
  }
  return width;
}
float crossOf(const DrawList& list, const Colour& colour) {
  float radius = 0.0f;
  for (const DrawItem& item : list.items) {
    const auto* style = std::get_if<MarkerStyle>(&item.style);
    if (style != nullptr && style->shape == MarkerShape::kCross && style->colour == colour) {
      radius = std::max(radius, style->radius);
    }
  }
  return radius;
}

TEST(ViewportScene, GhostsStandEveryNFrames) {
  ViewportInput input = inputOf(sixKeys());
  ViewportScene scene;
  const auto ghosts = [&]() -> std::size_t {
    for (const DrawItem& item : scene.build(input).items) {
      const auto* style = std::get_if<LineStyle>(&item.style);
      if (style != nullptr && style->colour == input.theme[ColourRole::kGhost]) {
        EXPECT_EQ(item.geometry->elements() % 8, 0u);
        return item.geometry->elements() / 8;
      }
    }
    return 0;
  };
  const auto frames = static_cast<std::size_t>(input.evaluation.frameCount());
  input.shown.ghostEvery = 25;
  EXPECT_EQ(ghosts(), (frames + 24) / 25);
  input.shown.ghostEvery = 0;
  EXPECT_LE(ghosts(), static_cast<std::size_t>(kMostGhosts));
  EXPECT_GT(ghosts(), 40u);
}

// Close to each other ghosts would be one blot: they are drawn where there is room, or where the
// camera looks elsewhere.
TEST(ViewportScene, GhostsKeepApart) {
  ViewportInput input = inputOf(sixKeys());
  input.shown.ghostEvery = 1;
  ViewportScene scene;
  for (const DrawItem& item : scene.build(input).items) {
    const auto* style = std::get_if<LineStyle>(&item.style);
    if (style == nullptr || style->colour != input.theme[ColourRole::kGhost]) continue;
    const auto at = [&](std::size_t i) {
      const GeometryPoint& p = item.geometry->points[i];
      return Vec3{p.x, p.y, p.z};
    };
    // Eight edges; the first one and the fifth lead from the eye to corners that face each other.
    const auto ahead = [&](std::size_t i) {
      return glm::normalize(at(i + 1) + at(i + 9) - 2.0 * at(i));
    };
    ASSERT_GT(item.geometry->points.size(), 32u);
    for (std::size_t i = 16; i < item.geometry->points.size(); i += 16) {
      const double size = glm::distance(at(i), at(i + 1));
      const bool turned = glm::dot(ahead(i), ahead(i - 16)) < 0.95;
      EXPECT_TRUE(turned || glm::distance(at(i), at(i - 16)) > 0.59 * size) << i;
    }
    return;
  }
  FAIL() << "no ghosts";
}

// In a picture too small for signs of full size they shrink, what is only of help is left out, and
// what the hand takes hold of is no harder to hit.
TEST(ViewportScene, SmallPicturesHaveSmallSigns) {
  ViewportInput input = inputOf(sixKeys());
  input.rectangle = {0, 0, 1200, 900};
  const auto count = [](const DrawList& list, HandleKind kind) {
    return std::ranges::count_if(list.handles, [&](const Handle& h) { return h.id.kind == kind; });
  };
  ViewportScene scene;
  const DrawList large = scene.build(input);
  EXPECT_EQ(count(large, HandleKind::kPlane), 3);
  EXPECT_EQ(large.texts.size(), 6u + 2u + 3u);
  input.rectangle = {0, 0, 230, 130};
  const DrawList small = scene.build(input);
  EXPECT_EQ(count(small, HandleKind::kPlane), 0);
  EXPECT_EQ(count(small, HandleKind::kKey), 6);
  EXPECT_EQ(small.texts.size(), 1u + 2u);  // the current key's number, VUP and aim
  EXPECT_LT(crossOf(small, input.theme[ColourRole::kKey]),
            0.6f * crossOf(large, input.theme[ColourRole::kKey]));
  EXPECT_EQ(small.handles.front().radius, large.handles.front().radius);
  const Camera camera = input.evaluation.cameraAt(input.state.current);
  EXPECT_NEAR(glm::distance(camera.viewReferencePoint, upTip(small.view, camera, 1.0)) *
                  small.view.pixelsPerUnit(),
              kUpPixels * signScale(input.rectangle, 1.0), 1e-9);
}

// Outside the picture the current key is told at its edge, where the way to it leaves the picture.
TEST(ViewportScene, ACurrentKeyOutsideIsToldAtTheEdge) {
  ViewportInput input = inputOf(sixKeys());
  const auto ringAtEdge = [&](const DrawList& list) -> std::optional<Vec2> {
    for (const DrawItem& item : list.items) {
      const auto* style = std::get_if<MarkerStyle>(&item.style);
      if (style != nullptr && style->shape == MarkerShape::kCross &&
          item.space == DrawSpace::kPixels) {
        return Vec2{item.geometry->points[0].x, item.geometry->points[0].y};
      }
    }
    return std::nullopt;
  };
  ViewportScene scene;
  EXPECT_FALSE(ringAtEdge(scene.build(input)));
  const Vec3 key = input.evaluation.flight().keys[input.state.current.key].position;
  // The key far to the right of the middle, at the same height.
  input.view.turn = 0.0;
  input.view.tilt = 0.0;
  input.view.size = 2.0;
  input.view.target = key - Vec3{5.0, 0.0, 0.0};
  const auto at = ringAtEdge(scene.build(input));
  ASSERT_TRUE(at);
  const PixelRectangle& r = input.rectangle;
  EXPECT_NEAR(at->x, r.x + r.width - 14.0 * signScale(r, input.contentScale), 1e-3);
  EXPECT_NEAR(at->y, r.y + 0.5 * r.height, 1e-3);
  input.shown.keys = false;
  EXPECT_FALSE(ringAtEdge(scene.build(input)));
}

TEST(ViewportScene, LinesAndHandlesHaveTheChosenSizes) {
  ViewportInput input = inputOf(sixKeys());
  ViewportScene scene;
  const Theme& t = input.theme;
  // What 8-looks says, at twice the content scale.
  input.contentScale = 2.0;
  const DrawList& plain = scene.build(input);
  EXPECT_FLOAT_EQ(widthOf(plain, t[ColourRole::kCurve]), 4.4f);
  EXPECT_FLOAT_EQ(widthOf(plain, t[ColourRole::kAccent]), 6.0f);
  EXPECT_FLOAT_EQ(widthOf(plain, t[ColourRole::kCube]), 2.4f);
  EXPECT_FLOAT_EQ(crossOf(plain, t[ColourRole::kKey]), 14.0f);
  for (const Handle& handle : handlesOf(plain, HandleKind::kKey)) {
    EXPECT_DOUBLE_EQ(handle.radius, 20.0);
  }
  input.sizes = {4.4, 3.0, 14.0, 30.0};
  const DrawList& large = scene.build(input);
  EXPECT_FLOAT_EQ(widthOf(large, t[ColourRole::kCurve]), 8.8f);
  EXPECT_FLOAT_EQ(widthOf(large, t[ColourRole::kAccent]), 12.0f);
  EXPECT_FLOAT_EQ(widthOf(large, t[ColourRole::kCube]), 6.0f);
  EXPECT_FLOAT_EQ(crossOf(large, t[ColourRole::kKey]), 28.0f);
  // Who sees larger handles takes hold of them from farther away.
  for (const HandleKind kind : {HandleKind::kKey, HandleKind::kAim, HandleKind::kUp}) {
    for (const Handle& handle : handlesOf(large, kind)) EXPECT_DOUBLE_EQ(handle.radius, 40.0);
  }
  for (const Handle& handle : handlesOf(large, HandleKind::kPlane)) {
    EXPECT_DOUBLE_EQ(handle.radius, 32.0);
  }
}

// The lines of the grid by where they stand on the x axis, those of every fifth apart.
std::set<double> gridLines(const DrawList& list, const Theme& theme, bool strong) {
  std::set<double> places;
  for (const DrawItem& item : list.items) {
    const auto* style = std::get_if<LineStyle>(&item.style);
    if (style == nullptr || item.lift != -3) continue;
    if ((style->colour == theme[ColourRole::kGrid]) != strong) continue;
    for (std::size_t i = 0; i + 1 < item.geometry->points.size(); i += 2) {
      const GeometryPoint &a = item.geometry->points[i], &b = item.geometry->points[i + 1];
      EXPECT_EQ(a.y, -1.0f);
      EXPECT_EQ(b.y, -1.0f);
      EXPECT_FLOAT_EQ(std::hypot(a.x - b.x, a.z - b.z), 2.0f);
      if (a.x == b.x) places.insert(std::round(static_cast<double>(a.x) * 1e4) / 1e4);
    }
  }
  return places;
}

TEST(ViewportScene, TheGridHasTheStepsOfSnappingOrEveryFifth) {
  ViewportInput input = inputOf(sixKeys());
  ViewportScene scene;
  const auto lines = [&](bool strong) {
    return gridLines(scene.build(input), input.theme, strong);
  };
  EXPECT_TRUE(lines(true).empty() && lines(false).empty());  // hidden by default
  input.shown.grid = true;
  // Near enough for the steps themselves. The cube's own edges are left to it.
  input.view.size = 2.0;
  EXPECT_EQ(lines(true), (std::set<double>{-0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75}));
  EXPECT_EQ(lines(false).size(), 32u);
  EXPECT_TRUE(lines(false).contains(0.05));
  input.shown.cube = false;
  EXPECT_TRUE(lines(true).contains(1.0));
  // From afar they are five times as far apart.
  input.view.size = 0.5;
  EXPECT_EQ(lines(true), (std::set<double>{0.0}));
  EXPECT_EQ(lines(false), (std::set<double>{-1.0, -0.75, -0.5, -0.25, 0.25, 0.5, 0.75, 1.0}));
  input.view.size = 2.0;
  input.gridStep = 0.5;
  EXPECT_EQ(lines(false), (std::set<double>{-1.0, -0.5, 0.5, 1.0}));
}

TEST(ViewportScene, TheNearestPlaceOnTheCurveHasItsFraction) {
  ViewportInput input = inputOf(sixKeys());
  ViewportScene scene;
  const DrawList& list = scene.build(input);
  for (const double fraction : {0.1, 0.35, 0.8}) {
    const Vec2 pixel = *list.view.project(input.evaluation.piecePoint(3, fraction));
    const auto hit = scene.nearestOnCurve(pixel, 5.0);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->piece, 3u);
    EXPECT_NEAR(hit->fraction, fraction, 1e-4);
    EXPECT_LT(hit->distance, 0.01);
  }
  EXPECT_FALSE(scene.nearestOnCurve({1, 1}, 5.0));
}

TEST(ViewportScene, AnySurroundingsMakeAList) {
  Random random(6);
  for (const PixelRectangle& r :
       {PixelRectangle{0, 0, 0, 0}, PixelRectangle{0, 0, 1, 1}, PixelRectangle{0, 0, 16000, 100},
        PixelRectangle{-500, 3, 17, 4000}}) {
    for (int round = 0; round < 20; ++round) {
      ViewportInput input = inputOf(test::randomFlight(random, {true, 20}));
      input.rectangle = r;
      input.view = randomEditorView(random);
      input.view.size = round % 2 == 0 ? 0.25 : 20.0;
      input.contentScale = round % 3 == 0 ? 0.75 : 3.0;
      input.margins = {30, 30, 30, 30};
      ViewportScene scene;
      for (const DrawText& text : scene.build(input).texts) {
        EXPECT_TRUE(std::isfinite(text.pixel.x) && std::isfinite(text.pixel.y));
      }
      for (const Handle& handle : scene.build(input).handles) {
        EXPECT_TRUE(std::isfinite(handle.pixel.x) && std::isfinite(handle.pixel.y));
      }
    }
  }
}

// Keys along a screw line around the y axis.
Flight screw(std::size_t count, double turns) {
  std::vector<KeyPointer> keys;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count);
    const double angle = 2.0 * std::numbers::pi * turns * share;
    Key key;
    key.position = {0.8 * std::cos(angle), 1.6 * share - 0.8, 0.8 * std::sin(angle)};
    key.orientations.front().aim = {0, 0, 0};
    keys.emplace_back(key);
  }
  Flight flight;
  flight.keys = KeyList(std::move(keys));
  return flight;
}

// The items of crosses or squares of a colour, and how large each of their signs is drawn.
std::vector<double> sharesOf(const DrawList& list, MarkerShape shape, const Colour& colour) {
  std::vector<double> shares;
  for (const DrawItem& item : list.items) {
    const auto* style = std::get_if<MarkerStyle>(&item.style);
    if (style == nullptr || style->shape != shape || style->colour != colour) continue;
    for (const auto& point : item.geometry->points) {
      shares.push_back(1.0 - static_cast<double>(point.along));
    }
  }
  return shares;
}

TEST(ViewportScene, ManyKeysAreThinnedButAllCanBePicked) {
  Random random(6);
  std::vector<KeyPointer> keys;
  for (int i = 0; i < 20000; ++i) {
    Key key;
    key.position = 0.9 * random.inCube();
    key.orientations.front().aim = {0, 0, 5};
    keys.emplace_back(key);
  }
  Flight flight;
  flight.keys = KeyList(std::move(keys));
  ViewportInput input = inputOf(flight);
  ViewportScene scene;
  const DrawList& list = scene.build(input);
  EXPECT_EQ(handlesOf(list, HandleKind::kKey).size(), 20000u);
  // What they cover, as if they were squares: a small part of what the flight does.
  double covered = 0.0;
  std::size_t crosses = 0;
  for (const double share : sharesOf(list, MarkerShape::kCross, input.theme[ColourRole::kKey])) {
    EXPECT_GT(share, 0.0);
    covered += 100.0 * share * share;
    ++crosses;
  }
  EXPECT_LT(covered, 0.1 * 350 * 350);
  EXPECT_GT(crosses, 500u);
  EXPECT_LT(list.texts.size(), 300u);
}

TEST(ViewportScene, FewKeysHaveWholeCrosses) {
  Random random(61);
  // One behind the other, as the front view of a dolly shows them.
  Flight line = sixKeys();
  while (line.keys.size() < 32) {
    Key key = line.keys[0];
    key.position.z = 1.0 - 0.06 * static_cast<double>(line.keys.size());
    line.keys.push_back(key);
  }
  ViewportInput front = inputOf(line);
  front.view.turn = front.view.tilt = 0.0;
  ViewportScene frontScene;
  EXPECT_EQ(sharesOf(frontScene.build(front), MarkerShape::kCross, front.theme[ColourRole::kKey]),
            std::vector<double>(31, 1.0));
  for (int round = 0; round < 40; ++round) {
    Flight flight = sixKeys();
    for (std::size_t k = 0; k < 6; ++k) {
      Key key = flight.keys[k];
      key.position += 0.1 * random.inCube();
      flight.keys.set(k, std::move(key));
    }
    ViewportInput input = inputOf(flight);
    ViewportScene scene;
    const DrawList& list = scene.build(input);
    const auto shares = sharesOf(list, MarkerShape::kCross, input.theme[ColourRole::kKey]);
    EXPECT_EQ(shares, std::vector<double>(5, 1.0));
    // The arrows are hidden by what stands before them, as long as no crosses crowd.
    for (const DrawItem& item : list.items) {
      EXPECT_TRUE(item.lift != 3 || item.depth == DrawDepth::kTested);
    }
  }
}

// Crosses that would touch leave half of the curve free.
TEST(ViewportScene, CrossesAreNarrowerThanTheyStandApart) {
  for (const std::size_t count : {300u, 1000u, 4000u}) {
    ViewportInput input = inputOf(screw(count, 4));
    input.view.tilt = 35.0;
    ViewportScene scene;
    const DrawList& list = scene.build(input);
    const auto handles = handlesOf(list, HandleKind::kKey);
    ASSERT_EQ(handles.size(), count);
    double length = 0.0;
    for (std::size_t i = 1; i < count; ++i) {
      length += glm::distance(handles[i - 1].pixel, handles[i].pixel);
    }
    double widths = 0.0;
    for (const double share : sharesOf(list, MarkerShape::kCross, input.theme[ColourRole::kKey])) {
      widths += 9.9 * share;
    }
    EXPECT_LT(widths, 0.75 * length) << count;
    EXPECT_GT(widths, 0.2 * length) << count;
  }
}

// A little turn changes little: no cross comes or goes, none changes its size by much.
TEST(ViewportScene, CrossesDoNotFlickerWhileTheViewTurns) {
  ViewportInput input = inputOf(screw(3000, 10));
  input.state.current.key = 1500;
  ViewportScene scene;
  const auto sizes = [&] {
    std::map<std::array<float, 3>, float> result;
    for (const DrawItem& item : scene.build(input).items) {
      const auto* style = std::get_if<MarkerStyle>(&item.style);
      if (style == nullptr || style->shape != MarkerShape::kCross) continue;
      for (const auto& p : item.geometry->points) result[{p.x, p.y, p.z}] = 1.0f - p.along;
    }
    return result;
  };
  auto before = sizes();
  for (int step = 0; step < 40; ++step) {
    input.view.turn += 0.1;
    const auto now = sizes();
    const auto compare = [&](const auto& a, const auto& b) {
      for (const auto& [place, size] : a) {
        const auto other = b.find(place);
        ASSERT_NEAR(size, other == b.end() ? 0.0f : other->second, 0.1f) << step;
      }
    };
    compare(before, now);
    compare(now, before);
    before = now;
  }
}

// Over all the others, in this order.
TEST(ViewportScene, WhatIsCurrentLiesOverCrowdedCrosses) {
  ViewportInput input = inputOf(screw(3000, 10));
  input.state.current.key = 1500;
  input.state.hovered = HandleId{HandleKind::kKey, 800, 0, Axis::X};
  ViewportScene scene;
  const DrawList& list = scene.build(input);
  const auto colourOf = [](const DrawItem& item) {
    return std::visit([](const auto& style) { return style.colour; }, item.style);
  };
  const auto lastOnTop = [&](Primitive primitive, ColourRole role) {
    std::ptrdiff_t last = -1;
    for (std::size_t i = 0; i < list.items.size(); ++i) {
      const DrawItem& item = list.items[i];
      if (item.depth == DrawDepth::kOnTop && item.geometry->primitive == primitive &&
          colourOf(item) == input.theme[role]) {
        last = static_cast<std::ptrdiff_t>(i);
      }
    }
    return last;
  };
  std::ptrdiff_t crosses = -1;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const auto* style = std::get_if<MarkerStyle>(&list.items[i].style);
    if (style == nullptr || style->shape != MarkerShape::kCross) continue;
    if (list.items[i].geometry->points.size() > 1) crosses = static_cast<std::ptrdiff_t>(i);
  }
  ASSERT_GE(crosses, 0);
  EXPECT_GT(lastOnTop(Primitive::kPolylines, ColourRole::kAccent), crosses);  // the section
  EXPECT_GT(lastOnTop(Primitive::kSegments, ColourRole::kAim), crosses);
  EXPECT_GT(lastOnTop(Primitive::kSegments, ColourRole::kUp), crosses);
  EXPECT_GT(lastOnTop(Primitive::kPolylines, ColourRole::kUp), crosses);  // the circle
  const auto own = lastOnTop(Primitive::kMarkers, ColourRole::kAccent);
  EXPECT_GT(own, lastOnTop(Primitive::kSegments, ColourRole::kAim));
  // The hovered one last of all, whole and a step larger, with its number.
  EXPECT_GT(lastOnTop(Primitive::kMarkers, ColourRole::kKey), own);
  const DrawItem& hovered =
      list.items[static_cast<std::size_t>(lastOnTop(Primitive::kMarkers, ColourRole::kKey))];
  EXPECT_EQ(hovered.geometry->points.front().along, 0.0f);
  EXPECT_EQ(std::get<MarkerStyle>(hovered.style).radius, 8.5f);
  EXPECT_TRUE(std::ranges::any_of(list.texts, [](const auto& t) { return t.text == "801"; }));
}

// Selected keys are whole among however many others, and only crowd each other.
TEST(ViewportScene, SelectedKeysAreWholeAmongMany) {
  ViewportInput input = inputOf(screw(3000, 10));
  input.state.current.key = 1501;
  input.state.selected = {301, 1501, 2101};
  ViewportScene scene;
  const auto squares = [&] {
    return sharesOf(scene.build(input), MarkerShape::kSquare,
                    input.theme[ColourRole::kKeySelected]);
  };
  EXPECT_EQ(squares(), std::vector<double>(3, 1.0));
  const auto crosses =
      sharesOf(scene.build(input), MarkerShape::kCross, input.theme[ColourRole::kKey]);
  EXPECT_EQ(std::ranges::count(crosses, 1.0), 2);
  input.state.selected.clear();
  for (std::size_t k = 0; k < 3000; ++k) input.state.selected.push_back(k);
  const auto all = squares();
  EXPECT_LT(all.size(), 2500u);
  EXPECT_EQ(std::ranges::count(all, 1.0), 1);  // the current one
}

// Ends of lines at the current key: thirds of the tangents by Kochanek and Bartels' formulas.
void expectSame(const DrawList& kept, const DrawList& fresh) {
  ASSERT_EQ(kept.handles.size(), fresh.handles.size());
  for (std::size_t i = 0; i < fresh.handles.size(); ++i) {
    ASSERT_EQ(kept.handles[i].id, fresh.handles[i].id) << i;
    ASSERT_EQ(kept.handles[i].pixel, fresh.handles[i].pixel) << i;
  }
  ASSERT_EQ(kept.texts.size(), fresh.texts.size());
  for (std::size_t i = 0; i < fresh.texts.size(); ++i) {
    ASSERT_EQ(kept.texts[i].text, fresh.texts[i].text) << i;
    ASSERT_EQ(kept.texts[i].pixel, fresh.texts[i].pixel) << i;
  }
  ASSERT_EQ(kept.items.size(), fresh.items.size());
  for (std::size_t i = 0; i < fresh.items.size(); ++i) {
    ASSERT_TRUE(kept.items[i].geometry->points == fresh.items[i].geometry->points) << i;
    ASSERT_EQ(kept.items[i].depth, fresh.items[i].depth) << i;
  }
}

// What is kept from one display frame to the next is never what was.
TEST(ViewportScene, AfterAnyEditIsTheSameAsFromScratch) {
  Random random(31);
  for (int round = 0; round < 6; ++round) {
    Flight flight = sixKeys();
    while (flight.keys.size() < 150) flight.keys.push_back(test::randomKey(random, false));
    flight.closed = round % 2 == 1;
    ViewportInput input = inputOf(flight);
    input.view = randomEditorView(random);
    ViewportScene kept;
    for (int step = 0; step < 40; ++step) {
      // One key, or so many that none is looked up alone; now and then the view or what is shown.
      for (int i = test::chance(random, 0.1) ? 100 : test::integer(random, 0, 3); i > 0; --i) {
        const auto k = static_cast<std::size_t>(test::integer(random, 0, 149));
        Key key = flight.keys[k];
        key.position = 1.5 * random.inCube();
        flight.keys.set(k, std::move(key));
      }
      if (test::chance(random, 0.1)) input.view = randomEditorView(random);
      if (test::chance(random, 0.1)) input.shown.keys = !input.shown.keys;
      if (test::chance(random, 0.1)) flight.closed = !flight.closed;
      input.evaluation = input.evaluation.updated(flight);
      ViewportScene scratch;
      expectSame(kept.build(input), scratch.build(input));
    }
  }
}

TEST(ViewportScene, TangentsAtTheCurrentKey) {
  Flight flight = sixKeys();
  Key key = flight.keys[2];
  key.shape = {KeyShape::kOwn, {0.2, 0.4, -0.3}, nullptr};
  flight.keys.set(2, key);
  ViewportInput input = inputOf(flight);
  input.state.current = {2, 0};
  const std::size_t without = ViewportScene().build(input).items.size();
  input.shown.tangents = true;
  ViewportScene scene;
  const DrawList& list = scene.build(input);
  ASSERT_EQ(list.items.size(), without + 3);
  const auto tips = [&](const DrawList& drawn) {
    std::vector<Vec3> points;
    for (const DrawItem& item : drawn.items) {
      const auto* marker = std::get_if<MarkerStyle>(&item.style);
      if (marker == nullptr || marker->shape != MarkerShape::kSquare || marker->radius != 3.0f) {
        continue;
      }
      for (const GeometryPoint& p : item.geometry->points) points.emplace_back(p.x, p.y, p.z);
    }
    return points;
  };
  const Vec3 before = key.position - flight.keys[1].position;
  const Vec3 after = flight.keys[3].position - key.position;
  const Vec3 incoming = 0.4 * (0.6 * 0.7 * before + 1.4 * 1.3 * after);
  const Vec3 outgoing = 0.4 * (1.4 * 0.7 * before + 0.6 * 1.3 * after);
  const std::vector<Vec3> found = tips(list);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_LT(glm::distance(found[0], key.position - incoming / 3.0), 1e-6);
  EXPECT_LT(glm::distance(found[1], key.position + outgoing / 3.0), 1e-6);
  // An open flight's ends have one, full tension none.
  input.state.current = {0, 0};
  EXPECT_EQ(tips(scene.build(input)).size(), 1u);
  input.state.current = {5, 0};
  EXPECT_EQ(tips(scene.build(input)).size(), 1u);
  key.shape.own = {1, 0, 0};
  flight.keys.set(2, key);
  input.evaluation = Evaluation(flight);
  input.state.current = {2, 0};
  EXPECT_EQ(tips(scene.build(input)).size(), 0u);
}

// Dim, with their numbers, and each can be taken hold of; those that look at one place share a
// label, and where all look at the current aim it stands beside that.
TEST(ViewportScene, TheCurrentKeysOtherOrientationsAreDrawn) {
  Flight flight = sixKeys();
  Key key = flight.keys[2];
  for (const Vec3& aim : {Vec3(0.3, -0.4, 0.2), Vec3(0.3, -0.4, 0.2), Vec3(0, 0.5, 0)}) {
    Orientation orientation = key.orientations.front();
    orientation.aim = aim;
    key.orientations.push_back(orientation);
  }
  flight.keys.set(2, key);
  ViewportInput input = inputOf(flight);
  input.state.current = {2, 0};
  input.shown.numbers = input.shown.axes = false;
  ViewportScene scene;
  const auto numbers = [&] {
    std::multiset<std::string> texts;
    for (const DrawText& text : scene.build(input).texts) texts.insert(text.text);
    return texts;
  };
  EXPECT_EQ(numbers(), (std::multiset<std::string>{"VUP", "aim", "2, 3", "4"}));
  const auto aims = handlesOf(scene.build(input), HandleKind::kAim);
  ASSERT_EQ(aims.size(), 4u);
  EXPECT_EQ(aims[0].id.orientation, 0u);
  const DrawList& list = scene.build(input);
  // At one place the current one is taken.
  EXPECT_EQ(handleAt(list, aims[0].pixel, 2, 1.0)->orientation, 0u);
  EXPECT_EQ(handleAt(list, *list.view.project({0.3, -0.4, 0.2}), 2, 1.0)->orientation, 1u);
  input.state.current = {2, 2};
  EXPECT_EQ(numbers(), (std::multiset<std::string>{"VUP", "aim", "1, 4", "2"}));
  input.shown.aim = false;
  EXPECT_EQ(numbers(), (std::multiset<std::string>{"VUP"}));
  input.shown.aim = true;
  input.state.current = {1, 0};  // a key with one orientation
  EXPECT_EQ(numbers(), (std::multiset<std::string>{"VUP", "aim"}));
}

}  // namespace
}  // namespace vides
