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
out float far;

void main() {
  vec4 place = texelFetch(points, 3 * first + gl_VertexID);
  vec4 clip = toClip * vec4(place.xyz, 1.0);
  far = dot(depthPlane, vec4(place.xyz, 1.0));
  // The clip square of the rectangle becomes its part of the framebuffer's.
  vec2 scale = rectangle.zw / target;
  vec2 middle = (2.0 * rectangle.xy + rectangle.zw) / target;
  gl_Position = vec4(clip.x * scale.x + clip.w * (middle.x - 1.0),
                     clip.y * scale.y + clip.w * (1.0 - middle.y), clip.z - lift * clip.w, clip.w);
}
