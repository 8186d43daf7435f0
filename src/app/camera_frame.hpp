// Where the camera of a scene stands and faces, and steps and turns from there, the same for all ways to move it.
// Lengths in planet radii, angles in rad unless they are said to be degrees.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "planet/facing.hpp"
#include "planet/pose.hpp"
#include "scene/scene.hpp"

namespace terrella {

// Of the eye from the planet's centre, and back.
double distance_of(const Scene& scene);
void set_distance(Scene& scene, double distance);

// Where the pose has raised the camera over the ground, it stays.
void keep_raised(Scene& scene, const View& view);

// The clearance that the camera comes to at the most by hands.
inline constexpr double farthest = 1e4;

// Degrees, to -180..180.
double wrapped(double degrees);

// Moves the place under the camera along the sphere by angles to the right and ahead, and carries the heading along, so
// that the view does not turn: also over a pole.
void move_over(Scene& scene, double right_angle, double ahead_angle);

// A movement in the picture (pixels right and down) as it would be if the camera did not roll.
glm::dvec2 levelled(const Scene& scene, glm::dvec2 movement);

// Degrees that a drag of so many pixels turns the view by, to the right and up, whatever the roll.
glm::dvec2 turn_of(const Scene& scene, const View& view, glm::dvec2 pixels);

// Turns the view right and up by degrees, no further than straight up and down.
void look(Scene& scene, double right, double up);

// The same by a drag of so many pixels.
void look(Scene& scene, const View& view, glm::dvec2 pixels);

// Takes the roll back, most of it within some seconds.
void level_roll(Scene& scene, double within, double dt);

// The way within dt (s) of a motion that comes to what is wished by `ease` (1/s), and the motion after it. Its integral
// is exact, so that a way does not depend on the frames it is shown in.
template <class Vector>
Vector eased_way(Vector& motion, const Vector& wish, double ease, double dt) {
  const Vector missing = motion - wish;
  motion = wish + missing * std::exp(-ease * dt);
  return dt * wish + missing * (-std::expm1(-ease * dt) / ease);
}

// No longer than 1, as keys pushed together would be.
template <class Vector>
Vector held_to_one(const Vector& wish) {
  return wish / std::max(1.0, glm::length(wish));
}

// Degrees: the pitch that shows most at a height: down at the planet from afar, along the ground close by.
double natural_pitch(double clearance);

}  // namespace terrella
