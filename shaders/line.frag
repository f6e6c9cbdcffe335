// SPDX-License-Identifier: MIT
// How much of a pixel a segment covers, from the pixel's distance to it.
#version 330 core
flat in vec4 ends;
flat in vec4 cuts;
in vec2 run;

uniform vec2 target;
uniform float halfWidth;
uniform vec2 dash;    // pixels on, and of the whole pattern; 0: solid
uniform vec4 colour;  // straight alpha
uniform vec3 ground;
uniform float fade;
uniform float least;  // coverage below which nothing is drawn

layout(location = 0) out vec4 outColour;

// How much of a pixel lies on the lower side of an edge, if its middle is `inside` far from the edge
// on that side and the edge's normal is `normal`: exact, so that a line is as bright in any
// direction.
float covered(float inside, vec2 normal) {
  float a = max(abs(normal.x), abs(normal.y)), b = min(abs(normal.x), abs(normal.y));
  float away = abs(inside), reach = 0.5 * (a + b);
  float share;
  if (away <= 0.5 * (a - b)) {
    share = away / a;
  } else {
    float rest = max(reach - away, 0.0);
    share = 0.5 - rest * rest / (2.0 * a * max(b, 1.0e-6));
  }
  return 0.5 + sign(inside) * share;
}

void main() {
  vec2 place = vec2(gl_FragCoord.x, target.y - gl_FragCoord.y);
  vec2 from = ends.xy, to = ends.zw;
  // At a join each pixel belongs to one of the two segments, so that none is covered twice.
  if (cuts.xy != vec2(0.0) && dot(place - from, cuts.xy) < 0.0) discard;
  if (cuts.zw != vec2(0.0) && dot(place - to, cuts.zw) >= 0.0) discard;

  vec2 way = to - from;
  float size = length(way);
  vec2 along = size < 0.01 ? vec2(1.0, 0.0) : way / size;
  vec2 offset = place - from;
  float passed = dot(offset, along);
  float across = dot(offset, vec2(-along.y, along.x));
  float beyond = max(max(-passed, passed - size), 0.0);
  float away = length(vec2(beyond, across));
  vec2 normal = vec2(-along.y, along.x);
  if (beyond > 0.0) normal = (along * (passed < 0.0 ? -beyond : beyond) + normal * across) / away;
  float coverage = covered(halfWidth - away, normal) - covered(-halfWidth - away, normal);
  if (dash.x > 0.0) {
    float middle = run.y + passed - 0.5 * dash.x + 0.5 * dash.y;
    float gap = abs(mod(middle, dash.y) - 0.5 * dash.y) - 0.5 * dash.x;
    coverage *= clamp(0.5 - gap, 0.0, 1.0);
  }
  if (coverage < least) discard;
  outColour = vec4(mix(colour.rgb, ground, fade * run.x), colour.a * coverage);
}
