// SPDX-License-Identifier: MIT
// Corners of triangles, in the cube or in pixels.
#version 330 core
uniform samplerBuffer points;
uniform int first;
uniform mat4 toClip;
uniform vec4 rectangle;
uniform vec2 target;
uniform vec4 depthPlane;
uniform float lift;
uniform vec4 colour;
uniform vec3 ground;
// As line.vert hands over.
flat out vec4 ends;  // the colour
flat out vec4 cuts;  // what it fades to; the first of three addends of the way to the far side
out vec2 run;        // the others

void main() {
  ends = cuts = vec4(0.0);
  run = vec2(0.0);
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // beyond everything
  vec4 place = texelFetch(points, 3 * first + gl_VertexID);
  // As of lines, never of triangles; but what were the same for all corners without any condition,
  // the driver would not hand over.
  if (place.w < 0.0) return;
  vec4 clip = toClip * vec4(place.xyz, 1.0);
  ends = colour;
  cuts = vec4(ground, depthPlane.w);
  run = vec2(dot(depthPlane.xy, place.xy), depthPlane.z * place.z);
  // The clip square of the rectangle becomes its part of the framebuffer's.
  vec2 scale = rectangle.zw / target;
  vec2 middle = (2.0 * rectangle.xy + rectangle.zw) / target;
  gl_Position = vec4(clip.x * scale.x + clip.w * (middle.x - 1.0),
                     clip.y * scale.y + clip.w * (1.0 - middle.y), clip.z - lift * clip.w, clip.w);
}
