// Where one stands on the planet and which way one faces, as vectors: without the poles and the date line that
// latitude, longitude and heading have.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/camera_path.hpp"

namespace terrella {

struct Facing {
  glm::dvec3 place;  // unit, from the planet's centre
  glm::dvec3 ahead;  // unit, level
};

// Below the camera, as it is headed.
Facing facing_of(const Camera& camera);

// Sets latitude, longitude (-180..180) and heading (-180..180) of a camera, degrees.
void set_facing(Camera& camera, const Facing& facing);

// The way to the right of ahead.
glm::dvec3 right_of(const Facing& facing);

// Over the ground by angles (rad) to the right and ahead, along one great circle; facing is carried along, so that it
// does not turn on the way: also over a pole.
Facing carried(const Facing& facing, const glm::dvec2& way);

// Turned to the right, rad.
Facing turned(const Facing& facing, double angle);

}  // namespace terrella
