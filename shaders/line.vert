// SPDX-License-Identifier: MIT
// Six corners are a segment of a line: cut to what is seen, then widened to a quad in pixels.
#version 330 core
// The points; w: pixels of the dashes' pattern, below 0: the line ends. No vertex attributes: one draw
// of many corners is cheaper than one instance a segment, most of all in software.
uniform samplerBuffer points;
uniform int first;
uniform bool joined;  // polylines: a segment a point, with the points around it; else one a pair

uniform mat4 toClip;
uniform vec4 rectangle;   // x, y, width, height in pixels, y down: the clip square
uniform vec2 target;      // pixels of the framebuffer
uniform vec4 depthPlane;  // a point's share of the way from near to far
uniform float nearest;    // w of the front plane; 0 in a parallel projection
uniform float halfWidth;
uniform float lift;       // towards the viewer, in clip units

// The three programs of the scene hand over the same: a software driver makes the code that sets
// up triangles anew for each kind of hand-over, and keeps it in no cache on disk.
flat out vec4 ends;  // both ends, pixels, y down
flat out vec4 cuts;  // normals of the bisectors at both ends; 0: a round end
out vec2 run;        // the share of the way to the far side; pixels of the pattern at the start

const int kCorners[6] = int[6](0, 1, 2, 2, 1, 3);
const float kTiny = 0.01;  // pixels: shorter has no direction

vec2 pixelOf(vec4 clip) {
  return rectangle.xy + rectangle.zw * (vec2(0.5) + vec2(0.5, -0.5) * clip.xy / clip.w);
}

// Keeps the part of [t0, t1] where the value that runs from a to b is not negative.
void keep(float a, float b, inout float t0, inout float t1) {
  if (a < 0.0 && b < 0.0) {
    t1 = -1.0;
  } else if (a < 0.0) {
    t0 = max(t0, a / (a - b));
  } else if (b < 0.0) {
    t1 = min(t1, a / (a - b));
  }
}

// The normal of the line that parts two segments; 0 where they fold back on each other.
vec2 bisector(vec2 incoming, vec2 outgoing) {
  return dot(incoming, outgoing) < -0.9 ? vec2(0.0) : normalize(incoming + outgoing);
}

// How far beyond its end a segment's share of the join can reach.
float reachOf(vec2 cut, vec2 along, float whole) {
  if (cut == vec2(0.0)) return whole;
  float cosine = max(dot(cut, along), 0.1);
  return min(whole, whole * sqrt(max(1.0 - cosine * cosine, 0.0)) / cosine + 0.75);
}

void main() {
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // beyond everything
  ends = cuts = vec4(0.0);
  run = vec2(0.0);
  int element = first + gl_VertexID / 6;
  int which = kCorners[gl_VertexID % 6];
  int index = joined ? element + 1 : 2 * element;
  vec4 start = texelFetch(points, index);
  vec4 end = texelFetch(points, index + 1);
  if (joined && start.w < 0.0) return;

  vec4 a = toClip * vec4(start.xyz, 1.0);
  vec4 b = toClip * vec4(end.xyz, 1.0);
  vec2 margin = vec2(1.0) + (2.0 * halfWidth + 4.0) / rectangle.zw;
  float t0 = 0.0, t1 = 1.0;
  keep(a.w - nearest, b.w - nearest, t0, t1);
  keep(margin.x * a.w + a.x, margin.x * b.w + b.x, t0, t1);
  keep(margin.x * a.w - a.x, margin.x * b.w - b.x, t0, t1);
  keep(margin.y * a.w + a.y, margin.y * b.w + b.y, t0, t1);
  keep(margin.y * a.w - a.y, margin.y * b.w - b.y, t0, t1);
  if (t0 > t1) return;
  vec4 first = t0 > 0.0 ? mix(a, b, t0) : a;
  vec4 second = t1 < 1.0 ? mix(a, b, t1) : b;
  vec2 from = pixelOf(first);
  vec2 to = pixelOf(second);
  ends = vec4(from, to);

  vec2 way = to - from;
  float size = length(way);
  if (joined && size < kTiny) return;  // its neighbours cover it
  vec2 along = size < kTiny ? vec2(1.0, 0.0) : way / size;
  vec4 before = texelFetch(points, max(index - 1, 0));
  if (joined && before.w >= 0.0 && t0 == 0.0) {
    vec4 clip = toClip * vec4(before.xyz, 1.0);
    vec2 incoming = from - pixelOf(clip);
    if (clip.w > nearest && length(incoming) >= kTiny) {
      cuts.xy = bisector(normalize(incoming), along);
    }
  }
  if (joined && end.w >= 0.0 && t1 == 1.0) {
    vec4 clip = toClip * vec4(texelFetch(points, index + 2).xyz, 1.0);
    vec2 outgoing = pixelOf(clip) - to;
    if (clip.w > nearest && length(outgoing) >= kTiny) {
      cuts.zw = bisector(along, normalize(outgoing));
    }
  }
  run.y = joined ? start.w : 0.0;
  if (t0 > 0.0 && a.w > nearest) run.y += distance(pixelOf(a), from);

  bool atStart = which < 2;
  float side = (which & 1) == 0 ? -1.0 : 1.0;
  float whole = halfWidth + 1.0;
  vec2 corner = atStart ? from - along * reachOf(cuts.xy, along, whole)
                        : to + along * reachOf(cuts.zw, along, whole);
  corner += side * whole * vec2(-along.y, along.x);

  vec4 clip = atStart ? first : second;
  vec4 world = vec4(mix(start.xyz, end.xyz, atStart ? t0 : t1), 1.0);
  run.x = clamp(dot(depthPlane, world), 0.0, 1.0);
  // Kept between the planes: what lies beyond the back plane is drawn farthest.
  float depth = clamp(clip.z / clip.w - lift, -1.0, 1.0);
  gl_Position = vec4(2.0 * corner.x / target.x - 1.0, 1.0 - 2.0 * corner.y / target.y, depth, 1.0);
}
