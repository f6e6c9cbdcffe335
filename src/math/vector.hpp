// SPDX-License-Identifier: MIT
// The number types of the core: doubles everywhere, floats only on the way to the GPU.
#pragma once

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace vides {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;
// Written (w, x, y, z), as in glm's constructor.
using Quaternion = glm::dquat;

}  // namespace vides
