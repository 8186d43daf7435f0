// How far a picture of a ground of nodes misses the ground itself.
#pragma once

#include <vector>

#include "measure/node_picture.hpp"

namespace terrella {

// At a place of a triangle, pixels.
struct NodeError {
  // How far the picture is off: from where it shows ground to where the ground is, above or below that, or as far as
  // ground that the triangles lack rises before it.
  double seen;
  double upright;  // how far the triangle is off, as if that way stood across the line of sight
  double pixels;   // of the picture for which the place stands
};

// At random places of drawn triangles, the same each time, that the picture shows; and where it shows the sky, though
// ground rises before that.
// places: tried in all, as many in each node, uniformly by its triangles. footprint: pixels; what is too fine for
// samples so far apart is not counted as ground.
std::vector<NodeError> node_errors(const NodePicture& picture, int places, double footprint);

// What an error is at the most in a part (0..1) of the picture's pixels of ground. errors: at least one.
double percentile(std::vector<NodeError> errors, double NodeError::*of, double part);

}  // namespace terrella
