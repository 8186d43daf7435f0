// What a scene is made of, as the formulas of shaders/lib take it. Lengths in planet radii, colours as linear light.
#pragma once

#include "formulas/formulas.hpp"
#include "planet/pose.hpp"
#include "scene/scene.hpp"

namespace terrella {

f64::Air air_of(const Scene& scene);
f64::Bands bands_of(const Scene& scene);
f64::Clouds clouds_of(const Scene& scene);
f64::WaterLook water_look_of(const Scene& scene);

// Whether there is air to be seen.
bool has_air(const Scene& scene);
bool has_clouds(const Scene& scene);
bool has_stars(const Scene& scene);

// The cosine and sine of an angle (rad) that grows with time without end, reduced to one turn in double precision.
glm::dvec2 turned(double speed, double seconds);

// What lights the scene around an eye, from the sun's direction on. The air's density is 0 where has_air is false.
f64::SceneLight light_of(const Scene& scene, const Pose& pose);

}  // namespace terrella
