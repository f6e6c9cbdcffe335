// SPDX-License-Identifier: MIT
// Dear ImGui's vertices: place in its coordinates, place in the texture, colour.
#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texturePlace;
layout(location = 2) in vec4 colour;
uniform mat4 projection;
out vec2 fragmentTexturePlace;
out vec4 fragmentColour;

void main() {
  fragmentTexturePlace = texturePlace;
  fragmentColour = colour;
  gl_Position = projection * vec4(position, 0.0, 1.0);
}
