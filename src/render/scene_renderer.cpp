// SPDX-License-Identifier: MIT
// Draws a list: ground, what is tested against depth in layers, then what lies on top.
#include "render/scene_renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

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
constexpr std::size_t kMostLayered = 20000;
// The depth between two lifts, in clip units: some steps of a 24-bit depth buffer.
constexpr float kLiftStep = 4.0e-6f;

enum class Pass { kHiding, kHidden, kVisible, kOnTop };

glm::vec4 toVector(const Colour& c) { return glm::vec4(c.red, c.green, c.blue, c.alpha) / 255.0f; }

struct PixelBox {
  GLint x, y;  // lower left corner, y up
  GLsizei width, height;
};

// The pixels whose middles lie in the rectangle.
PixelBox pixelBox(const PixelRectangle& r, int width, int height) {
  const auto clamped = [](double value, int most) {
    return static_cast<GLint>(std::clamp(std::round(value), 0.0, static_cast<double>(most)));
  };
  const GLint left = clamped(r.x, width), right = clamped(r.x + r.width, width);
  const GLint top = clamped(r.y, height), bottom = clamped(r.y + r.height, height);
  return {left, height - bottom, right - left, bottom - top};
}

// What all shaders are told once a list, and what they are told for each item.
struct Uniforms {
  GLint toClip, rectangle, target, depthPlane, nearest, ground;
  GLint colour, fade, lift, least;
};

}  // namespace

struct SceneRenderer::Parts {
  explicit Parts(const Gl& table) : gl(table), buffers(table), vertexArray(table) {}

  tl::expected<void, std::string> build();
  void drawGround(const DrawList& list);
  void drawPass(const DrawList& list, Pass pass);
  void drawItem(const DrawItem& item, Pass pass);
  void drawLines(const DrawItem& item, const LineStyle& style);
  void drawMarkers(const DrawItem& item, const MarkerStyle& style);
  void drawFill(const DrawItem& item, const FillStyle& style);
  void use(const ShaderProgram& program, const Uniforms& uniforms, const DrawItem& item);
  void point(GLuint attribute, std::size_t index, std::size_t stride, GLuint divisor);
  void setUp(const DrawList& list, int width, int height);

  const Gl& gl;
  SceneBuffers buffers;
  VertexArray vertexArray;
  ShaderProgram line, marker, fill, ground;
  Uniforms lineUniforms{}, markerUniforms{}, fillUniforms{};
  GLint lineHalfWidth = -1, lineDash = -1, lineJoined = -1;
  GLint markerOffset = -1, markerReach = -1, markerShape = -1, markerRadius = -1;
  GLint markerHalfWidth = -1, markerFill = -1;
  GLint groundTarget = -1, groundRectangle = -1, groundTop = -1, groundBottom = -1;

  // Of the list that is being drawn.
  glm::mat4 cubeToClip{1.0f}, pixelsToClip{1.0f};
  glm::vec4 rectangle{0.0f}, depthPlane{0.0f};
  glm::vec2 target{1.0f};
  glm::vec3 groundColour{0.0f};
  float nearest = 0.0f;
  float least = kSeen;
  // What the program in use has been told last.
  GLuint programInUse = 0;
  DrawSpace spaceInUse = DrawSpace::kCube;
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
          isFill ? -1 : p.uniform("least")};
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
          .and_then([&] { return take(fill, "fill", shaders::kFillVert, shaders::kFillFrag); })
          .and_then(
              [&] { return take(ground, "ground", shaders::kGroundVert, shaders::kGroundFrag); });
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
  groundTarget = ground.uniform("target");
  groundRectangle = ground.uniform("rectangle");
  groundTop = ground.uniform("top");
  groundBottom = ground.uniform("bottom");
  return {};
}

void SceneRenderer::Parts::setUp(const DrawList& list, int width, int height) {
  const ViewProjection& view = list.view;
  const PixelRectangle& r = view.pixels();
  cubeToClip = glm::mat4(view.matrix());
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
  depthPlane = glm::vec4(glm::dvec4(along, 0.5 - glm::dot(along, list.depthTarget)));
  groundColour = glm::vec3(toVector(mix(list.groundTop, list.groundBottom, 0.5)));
  programInUse = 0;
}

void SceneRenderer::Parts::drawGround(const DrawList& list) {
  if (list.groundTop == list.groundBottom) {
    const glm::vec4 c = toVector(list.groundTop);
    gl.ClearColor(c.r, c.g, c.b, 1.0f);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    return;
  }
  ground.use();
  gl.Uniform2fv(groundTarget, 1, glm::value_ptr(target));
  gl.Uniform4fv(groundRectangle, 1, glm::value_ptr(rectangle));
  gl.Uniform3fv(groundTop, 1, glm::value_ptr(toVector(list.groundTop)));
  gl.Uniform3fv(groundBottom, 1, glm::value_ptr(toVector(list.groundBottom)));
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  ++statistics.drawCalls;
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
  if (changes || spaceInUse != item.space) {
    spaceInUse = item.space;
    const glm::vec4 plane = inPixels ? glm::vec4(0.0f) : depthPlane;
    gl.UniformMatrix4fv(u.toClip, 1, GL_FALSE,
                        glm::value_ptr(inPixels ? pixelsToClip : cubeToClip));
    gl.Uniform4fv(u.depthPlane, 1, glm::value_ptr(plane));
    if (u.nearest >= 0) gl.Uniform1f(u.nearest, inPixels ? 0.0f : nearest);
  }
  gl.Uniform1f(u.fade, item.fade);
  gl.Uniform1f(u.lift, kLiftStep * static_cast<float>(item.lift));
}

void SceneRenderer::Parts::point(GLuint attribute, std::size_t index, std::size_t stride,
                                 GLuint divisor) {
  gl.EnableVertexAttribArray(attribute);
  gl.VertexAttribPointer(attribute, 4, GL_FLOAT, GL_FALSE,
                         static_cast<GLsizei>(stride * sizeof(GeometryPoint)),
                         reinterpret_cast<const void*>(index * sizeof(GeometryPoint)));
  gl.VertexAttribDivisor(attribute, divisor);
}

void SceneRenderer::Parts::drawLines(const DrawItem& item, const LineStyle& style) {
  use(line, lineUniforms, item);
  gl.Uniform4fv(lineUniforms.colour, 1, glm::value_ptr(toVector(style.colour)));
  gl.Uniform1f(lineHalfWidth, 0.5f * style.width);
  gl.Uniform2f(lineDash, style.dashOn, style.dashOn + style.dashOff);
  const bool joined = item.geometry->primitive == Primitive::kPolylines;
  gl.Uniform1i(lineJoined, joined ? 1 : 0);
  if (joined) {
    for (GLuint i = 0; i < 4; ++i) point(i, item.first + i, 1, 1);
  } else {
    point(0, 2 * item.first, 2, 1);
    point(1, 2 * item.first, 2, 1);
    point(2, 2 * item.first + 1, 2, 1);
    point(3, 2 * item.first + 1, 2, 1);
  }
  gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(item.count));
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
  point(0, item.first, 1, 1);
  for (GLuint i = 1; i < 4; ++i) gl.DisableVertexAttribArray(i);
  gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(item.count));
}

void SceneRenderer::Parts::drawFill(const DrawItem& item, const FillStyle& style) {
  use(fill, fillUniforms, item);
  gl.Uniform4fv(fillUniforms.colour, 1, glm::value_ptr(toVector(style.colour)));
  point(0, 3 * item.first, 1, 0);
  for (GLuint i = 1; i < 4; ++i) gl.DisableVertexAttribArray(i);
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
  const bool surface = item.geometry->primitive == Primitive::kTriangles;
  if (surface && (pass == Pass::kHidden || pass == Pass::kVisible)) return;

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

void SceneRenderer::Parts::drawPass(const DrawList& list, Pass pass) {
  programInUse = 0;  // `least` changes
  least = pass == Pass::kHiding ? kHides : kSeen;
  gl.DepthMask(pass == Pass::kHiding ? GL_TRUE : GL_FALSE);
  gl.DepthFunc(pass == Pass::kHidden ? GL_GREATER : GL_LEQUAL);
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

void SceneRenderer::draw(const DrawList& list, int width, int height) {
  Parts& p = *parts_;
  const Gl& gl = p.gl;
  p.statistics = {};
  p.buffers.resetCounts();
  p.setUp(list, width, height);

  gl.Viewport(0, 0, width, height);
  gl.Disable(GL_CULL_FACE);
  gl.Disable(GL_DEPTH_TEST);
  gl.Disable(GL_STENCIL_TEST);
  gl.Disable(GL_BLEND);
  gl.Enable(GL_SCISSOR_TEST);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.BindVertexArray(p.vertexArray.id());
  if (list.outer) {
    const PixelBox box = pixelBox(*list.outer, width, height);
    const glm::vec4 c = toVector(list.bars);
    gl.Scissor(box.x, box.y, box.width, box.height);
    gl.ClearColor(c.r, c.g, c.b, 1.0f);
    gl.Clear(GL_COLOR_BUFFER_BIT);
  }
  const PixelBox box = pixelBox(list.view.pixels(), width, height);
  gl.Scissor(box.x, box.y, box.width, box.height);
  gl.DepthMask(GL_TRUE);
  gl.StencilMask(0xff);
  gl.ClearDepth(1.0);
  gl.ClearStencil(0);
  gl.Clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  p.drawGround(list);

  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  p.drawPass(list, Pass::kHiding);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  if (p.statistics.elements <= kMostLayered) p.drawPass(list, Pass::kHidden);
  gl.StencilFunc(GL_ALWAYS, 0, 0xff);
  p.drawPass(list, Pass::kVisible);
  gl.Disable(GL_STENCIL_TEST);
  p.drawPass(list, Pass::kOnTop);

  gl.Disable(GL_BLEND);
  gl.Disable(GL_SCISSOR_TEST);
  gl.DepthMask(GL_TRUE);
  gl.DepthFunc(GL_LESS);
  gl.UseProgram(0);
  gl.BindVertexArray(0);
  p.statistics.uploads = p.buffers.uploads();
  p.statistics.uploadedBytes = p.buffers.uploadedBytes();
  p.buffers.collect();
}

}  // namespace vides
