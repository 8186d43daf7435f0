// The ground of a scene on the CPU: the same formulas as on the GPU. Lengths in planet radii.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "formulas/formulas.hpp"
#include "scene/scene.hpp"

namespace terrella {

// The parameters of the height function, in planet radii.
f64::Terrain exact_terrain_of(const Scene& scene);
f32::Terrain terrain_of(const Scene& scene);

// Samples this close (rad) ask for layers as fine as integers of 32 bits can tell the cells of: three millimetres on an
// Earth, a hand's breadth on the largest planet.
inline constexpr double finest_footprint = 5e-10;

// The first layer of noise that adds to the ground: where there is a map, it stands for those before.
int first_layer(const Scene& scene);

// Whether the ground is anything else than a sphere before ice and water.
bool has_relief(const Scene& scene);

// Work of one height among samples a footprint (rad) apart, in evaluations of noise, at least 1. A size of craters
// takes as long as three (measured); ice is looked for only around the poles.
int noise_per_height(const Scene& scene, double footprint);

// Radii of the ground at each direction (unit), as a mesh with the given length of edges (rad) can carry it.
double ground_radius(const f32::Terrain& terrain, const glm::dvec3& direction, double edge);

// The same where steps of a walker count: single precision places no finer than 0.4 m on a planet as large as the
// Earth.
double exact_ground_radius(const f64::Terrain& terrain, const glm::dvec3& direction, double edge);

// terrain_height_at of a direction (unit) for several footprints (rad), the finest first: what they have in common,
// which is nearly all, is computed once. heights: room for as many, at least.
void heights_at(const glm::dvec3& direction, const f64::Terrain& terrain, std::span<const double> footprints,
                std::span<f64::Height> heights);

// Radius of the flat triangle that a mesh of the given icosphere level shows at a direction.
double drawn_ground_radius(const f32::Terrain& terrain, const glm::dvec3& direction, int level);

// How much slopes vary along an axis by layers that samples a footprint (rad) apart can't show: the variance, before
// the power of heights, which multiplies slopes by height_power_slope.
double unseen_slopes(const Scene& scene, double footprint);

// How far (planet radii) the ground rises and falls, as a standard deviation, by layers that samples a footprint (rad)
// apart can't show, and that those of finer ones can: where it is steep, seven tenths of the way up to its highest.
double unseen_heights(const Scene& scene, double footprint, double finer);

// Terrain is drawn only where the scene asks for it.
bool has_ground(const Scene& scene);
bool has_water(const Scene& scene);

// Ice around the poles needs a sea to float on.
bool has_ice(const Scene& scene);

// Height over the sphere from which heights over the water count, m; 0 without water.
double water_level(const Scene& scene);

}  // namespace terrella
