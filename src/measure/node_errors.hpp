// How far a picture of a ground of nodes misses the ground itself.
#pragma once

#include <vector>

#include "measure/node_picture.hpp"

namespace terrella {

// At a place of a picture, pixels.
struct NodeError {
  // How far the picture is off: from where it shows ground to where the ground is, above or below that, or as far as
  // ground that the triangles lack rises before it.
  double seen;
  double upright;  // how far the triangle is off, as if that way stood across the line of sight
};

// At random places of the picture, the same each time, that show ground, or the sky though ground rises before that.
// places: as many, or fewer where hardly any are found. footprint: pixels; what is too fine for samples so far apart is
// not counted as ground.
std::vector<NodeError> node_errors(const NodePicture& picture, int places, double footprint);

// What they are at the most in a part (0..1) of them. errors: at least one.
double percentile(const std::vector<NodeError>& errors, double NodeError::*of, double part);

}  // namespace terrella
