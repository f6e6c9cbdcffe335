// SPDX-License-Identifier: MIT
// Dear ImGui's triangles: the vertex colour times the texture, all in plain sRGB numbers.
#version 330 core
in vec2 fragmentTexturePlace;
in vec4 fragmentColour;
uniform sampler2D picture;
layout(location = 0) out vec4 outColour;

void main() { outColour = fragmentColour * texture(picture, fragmentTexturePlace); }
