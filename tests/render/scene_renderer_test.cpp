// SPDX-License-Identifier: MIT
// Lines, markers and surfaces to the pixel: coverage, joins, dashes, depth, clipping, uploads.
#include "render/scene_renderer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/scene_painter.hpp"

namespace vides {
namespace {

using test::ScenePainter;

constexpr Colour kWhite{255, 255, 255, 255}, kBlack{0, 0, 0, 255};
constexpr Colour kRed{255, 0, 0, 255}, kGreen{0, 255, 0, 255};

// A list on black, 100 x 80 pixels unless told; the cube seen from the front, 20 pixels a unit.
DrawList blackList(const PixelRectangle& r = {0, 0, 100, 80}) {
  DrawList list;
  EditorView view;
  view.turn = view.tilt = 0;
  view.size = 20.0 * 2.0 * kCubeRadius / std::min(r.width, r.height);
  list.view = viewProjection(view, r);
  list.groundTop = list.groundBottom = kBlack;
  return list;
}

SharedGeometry geometry(Primitive primitive, std::vector<GeometryPoint> points) {
  return std::make_shared<const Geometry>(Geometry{primitive, std::move(points)});
}

SharedGeometry polyline(const std::vector<Vec2>& pixels) {
  PolylineBuilder builder;
  for (const Vec2& p : pixels) builder.add(geometryPoint(p));
  builder.end();
  return builder.finish();
}

DrawItem pixelItem(SharedGeometry shape, std::variant<LineStyle, MarkerStyle, FillStyle> style) {
  DrawItem item;
  item.geometry = std::move(shape);
  item.style = style;
  item.space = DrawSpace::kPixels;
  item.depth = DrawDepth::kOnTop;
  return item;
}

// The sum of the red channel, in whole pixels: the area that white covers.
double area(const Picture& picture) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) sum += picture.rgba[i] / 255.0;
  return sum;
}

class SceneRendererTest : public testing::Test {
 protected:
  Picture paint(DrawItem item) {
    DrawList list = blackList();
    list.items.push_back(std::move(item));
    return painter_.paint(list);
  }
  ScenePainter painter_{{100, 80}};
};

TEST_F(SceneRendererTest, ALineCoversItsArea) {
  for (const float width : {0.5f, 1.0f, 1.2f, 2.2f, 3.0f, 7.5f}) {
    for (int degrees = 0; degrees < 180; degrees += 15) {
      const double angle = degrees * std::numbers::pi / 180;
      const Vec2 half = 25.0 * Vec2{std::cos(angle), std::sin(angle)};
      const Vec2 middle{50.3, 40.6};
      const Picture picture =
          paint(pixelItem(geometry(Primitive::kSegments,
                                   {geometryPoint(middle - half), geometryPoint(middle + half)}),
                          LineStyle{kWhite, width}));
      // With round ends of half a disc each.
      const double ends = std::numbers::pi * width * width / 4;
      EXPECT_NEAR(area(picture), 50.0 * width + ends, 0.005 * 50.0 * width + 0.5)
          << width << " at " << degrees;
    }
  }
}

TEST_F(SceneRendererTest, ALineAlongThePixelsIsCrisp) {
  const Picture picture =
      paint(pixelItem(geometry(Primitive::kSegments,
                               {geometryPoint(Vec2{10, 20.5}), geometryPoint(Vec2{90, 20.5})}),
                      LineStyle{kWhite, 1.0f}));
  EXPECT_EQ(picture.pixel(50, 20)[0], 255);
  EXPECT_EQ(picture.pixel(50, 19)[0], 0);
  EXPECT_EQ(picture.pixel(50, 21)[0], 0);
}

TEST_F(SceneRendererTest, JoinsCoverNoPixelTwice) {
  // Half transparent: where two segments overlapped it would be brighter than 128.
  for (const float width : {1.2f, 2.2f, 6.0f}) {
    std::vector<Vec2> circle;
    for (int i = 0; i <= 90; ++i) {
      const double angle = i * 4.0 * std::numbers::pi / 180;
      circle.push_back(Vec2{50, 40} + 30.0 * Vec2{std::cos(angle), std::sin(angle)});
    }
    const Picture picture =
        paint(pixelItem(polyline(circle), LineStyle{Colour{255, 255, 255, 128}, width}));
    int brightest = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
      // The two ends meet on the right.
      const auto x = static_cast<int>(i / 4 % 100);
      if (x < 76) brightest = std::max<int>(brightest, picture.rgba[i]);
    }
    EXPECT_LE(brightest, 129) << width;
    // Where the ends meet, half a disc of either lies on the other.
    EXPECT_NEAR(area(picture), 0.5 * 2 * std::numbers::pi * 30 * width, 2.0 + 0.3 * width * width)
        << width;
  }
}

TEST_F(SceneRendererTest, JoinsAreRoundAndWithoutGaps) {
  for (const double turn : {20.0, 60.0, 90.0, 130.0, 170.0}) {
    const double angle = (180 - turn) * std::numbers::pi / 180;
    const Vec2 corner{50, 40};
    const Picture picture =
        paint(pixelItem(polyline({corner - Vec2{30, 0}, corner,
                                  corner + 30.0 * Vec2{-std::cos(angle), std::sin(angle)}}),
                        LineStyle{kWhite, 9.0f}));
    // A disc around the corner is covered whole.
    for (int y = 36; y <= 43; ++y) {
      for (int x = 46; x <= 53; ++x) {
        if (std::hypot(x + 0.5 - 50, y + 0.5 - 40) < 3.9) {
          EXPECT_GE(picture.pixel(x, y)[0], 254) << turn << " at " << x << ", " << y;
        }
      }
    }
  }
}

TEST_F(SceneRendererTest, DashesRunThroughAPolyline) {
  // The same line as one piece and as many: the same pixels. 6 on, 4 off.
  const auto dashed = [&](int parts) {
    PolylineBuilder builder;
    for (int i = 0; i <= parts; ++i) {
      const double along = 80.0 * i / parts;
      builder.add(geometryPoint(Vec2{10 + along, 30.5}, static_cast<float>(along)));
    }
    builder.end();
    return paint(pixelItem(builder.finish(), LineStyle{kWhite, 1.0f, 6.0f, 4.0f}));
  };
  const Picture whole = dashed(1), divided = dashed(16);
  for (int x = 12; x < 88; ++x) {
    EXPECT_NEAR(whole.pixel(x, 30)[0], divided.pixel(x, 30)[0], 1) << x;
  }
  for (const int x : {12, 15, 22, 25, 62}) EXPECT_EQ(whole.pixel(x, 30)[0], 255) << x;
  for (const int x : {17, 18, 27, 28, 67}) EXPECT_EQ(whole.pixel(x, 30)[0], 0) << x;
  EXPECT_NEAR(area(whole), 80 * 0.6, 1.5);
}

TEST_F(SceneRendererTest, MarkersStandOnTheirPlaces) {
  for (const MarkerShape shape : {MarkerShape::kDisc, MarkerShape::kRing, MarkerShape::kCross,
                                  MarkerShape::kSquare, MarkerShape::kPlus}) {
    DrawList list = blackList();
    const Vec3 place{0.713, -0.441, 0.2};
    MarkerStyle style{shape, kWhite, kNoColour, 7.0f, 2.0f, Vec2{3, -5}};
    DrawItem item;
    item.geometry = geometry(Primitive::kMarkers, {geometryPoint(place)});
    item.style = style;
    list.items.push_back(item);
    const Picture picture = painter_.paint(list);
    Vec2 sum{0.0};
    for (int y = 0; y < 80; ++y) {
      for (int x = 0; x < 100; ++x) {
        sum += Vec2{x + 0.5, y + 0.5} * (picture.pixel(x, y)[0] / 255.0);
      }
    }
    const Vec2 expected = *list.view.project(place) + Vec2{3, -5};
    EXPECT_LT(glm::distance(sum / area(picture), expected), 0.05) << static_cast<int>(shape);
    EXPECT_GT(area(picture), 20);
  }
}

TEST_F(SceneRendererTest, LinesProjectAsTheViewSays) {
  EditorView view;
  view.type = ProjectionType::Perspective;
  DrawList list = blackList();
  list.view = viewProjection(view, {0, 0, 100, 80});
  const Vec3 a{-0.7, 0.3, 0.9}, b{0.8, -0.5, -0.6};
  DrawItem item;
  item.geometry = geometry(Primitive::kSegments, {geometryPoint(a), geometryPoint(b)});
  item.style = LineStyle{kWhite, 2.0f};
  list.items.push_back(item);
  const Picture picture = painter_.paint(list);
  for (int i = 0; i <= 20; ++i) {
    const Vec2 p = *list.view.project(a + (b - a) * (i / 20.0));
    EXPECT_GT(picture.pixel(static_cast<int>(p.x), static_cast<int>(p.y))[0], 150) << i;
  }
  const double length = glm::distance(*list.view.project(a), *list.view.project(b));
  EXPECT_NEAR(area(picture), 2.0 * length + std::numbers::pi, 0.03 * 2 * length + 1);
}

TEST_F(SceneRendererTest, LinesThroughTheViewersPlaneAreCutThere) {
  // From before the camera to behind it: seen up to the picture's edge, and nothing mirrored.
  DrawList list = blackList();
  list.view =
      viewProjection({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, std::numbers::pi / 2, {0, 0, 100, 80});
  const auto lineTo = [&](const Vec3& behind) {
    list.items.clear();
    DrawItem item;
    item.geometry =
        geometry(Primitive::kSegments, {geometryPoint(Vec3{0, 0, -2}), geometryPoint(behind)});
    item.style = LineStyle{kWhite, 2.0f};
    list.items.push_back(item);
    return painter_.paint(list);
  };
  const Picture right = lineTo({1, 0, 2});  // leaves at the right edge
  for (int x = 52; x < 99; ++x) EXPECT_EQ(right.pixel(x, 40)[0], 255) << x;
  for (int x = 0; x < 47; ++x) EXPECT_EQ(right.pixel(x, 40)[0], 0) << x;
  const Picture up = lineTo({0, 1e5, 1e5});
  for (int y = 0; y < 38; ++y) EXPECT_EQ(up.pixel(50, y)[0], 255) << y;
  for (int y = 43; y < 80; ++y) EXPECT_EQ(up.pixel(50, y)[0], 0) << y;
  // Through the camera itself: a point in the middle.
  EXPECT_LT(area(lineTo({0, 0, 2})), 5.0);
}

// Two lines that cross, the red one in front, in both orders of drawing.
TEST_F(SceneRendererTest, TheNearerLineHidesTheFartherWithoutDarkSeams) {
  const auto cross = [&](bool frontFirst, float width) {
    DrawList list = blackList();
    DrawItem front, back;
    front.geometry = geometry(Primitive::kSegments, {geometryPoint(Vec3{-1.2, 0.31, 0.5}),
                                                     geometryPoint(Vec3{1.2, -0.4, 0.5})});
    front.style = LineStyle{kRed, width};
    back.geometry = geometry(Primitive::kSegments, {geometryPoint(Vec3{0.1, -1.2, -0.5}),
                                                    geometryPoint(Vec3{-0.2, 1.2, -0.5})});
    back.style = LineStyle{kGreen, 9.0f};
    list.items = frontFirst ? std::vector{front, back} : std::vector{back, front};
    return painter_.paint(list);
  };
  for (const float width : {1.2f, 2.2f, 5.0f}) {
    const Picture picture = cross(true, width);
    // Only where both cover a pixel faintly does their order show.
    const PictureDifference order = comparePictures(picture, cross(false, width), {0.1, 0.0});
    EXPECT_LE(order.pixels, 2u) << width << ": " << order.sentence;
    const auto middle = picture.pixel(50, 40);
    EXPECT_GT(middle[0], width < 2 ? 100 : 250);
    // Over the thick green line red and green add up to one everywhere: no black shines through.
    for (int y = 36; y < 44; ++y) {
      const auto pixel = picture.pixel(50, y);
      EXPECT_NEAR(pixel[0] + pixel[1], 255, 3) << width << " at " << y;
    }
  }
}

TEST_F(SceneRendererTest, SurfacesHideLinesBehindThem) {
  for (const double depth : {-0.5, 0.5}) {
    DrawList list = blackList();
    DrawItem surface, line;
    surface.geometry = geometry(Primitive::kTriangles,
                                {geometryPoint(Vec3{-1, -1, 0}), geometryPoint(Vec3{1, -1, 0}),
                                 geometryPoint(Vec3{0, 1, 0})});
    surface.style = FillStyle{kRed};
    line.geometry = geometry(Primitive::kSegments, {geometryPoint(Vec3{-2, -0.5, depth}),
                                                    geometryPoint(Vec3{2, -0.5, depth})});
    line.style = LineStyle{kGreen, 3.0f};
    list.items = {surface, line};
    const Picture picture = painter_.paint(list);
    EXPECT_EQ(picture.pixel(50, 50)[1], depth > 0 ? 255 : 0);
    EXPECT_EQ(picture.pixel(50, 50)[0], depth > 0 ? 0 : 255);
    EXPECT_EQ(picture.pixel(20, 50)[1], 255);  // beside the triangle
  }
}

TEST_F(SceneRendererTest, FadesIntoTheGround) {
  DrawList list = blackList();
  const auto brightness = [&](double z) {
    DrawItem item;
    item.geometry = geometry(Primitive::kSegments,
                             {geometryPoint(Vec3{-1, 0, z}), geometryPoint(Vec3{1, 0, z})});
    item.style = LineStyle{kWhite, 5.0f};
    item.fade = 0.5f;
    list.items = {item};
    return static_cast<int>(painter_.paint(list).pixel(50, 40)[0]);
  };
  EXPECT_EQ(brightness(kCubeRadius), 255);
  EXPECT_NEAR(brightness(0), 255 * 0.75, 1);
  EXPECT_NEAR(brightness(-kCubeRadius), 255 * 0.5, 1);
  EXPECT_NEAR(brightness(-50), 255 * 0.5, 1);
}

TEST_F(SceneRendererTest, NothingOutsideTheRectangleChanges) {
  DrawList whole = blackList();
  whole.groundTop = whole.groundBottom = kGreen;
  DrawList part = blackList({20, 10, 50, 40});
  part.groundTop = kRed;
  part.items.push_back(pixelItem(
      geometry(Primitive::kSegments, {geometryPoint(Vec2{0, 0}), geometryPoint(Vec2{100, 80})}),
      LineStyle{kWhite, 20.0f}));
  const Picture picture = painter_.paint(whole, part);
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 100; ++x) {
      const bool inside = x >= 20 && x < 70 && y >= 10 && y < 50;
      const bool green = picture.pixel(x, y)[1] == 255 && picture.pixel(x, y)[0] == 0;
      EXPECT_EQ(green, !inside) << x << ", " << y;
    }
  }
  // The ground fades from red above to black below.
  EXPECT_GT(picture.pixel(68, 10)[0], 245);
  EXPECT_LT(picture.pixel(22, 49)[0], 10);
}

// As for a picture in a column that is scrolled.
TEST_F(SceneRendererTest, NothingOutsideTheClipChanges) {
  DrawList whole = blackList();
  whole.groundTop = whole.groundBottom = kGreen;
  DrawList part = blackList({20, 10, 50, 40});
  part.groundTop = part.groundBottom = kRed;
  part.outer = PixelRectangle{15, 5, 60, 50};
  part.bars = kWhite;
  part.items.push_back(pixelItem(
      geometry(Primitive::kSegments, {geometryPoint(Vec2{0, 0}), geometryPoint(Vec2{100, 80})}),
      LineStyle{kWhite, 20.0f}));
  const Picture all = painter_.paint(whole, part);
  const Picture some = painter_.paint(whole, part, PixelRectangle{10, 30, 40, 100});
  const Picture none = painter_.paint(whole, part, PixelRectangle{80, 70, 10, 10});
  const Picture before = painter_.paint(whole);
  EXPECT_EQ(none, before);
  EXPECT_NE(all.pixel(16, 29)[0], before.pixel(16, 29)[0]);
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 100; ++x) {
      const Picture& expected = x >= 10 && x < 50 && y >= 30 ? all : before;
      for (int c = 0; c < 4; ++c) {
        ASSERT_EQ(some.pixel(x, y)[c], expected.pixel(x, y)[c]) << x << ", " << y;
      }
    }
  }
}

// Buffers of any size, each beside those of other sizes: an element more or less draws the same.
TEST_F(SceneRendererTest, BuffersOfEverySizeDrawTheSame) {
  DrawList list = blackList();
  const auto picture = [&](std::size_t points) {
    std::vector<GeometryPoint> places(points, geometryPoint(Vec3{50, 50, 50}));
    places.front() = geometryPoint(Vec3{0.1, 0.2, 0});
    DrawItem item;
    item.geometry = geometry(Primitive::kMarkers, std::move(places));
    item.style = MarkerStyle{MarkerShape::kDisc, kWhite};
    list.items = {item};
    return painter_.paint(list);
  };
  const Picture one = picture(1);
  EXPECT_NE(one, painter_.paint(blackList()));
  for (const std::size_t points : {31u, 32u, 33u, 63u, 64u, 95u, 96u, 97u, 4095u, 4096u, 65536u}) {
    EXPECT_EQ(picture(points), one) << points;
  }
}

TEST_F(SceneRendererTest, UploadsOnlyWhatIsNew) {
  DrawList list = blackList();
  DrawItem item;
  item.geometry =
      geometry(Primitive::kSegments, {geometryPoint(Vec3{-1, 0, 0}), geometryPoint(Vec3{1, 0, 0})});
  item.style = LineStyle{kWhite, 2.0f};
  list.items = {item, item};
  painter_.paint(list);
  EXPECT_EQ(painter_.statistics().uploads, 1u);
  EXPECT_EQ(painter_.statistics().uploadedBytes, 2 * sizeof(GeometryPoint));
  const Picture before = painter_.paint(list);
  EXPECT_EQ(painter_.statistics().uploads, 0u);
  list.view = blackList({0, 0, 80, 80}).view;
  painter_.paint(list);
  EXPECT_EQ(painter_.statistics().uploads, 0u);
  // New geometry that may stand where the old one was.
  for (int i = 0; i < 50; ++i) {
    list.items.clear();
    item.geometry.reset();
    item.geometry = geometry(Primitive::kSegments,
                             {geometryPoint(Vec3{-1, 0, 0}), geometryPoint(Vec3{1, 0.01 * i, 0})});
    list.items = {item};
    painter_.paint(list);
    ASSERT_EQ(painter_.statistics().uploads, 1u);
  }
}

TEST(SceneRenderer, TurningTheViewUploadsNextToNothing) {
  const test::Sample sample = test::sample("pyramid");
  ViewportInput input = test::viewportInput(sample);
  ScenePainter painter({800, 600});
  ViewportScene scene;
  painter.paint(scene.build(input));
  EXPECT_GT(painter.statistics().uploadedBytes, 8000u);
  for (int i = 0; i < 5; ++i) {
    input.view.turn += 1.5;
    painter.paint(scene.build(input));
    // The triad, the plane squares and the dashes of the VUP's circle.
    EXPECT_LT(painter.statistics().uploadedBytes, 3000u);
  }
  painter.paint(scene.build(input));
  EXPECT_EQ(painter.statistics().uploadedBytes, 0u);
}

TEST(SceneRenderer, AnySizeOfWindow) {
  const test::Sample sample = test::sample("pyramid");
  for (const PixelSize size : {PixelSize{1, 1}, PixelSize{16000, 100}, PixelSize{3, 500}}) {
    ScenePainter painter(size);
    ViewportInput input = test::viewportInput(sample);
    input.rectangle = {0, 0, static_cast<double>(size.width), static_cast<double>(size.height)};
    for (const auto type : {ProjectionType::Parallel, ProjectionType::Perspective}) {
      input.view.type = type;
      input.view.size = type == ProjectionType::Parallel ? 1.0 : 20.0;
      ViewportScene scene;
      const Picture picture = painter.paint(scene.build(input));
      EXPECT_EQ(picture.width, size.width);
      EXPECT_EQ(picture.pixel(0, 0)[3], 255);
    }
  }
}

}  // namespace
}  // namespace vides
