// SPDX-License-Identifier: MIT
// Draws a list: ground, what is tested against depth in layers, then what lies on top.
#include "render/scene_renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

#include "math/whole.hpp"
#include "render/gl_objects.hpp"
#include "render/scene_buffers.hpp"
#include "shaders.hpp"

namespace vides {
namespace {

// A coverage that is too little to see, and the least that hides what lies behind.
constexpr float kSeen = 0.004f;
constexpr float kHides = 0.5f;
// With more than this, what is hidden is left out instead of shining through the edges of what
// hides it.
constexpr std::size_t kMostLayered = 3000;
// Of those that OpenGL 3.3 promises; the interface around the picture uses some.
constexpr GLenum kMostClipPlanes = 8;
// The depth between two lifts, in clip units: some steps of a 24-bit depth buffer.
constexpr float kLiftStep = 4.0e-6f;

// Depth alone, of what covers half a pixel; then colours: behind that, at it, and what little there
// is before it. The order in which things are drawn does not show.
enum class Pass { kHiding, kHidden, kVisible, kBefore, kOnTop };

glm::vec4 toVector(const Colour& c) { return glm::vec4(c.red, c.green, c.blue, c.alpha) / 255.0f; }

struct PixelBox {
  GLint x, y;  // lower left corner, y up
  GLsizei width, height;
};

// For coordinates of the geometry's own, from what is meant for the cube's.
glm::mat4 placed(glm::dmat4 matrix, const Placement& place) {
  glm::dmat4 own(place.turn);
  for (int i = 0; i < 3; ++i) own[i] *= place.unit;
  own[3] = glm::dvec4(place.origin, 1.0);
  return glm::mat4(matrix * own);
}
glm::vec4 placed(const glm::dvec4& plane, const Placement& place) {
  return glm::vec4(glm::dvec4(place.unit * (Vec3(plane) * place.turn),
                              glm::dot(plane, glm::dvec4(place.origin, 1.0))));
}

// The pixels whose middles lie in the rectangle.
PixelBox pixelBox(const PixelRectangle& r, int width, int height) {
  const auto clamped = [](double value, int most) {
    return static_cast<GLint>(wholeWithin(std::round(value), 0, most));
  };
  const GLint left = clamped(r.x, width), right = clamped(r.x + r.width, width);
  const GLint top = clamped(r.y, height), bottom = clamped(r.y + r.height, height);
  return {left, height - bottom, right - left, bottom - top};
}

PixelBox common(const PixelBox& a, const PixelBox& b) {
  const GLint x = std::max(a.x, b.x), y = std::max(a.y, b.y);
  return {x, y, std::max(0, std::min(a.x + a.width, b.x + b.width) - x),
          std::max(0, std::min(a.y + a.height, b.y + b.height) - y)};
}

// What all shaders are told once a list, and what they are told for each item.
struct Uniforms {
  GLint toClip, rectangle, target, depthPlane, nearest, ground;
  GLint colour, fade, lift, first, least;
};

}  // namespace

struct SceneRenderer::Parts {
  explicit Parts(const Gl& table) : gl(table), buffers(table), vertexArray(table) {}

  tl::expected<void, std::string> build();
  void drawGround(const DrawList& list, const PixelBox& box, const PixelBox& outer);
  void fillBox(const PixelBox& box, const Colour& colour);
  void drawPass(const DrawList& list, Pass pass, bool layered);
  void drawItem(const DrawItem& item, Pass pass);
  void drawLines(const DrawItem& item, const LineStyle& style);
  void drawMarkers(const DrawItem& item, const MarkerStyle& style);
  void drawFill(const DrawItem& item, const FillStyle& style);
  void use(const ShaderProgram& program, const Uniforms& uniforms, const DrawItem& item);
  void setUp(const DrawList& list, int width, int height);

  const Gl& gl;
  SceneBuffers buffers;
  VertexArray vertexArray;  // without attributes: the shaders fetch the points
  // One triangle over all of the framebuffer, in clip space.
  SharedGeometry all = std::make_shared<const Geometry>(
      Geometry{Primitive::kTriangles, {{-1, -1, 1}, {3, -1, 1}, {-1, 3, 1}}});
  ShaderProgram line, marker, fill;
  Uniforms lineUniforms{}, markerUniforms{}, fillUniforms{};
  GLint lineHalfWidth = -1, lineDash = -1, lineJoined = -1;
  GLint markerOffset = -1, markerReach = -1, markerShape = -1, markerRadius = -1;
  GLint markerHalfWidth = -1, markerFill = -1;

  // Of the list that is being drawn.
  glm::dmat4 cubeToClip{1.0};
  glm::mat4 pixelsToClip{1.0f};
  glm::dvec4 depthPlane{0.0};
  glm::vec4 rectangle{0.0f};
  glm::vec2 target{1.0f};
  glm::vec3 groundColour{0.0f};
  float nearest = 0.0f;
  float least = kSeen;
  // What the program in use has been told last.
  GLuint programInUse = 0;
  DrawSpace spaceInUse = DrawSpace::kCube;
  Placement placeInUse;
  Statistics statistics;
};

namespace {

tl::expected<ShaderProgram, std::string> buildScene(const Gl& gl, std::string_view name,
                                                    std::string_view vertex,
                                                    std::string_view fragment) {
  return ShaderProgram::build(gl, name, vertex, fragment);
}

Uniforms find(const ShaderProgram& p, bool isFill) {
  return {p.uniform("toClip"),
          p.uniform("rectangle"),
          p.uniform("target"),
          p.uniform("depthPlane"),
          isFill ? -1 : p.uniform("nearest"),
          p.uniform("ground"),
          p.uniform("colour"),
          p.uniform("fade"),
          p.uniform("lift"),
          p.uniform("first"),
          isFill ? -1 : p.uniform("least")};
}

GLenum depthFunction(Pass pass, bool layered) {
  switch (pass) {
    case Pass::kHidden:
      return GL_GREATER;
    case Pass::kVisible:
      return layered ? GL_EQUAL : GL_LEQUAL;
    default:
      return GL_LESS;
  }
}

bool isSurface(const DrawItem& item) {
  return item.geometry && item.geometry->primitive == Primitive::kTriangles;
}

bool hasSurfaces(const DrawList& list) {
  return std::any_of(list.items.begin(), list.items.end(), [](const DrawItem& item) {
    return isSurface(item) && item.depth == DrawDepth::kTested;
  });
}

bool inPass(const DrawItem& item, Pass pass) {
  return (item.depth == DrawDepth::kOnTop) == (pass == Pass::kOnTop);
}

}  // namespace

tl::expected<void, std::string> SceneRenderer::Parts::build() {
  const auto take = [&](ShaderProgram& into, const char* name, std::string_view vertex,
                        std::string_view fragment) -> tl::expected<void, std::string> {
    return buildScene(gl, name, vertex, fragment).map([&](ShaderProgram built) {
      into = std::move(built);
    });
  };
  auto built =
      take(line, "line", shaders::kLineVert, shaders::kLineFrag)
          .and_then(
              [&] { return take(marker, "marker", shaders::kMarkerVert, shaders::kMarkerFrag); })
          .and_then([&] { return take(fill, "fill", shaders::kFillVert, shaders::kFillFrag); });
  if (!built) return built;
  lineUniforms = find(line, false);
  markerUniforms = find(marker, false);
  fillUniforms = find(fill, true);
  lineHalfWidth = line.uniform("halfWidth");
  lineDash = line.uniform("dash");
  lineJoined = line.uniform("joined");
  markerOffset = marker.uniform("offset");
  markerReach = marker.uniform("reach");
  markerShape = marker.uniform("shape");
  markerRadius = marker.uniform("radius");
  markerHalfWidth = marker.uniform("halfWidth");
  markerFill = marker.uniform("fill");
  return {};
}

void SceneRenderer::Parts::setUp(const DrawList& list, int width, int height) {
  const ViewProjection& view = list.view;
  const PixelRectangle& r = view.pixels();
  cubeToClip = view.matrix();
  glm::dmat4 pixels(1.0);
  pixels[0][0] = 2.0 / r.width;
  pixels[1][1] = -2.0 / r.height;
  pixels[2][2] = 0.0;
  pixels[3] = {-2.0 * r.x / r.width - 1.0, 1.0 + 2.0 * r.y / r.height, 0.0, 1.0};
  pixelsToClip = glm::mat4(pixels);
  rectangle = {r.x, r.y, r.width, r.height};
  target = {width, height};
  const ViewMapping& mapping = view.mapping();
  nearest =
      view.perspective()
          ? static_cast<float>(mapping.projectionReferencePoint.z - mapping.frontPlaneDistance)
          : 0.0f;
  const Vec3 along = view.viewingDirection() / (2.0 * list.depthRadius);
  depthPlane = glm::dvec4(along, 0.5 - glm::dot(along, list.depthTarget));
  groundColour = glm::vec3(toVector(mix(list.groundTop, list.groundBottom, 0.5)));
  programInUse = 0;
}

void SceneRenderer::Parts::fillBox(const PixelBox& box, const Colour& colour) {
  gl.Scissor(box.x, box.y, box.width, box.height);
  gl.Uniform4fv(fillUniforms.colour, 1, glm::value_ptr(toVector(colour)));
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

// The bars, then the ground: for each band of rows of one colour the scissor's part of a triangle
// over everything. Bands differ by one step of the channel that changes most: as smooth as a
// gradient. This resets depth and stencil, too. (Software drivers clear parts of a framebuffer in
// the same way, but with shaders that are made for it first.)
void SceneRenderer::Parts::drawGround(const DrawList& list, const PixelBox& box,
                                      const PixelBox& outer) {
  const glm::vec4 whole(0.0f, 0.0f, target);
  const glm::mat4 asItIs(1.0f);
  fill.use();
  programInUse = 0;
  gl.Uniform4fv(fillUniforms.rectangle, 1, glm::value_ptr(whole));
  gl.Uniform2fv(fillUniforms.target, 1, glm::value_ptr(target));
  gl.UniformMatrix4fv(fillUniforms.toClip, 1, GL_FALSE, glm::value_ptr(asItIs));
  gl.Uniform1i(fillUniforms.first, 0);
  gl.Uniform1f(fillUniforms.fade, 0.0f);
  gl.Uniform1f(fillUniforms.lift, 0.0f);
  buffers.bind(all);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_ALWAYS);
  gl.DepthMask(GL_TRUE);
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilMask(0xff);
  gl.StencilFunc(GL_ALWAYS, 0, 0xff);
  gl.StencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
  if (list.outer) fillBox(outer, list.bars);
  const PixelRectangle& r = list.view.pixels();
  const Colour &top = list.groundTop, &bottom = list.groundBottom;
  const int steps = std::max({std::abs(top.red - bottom.red), std::abs(top.green - bottom.green),
                              std::abs(top.blue - bottom.blue)});
  const auto colourOf = [&](GLint row) {
    const double share = (static_cast<double>(target.y) - row - 0.5 - r.y) / r.height;
    return steps == 0 ? top : mix(top, bottom, std::round(share * steps) / steps);
  };
  for (GLint row = box.y; row < box.y + box.height;) {
    const Colour band = colourOf(row);
    GLint end = row + 1;
    while (end < box.y + box.height && colourOf(end) == band) ++end;
    fillBox({box.x, row, box.width, end - row}, band);
    row = end;
  }
  gl.Scissor(box.x, box.y, box.width, box.height);
}

void SceneRenderer::Parts::use(const ShaderProgram& program, const Uniforms& u,
                               const DrawItem& item) {
  const bool changes = programInUse != program.id();
  if (changes) {
    program.use();
    programInUse = program.id();
    gl.Uniform4fv(u.rectangle, 1, glm::value_ptr(rectangle));
    gl.Uniform2fv(u.target, 1, glm::value_ptr(target));
    gl.Uniform3fv(u.ground, 1, glm::value_ptr(groundColour));
    if (u.least >= 0) gl.Uniform1f(u.least, least);
  }
  const bool inPixels = item.space == DrawSpace::kPixels;
  if (changes || spaceInUse != item.space || !(placeInUse == item.place)) {
    spaceInUse = item.space;
    placeInUse = item.place;
    const glm::vec4 plane = inPixels ? glm::vec4(0.0f) : placed(depthPlane, item.place);
    gl.UniformMatrix4fv(u.toClip, 1, GL_FALSE,
                        glm::value_ptr(inPixels ? pixelsToClip : placed(cubeToClip, item.place)));
    gl.Uniform4fv(u.depthPlane, 1, glm::value_ptr(plane));
    if (u.nearest >= 0) gl.Uniform1f(u.nearest, inPixels ? 0.0f : nearest);
  }
  gl.Uniform1i(u.first, static_cast<GLint>(item.first));
  gl.Uniform1f(u.fade, item.fade);
  gl.Uniform1f(u.lift, kLiftStep * static_cast<float>(item.lift));
}

void SceneRenderer::Parts::drawLines(const DrawItem& item, const LineStyle& style) {
  use(line, lineUniforms, item);
  gl.Uniform4fv(lineUniforms.colour, 1, glm::value_ptr(toVector(style.colour)));
  gl.Uniform1f(lineHalfWidth, 0.5f * style.width);
  gl.Uniform2f(lineDash, style.dashOn, style.dashOn + style.dashOff);
  gl.Uniform1i(lineJoined, item.geometry->primitive == Primitive::kPolylines ? 1 : 0);
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * item.count));
}

void SceneRenderer::Parts::drawMarkers(const DrawItem& item, const MarkerStyle& style) {
  use(marker, markerUniforms, item);
  gl.Uniform4fv(markerUniforms.colour, 1, glm::value_ptr(toVector(style.colour)));
  gl.Uniform4fv(markerFill, 1, glm::value_ptr(toVector(style.fill)));
  gl.Uniform2f(markerOffset, static_cast<float>(style.offset.x),
               static_cast<float>(style.offset.y));
  gl.Uniform1i(markerShape, static_cast<GLint>(style.shape));
  gl.Uniform1f(markerRadius, style.radius);
  gl.Uniform1f(markerHalfWidth, 0.5f * style.width);
  gl.Uniform1f(markerReach, style.radius + 0.5f * style.width + 1.0f);
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * item.count));
}

void SceneRenderer::Parts::drawFill(const DrawItem& item, const FillStyle& style) {
  use(fill, fillUniforms, item);
  gl.Uniform4fv(fillUniforms.colour, 1, glm::value_ptr(toVector(style.colour)));
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * item.count));
}

void SceneRenderer::Parts::drawItem(const DrawItem& whole, Pass pass) {
  if (!whole.geometry) return;
  DrawItem item = whole;
  const std::size_t elements = item.geometry->elements();
  item.first = std::min(item.first, elements);
  item.count = std::min(item.count, elements - item.first);
  if (item.count == 0) return;
  // Surfaces are drawn with the first pass, opaque.
  const bool surface = isSurface(item);
  if (surface && pass != Pass::kHiding && pass != Pass::kOnTop) return;

  buffers.bind(item.geometry);
  const GLboolean seen = pass != Pass::kHiding || surface ? GL_TRUE : GL_FALSE;
  gl.ColorMask(seen, seen, seen, seen);
  gl.StencilFunc(GL_ALWAYS, surface ? 1 : 0, 0xff);
  if (pass == Pass::kHidden) gl.StencilFunc(GL_EQUAL, 0, 0xff);
  if (const auto* lineStyle = std::get_if<LineStyle>(&item.style)) {
    drawLines(item, *lineStyle);
  } else if (const auto* markerStyle = std::get_if<MarkerStyle>(&item.style)) {
    drawMarkers(item, *markerStyle);
  } else {
    drawFill(item, std::get<FillStyle>(item.style));
  }
  ++statistics.drawCalls;
  if (pass == Pass::kHiding || pass == Pass::kOnTop) statistics.elements += item.count;
}

void SceneRenderer::Parts::drawPass(const DrawList& list, Pass pass, bool layered) {
  programInUse = 0;  // `least` changes
  least = pass == Pass::kHiding ? kHides : kSeen;
  gl.DepthMask(pass == Pass::kHiding ? GL_TRUE : GL_FALSE);
  gl.DepthFunc(depthFunction(pass, layered));
  if (pass == Pass::kOnTop) gl.Disable(GL_DEPTH_TEST);
  for (const DrawItem& item : list.items) {
    if (inPass(item, pass)) drawItem(item, pass);
  }
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

tl::expected<SceneRenderer, std::string> SceneRenderer::create(const Gl& gl) {
  auto parts = std::make_unique<Parts>(gl);
  return parts->build().map([&] { return SceneRenderer(std::move(parts)); });
}

SceneRenderer::SceneRenderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
SceneRenderer::~SceneRenderer() = default;
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;

const SceneRenderer::Statistics& SceneRenderer::statistics() const { return parts_->statistics; }

void SceneRenderer::draw(const DrawList& list, int width, int height,
                         const std::optional<PixelRectangle>& clip) {
  Parts& p = *parts_;
  const Gl& gl = p.gl;
  p.statistics = {};
  const PixelBox seen = clip ? pixelBox(*clip, width, height) : PixelBox{0, 0, width, height};
  const PixelBox box = common(pixelBox(list.view.pixels(), width, height), seen);
  const PixelBox outer = list.outer ? common(pixelBox(*list.outer, width, height), seen) : box;
  p.setUp(list, width, height);

  gl.Viewport(0, 0, width, height);
  gl.Disable(GL_CULL_FACE);
  for (GLenum i = 0; i < kMostClipPlanes; ++i) gl.Disable(GL_CLIP_DISTANCE0 + i);
  gl.Disable(GL_BLEND);
  gl.Enable(GL_SCISSOR_TEST);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.BindVertexArray(p.vertexArray.id());
  gl.ActiveTexture(GL_TEXTURE0);
  p.drawGround(list, box, outer);
  p.buffers.resetCounts();  // the list's own

  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  // The stencil tells surfaces from lines.
  if (!hasSurfaces(list)) gl.Disable(GL_STENCIL_TEST);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  p.drawPass(list, Pass::kHiding, true);
  const bool layered = p.statistics.elements <= kMostLayered;
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  if (layered) p.drawPass(list, Pass::kHidden, true);
  gl.StencilFunc(GL_ALWAYS, 0, 0xff);
  p.drawPass(list, Pass::kVisible, layered);
  if (layered) p.drawPass(list, Pass::kBefore, true);
  gl.Disable(GL_STENCIL_TEST);
  p.drawPass(list, Pass::kOnTop, layered);

  gl.Disable(GL_DEPTH_TEST);
  gl.Disable(GL_BLEND);
  gl.Disable(GL_SCISSOR_TEST);
  gl.DepthMask(GL_TRUE);
  gl.DepthFunc(GL_LESS);
  gl.UseProgram(0);
  gl.BindVertexArray(0);
  gl.BindTexture(GL_TEXTURE_BUFFER, 0);
  p.statistics.uploads = p.buffers.uploads();
  p.statistics.uploadedBytes = p.buffers.uploadedBytes();
  p.buffers.collect();
}

}  // namespace vides
