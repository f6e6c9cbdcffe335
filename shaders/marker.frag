// SPDX-License-Identifier: MIT
// Discs, rings, crosses and squares by their distance functions.
#version 330 core
flat in vec4 ends;
flat in vec4 cuts;
in vec2 run;
flat in float strength;

uniform vec2 target;
uniform int shape;  // MarkerShape
uniform vec4 colour;
uniform vec3 ground;
uniform float least;

layout(location = 0) out vec4 outColour;

float toSegment(vec2 place, vec2 tip) {
  float share = clamp(dot(place, tip) / dot(tip, tip), -1.0, 1.0);
  return length(place - share * tip);
}

void main() {
  vec2 place = vec2(gl_FragCoord.x, target.y - gl_FragCoord.y) - ends.xy;
  float radius = ends.z, halfWidth = ends.w;
  vec4 fill = cuts;
  float inside = 1.0;  // distance to the filled part; below 0 in it
  float away;          // distance to the outline's middle line
  if (shape == 0) {
    away = max(length(place) - radius, 0.0);
  } else if (shape == 1) {
    inside = length(place) - radius;
    away = abs(inside);
  } else if (shape == 2) {
    float arm = radius * 0.70710678;
    away = min(toSegment(place, vec2(arm)), toSegment(place, vec2(arm, -arm)));
  } else if (shape == 3) {
    vec2 over = abs(place) - radius;
    inside = max(over.x, over.y);
    away = abs(inside);
  } else {
    away = min(toSegment(place, vec2(radius, 0.0)), toSegment(place, vec2(0.0, radius)));
  }
  float halfLine = shape == 0 ? 0.0 : halfWidth;
  float line = clamp(halfLine - away + 0.5, 0.0, 1.0);
  float area = clamp(0.5 - inside, 0.0, 1.0) * fill.a;
  // The outline over the filled part, both with straight alpha.
  float lineAlpha = line * colour.a;
  float alpha = lineAlpha + area * (1.0 - lineAlpha);
  if (alpha <= 0.0 || max(line, area) < least) discard;
  vec3 mixed = (colour.rgb * lineAlpha + fill.rgb * area * (1.0 - lineAlpha)) / alpha;
  outColour = vec4(mix(mixed, ground, run.y * run.x), alpha * strength);
}
