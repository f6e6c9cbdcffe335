// SPDX-License-Identifier: MIT
// Dear ImGui's vertices: place in its coordinates, place in the texture, colour.
#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texturePlace;
layout(location = 2) in vec4 colour;
uniform mat4 projection;
// Left, bottom, right, top in clip space. The scissor test alone is not enough: with several samples
// a pixel Mesa's software drivers let half a pixel through at the left and below. (Discarding
// fragments instead doubles the time that the interface takes there.)
uniform vec4 clip;
out vec2 fragmentTexturePlace;
out vec4 fragmentColour;
out float gl_ClipDistance[4];

void main() {
  fragmentTexturePlace = texturePlace;
  fragmentColour = colour;
  gl_Position = projection * vec4(position, 0.0, 1.0);
  gl_ClipDistance[0] = gl_Position.x - clip.x;
  gl_ClipDistance[1] = gl_Position.y - clip.y;
  gl_ClipDistance[2] = clip.z - gl_Position.x;
  gl_ClipDistance[3] = clip.w - gl_Position.y;
}
