// Land as still water mirrors it: what an eye sees that is as far below the water as the true one is above. Lengths in
// planet radii.
#pragma once

#include <array>

#include "planet/pose.hpp"

namespace terrella {

// The picture of it. It stands on its head: what water at a pixel mirrors while it is still lies at the same place of
// this picture, counted from the other end.
struct Mirror {
  View view;           // of all of the picture that it belongs to, of fewer pixels
  Pose pose;           // the true eye, looking along the directions of the mirrored one
  double height;       // of the eye over the still water
  double climb = 1.0;  // sine of how steeply the mirrored eye looks up to land, at the most
};

// Half as fine as the picture, and of no more than 2048 pixels along a side: water is never as smooth as a mirror.
View mirror_view(const View& view);
Mirror mirror_of(const Scene& scene, const Pose& pose, const View& view);

// Where the mirrored eye is.
glm::dvec3 mirrored_eye(const Mirror& mirror);

// From positions relative to the true eye to the mirror's clip space, of which z is left to who draws.
glm::mat4 clip_in_mirror(const Mirror& mirror);

// By how much depths fall where a place is as high over the water as it is far along the middle of the picture: of none
// that it shows they come near to the end.
double depth_of_climb(const Mirror& mirror);

}  // namespace terrella
