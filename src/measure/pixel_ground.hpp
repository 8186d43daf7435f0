// Where a pixel shows the ground of nodes: what shaders/node_surface.glsl makes of what the vertices around it tell, in
// double precision and with the same formulas. Lengths in planet radii.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "formulas/formulas.hpp"

namespace terrella {

// What a vertex of a node tells of the ground, as the distance to the eye has it; or what is interpolated between some.
struct ToldGround {
  glm::dvec3 place{0.0};
  glm::dvec3 from_centre{0.0};  // of the node
  double square = 0.0;          // of that
  double over = 0.0;            // f64::over_at_vertex, of places from the centre
  glm::dvec3 slope{0.0};        // of the ground that pixels go on with, over the unit sphere and along it
  glm::dvec2 means{0.0};        // mean and shape of Height
  double iced = 0.0;            // 0..1
  double spacing = 0.0;         // of a node's vertices, rad
  double above = 0.0;           // part to which they tell the ground as those of the level above do
};

// parts: of each, their sum 1.
ToldGround between(const ToldGround& a, const ToldGround& b, const ToldGround& c, const glm::dvec3& parts);

std::vector<glm::dvec3> places_of(const std::vector<ToldGround>& vertices);

// told: at a place of a triangle; sample: angle between samples, rad; octaves: the layers of noise end there. Returns
// the place of the ground that the pixel shows for it, on the same ray from the eye.
glm::dvec3 shown_place(const ToldGround& told, const f64::Terrain& terrain, const glm::dvec3& eye, double sample,
                       int octaves);

}  // namespace terrella
