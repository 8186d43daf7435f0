// How far the triangles that a ground of nodes is drawn with miss the ground itself.
#pragma once

#include <vector>

#include "measure/node_picture.hpp"

namespace terrella {

// At a place of a triangle, pixels.
struct NodeError {
  double seen;     // from where the picture shows it to where it shows the ground above or below it
  double upright;  // how long that way would be in the picture if it stood across the line of sight
  double pixels;   // of the picture for which the place stands, in proportion
};

// At random places of drawn triangles, the same each time, that the picture shows.
// places: tried in all, as many in each node, uniformly by its triangles. footprint: pixels; what is too fine for
// samples so far apart is not counted as ground.
std::vector<NodeError> node_errors(const NodePicture& picture, int places, double footprint);

// What an error is at the most in a part (0..1) of the picture's pixels of ground. errors: at least one.
double percentile(std::vector<NodeError> errors, double NodeError::*of, double part);

}  // namespace terrella
