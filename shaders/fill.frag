// SPDX-License-Identifier: MIT
// Triangles of one colour.
#version 330 core
in float far;
uniform vec4 colour;
uniform vec3 ground;
uniform float fade;
layout(location = 0) out vec4 outColour;

void main() { outColour = vec4(mix(colour.rgb, ground, fade * clamp(far, 0.0, 1.0)), colour.a); }
