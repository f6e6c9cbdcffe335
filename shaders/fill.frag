// SPDX-License-Identifier: MIT
// Triangles of one colour.
#version 330 core
flat in vec4 ends;
flat in vec4 cuts;
in vec2 run;
uniform vec2 target;
uniform float fade;
layout(location = 0) out vec4 outColour;

void main() {
  outColour = ends;
  if (fade > 0.0) {
    // Every pixel's place is within the target: reading it is part of what the three programs have
    // in common.
    float share = gl_FragCoord.x < 0.0 || gl_FragCoord.y > target.y ? 0.0 : fade;
    float far = clamp(cuts.w + run.x + run.y, 0.0, 1.0);
    outColour.rgb = mix(ends.rgb, cuts.rgb, share * far);
  }
}
