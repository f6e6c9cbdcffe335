// SPDX-License-Identifier: MIT
// Six corners are a sign of fixed size at a place.
#version 330 core
uniform samplerBuffer points;
uniform int first;

uniform mat4 toClip;
uniform vec4 rectangle;
uniform vec2 target;
uniform vec4 depthPlane;
uniform float nearest;
uniform float lift;
uniform vec2 offset;   // pixels, y down
uniform float reach;   // pixels from the middle that the sign may cover
uniform float radius;
uniform float halfWidth;
uniform vec4 fill;
uniform float fade;

const int kCorners[6] = int[6](0, 1, 2, 2, 1, 3);

// As line.vert hands over.
flat out vec4 ends;  // the middle; radius; half of the outline's width
flat out vec4 cuts;  // the colour inside
out vec2 run;        // the share of the way to the far side; how much fades there
flat out float strength;  // what of the opacity is left

void main() {
  ends = cuts = vec4(0.0);
  run = vec2(0.0);
  strength = 0.0;
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  vec4 place = texelFetch(points, first + gl_VertexID / 6);
  int which = kCorners[gl_VertexID % 6];
  vec4 clip = toClip * vec4(place.xyz, 1.0);
  if (clip.w <= nearest) return;
  vec2 middle = rectangle.xy + offset +
                rectangle.zw * (vec2(0.5) + vec2(0.5, -0.5) * clip.xy / clip.w);
  // A smaller one has a thinner line, but not as much thinner; before it is gone it fades.
  float share = 1.0 - place.w;
  if (share <= 0.0) return;
  ends = vec4(middle, radius * share, halfWidth * (0.4 + 0.6 * share));
  strength = clamp(4.0 * share, 0.0, 1.0);
  cuts = fill;
  run = vec2(clamp(dot(depthPlane, vec4(place.xyz, 1.0)), 0.0, 1.0), fade);
  vec2 side = vec2((which & 1) == 0 ? -1.0 : 1.0, which < 2 ? -1.0 : 1.0);
  vec2 corner = middle + side * reach;
  float depth = clamp(clip.z / clip.w - lift, -1.0, 1.0);
  gl_Position = vec4(2.0 * corner.x / target.x - 1.0, 1.0 - 2.0 * corner.y / target.y, depth, 1.0);
}
