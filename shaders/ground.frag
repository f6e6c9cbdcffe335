// SPDX-License-Identifier: MIT
// The ground behind everything: from one colour above to another below.
#version 330 core
uniform vec2 target;
uniform vec4 rectangle;
uniform vec3 top;
uniform vec3 bottom;
layout(location = 0) out vec4 outColour;

void main() {
  float share = clamp((target.y - gl_FragCoord.y - rectangle.y) / rectangle.w, 0.0, 1.0);
  outColour = vec4(mix(top, bottom, share), 1.0);
}
