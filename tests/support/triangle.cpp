// SPDX-License-Identifier: MIT
// Draws one smooth triangle, the same on every host.
#include "support/triangle.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <span>

#include "render/gl_objects.hpp"

namespace vides::test {
namespace {

constexpr std::string_view kVertexShader = R"(#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec3 colour;
out vec3 fragmentColour;
void main() {
  fragmentColour = colour;
  gl_Position = vec4(position, 0.0, 1.0);
}
)";
constexpr std::string_view kFragmentShader = R"(#version 330 core
in vec3 fragmentColour;
layout(location = 0) out vec4 outColour;
void main() { outColour = vec4(fragmentColour, 1.0); }
)";

template <typename T>
T orAbort(tl::expected<T, std::string> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "%s\n", result.error().c_str());
  std::abort();
}

}  // namespace

bool drawTriangle(Host& host) {
  if (!host.beginDrawing()) return false;
  const Gl& gl = host.gl();
  const auto program =
      orAbort(ShaderProgram::build(gl, "triangle", kVertexShader, kFragmentShader));
  // x y, red green blue
  constexpr std::array kVertices = {-0.8f, -0.9f, 1.0f, 0.0f, 0.0f,  //
                                    0.9f,  -0.7f, 0.0f, 1.0f, 0.0f,  //
                                    0.1f,  0.8f,  0.0f, 0.0f, 1.0f};
  const VertexArray array(gl);
  gl.BindVertexArray(array.id());
  Buffer buffer(gl, GL_ARRAY_BUFFER);
  buffer.upload(std::as_bytes(std::span(kVertices)), GL_STATIC_DRAW);
  constexpr GLsizei kStride = 5 * sizeof(float);
  gl.EnableVertexAttribArray(0);
  gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, kStride, nullptr);
  gl.EnableVertexAttribArray(1);
  gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, kStride,
                         reinterpret_cast<const void*>(2 * sizeof(float)));
  gl.ClearColor(0.1f, 0.1f, 0.1f, 1.0f);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  program.use();
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.UseProgram(0);
  gl.BindVertexArray(0);
  host.swap();
  if (const auto ok = checkGl(gl, "triangle"); !ok) {
    std::fprintf(stderr, "%s\n", ok.error().c_str());
    std::abort();
  }
  return true;
}

}  // namespace vides::test
