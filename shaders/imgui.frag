// SPDX-License-Identifier: MIT
// Dear ImGui's triangles: the vertex colour times the texture, all in plain sRGB numbers.
#version 330 core
in vec2 fragmentTexturePlace;
in vec4 fragmentColour;
uniform sampler2D picture;
// Left, bottom, right, top in pixels. The scissor test alone is not enough: with several samples a
// pixel Mesa's software drivers let half a pixel at the left and below through.
uniform vec4 clip;
layout(location = 0) out vec4 outColour;

void main() {
  if (any(lessThan(gl_FragCoord.xy, clip.xy)) || any(greaterThan(gl_FragCoord.xy, clip.zw))) {
    discard;
  }
  outColour = fragmentColour * texture(picture, fragmentTexturePlace);
}
