// Whole pictures by the reference, on all cores. The same whatever the number of threads.
#pragma once

#include <functional>

#include "base/image.hpp"
#include "planet/pose.hpp"
#include "reference/footprints.hpp"
#include "scene/scene.hpp"

namespace terrella::reference {

struct Options {
  int width = 1280, height = 720;  // pixels, >= 1
  double seconds = 0.0;
  int samples = 1;  // along each side of a pixel, >= 1
  int threads = 0;  // 0: as many as the machine has cores
  Footprints left_out;
  // Told the finished part, 0..1, now and then, by the calling thread only.
  std::function<void(double)> progress;
};

// Linear light after exposure, before tone mapping, 3 channels: the mean of all samples.
Image light(const Scene& scene, const Options& options);

// What is seen in the middle of each pixel.
struct Geometry {
  Image distance;  // from the eye, m, +Inf for the sky, 1 channel
  Image normal;    // unit, planet axes, 0 for the sky, 3 channels
  Image height;    // over the sphere, m, +Inf for the sky, 1 channel
};

Geometry geometry(const Scene& scene, const Options& options);

}  // namespace terrella::reference
