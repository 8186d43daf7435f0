// Single pictures of a scene, whole and as fine as the scene asks.
#pragma once

#include "base/image.hpp"
#include "render/renderer.hpp"

namespace terrella {

struct StillOptions {
  int width = 1280, height = 720;  // pixels, >= 1; of measurements, at most caps().max_texture
  double seconds = 0.0;
  int samples = 1;           // along each side of a pixel, >= 1
  int largest_tile = 2048;   // pixels along a side; larger pictures are drawn in several parts
  double field = 1.0;        // as of View, of the whole picture
  bool transparent = false;  // pictures without stars and sun, with opacity
};

// An sRGB picture, 3 channels, 0..1; where it is transparent, of two samples or more along a pixel's side, with its
// opacity as the fourth. Colours are as they are where the picture is opaque, so that it can be laid over anything.
Image take_picture(Renderer& renderer, const Scene& scene, const StillOptions& options);

// For Channel::color: linear light after exposure, before tone mapping, 3 channels. distance: from the eye, m, +Inf for
// the sky, 1 channel. height: over the sphere, m, +Inf for the sky, 1 channel. normal: unit, planet axes, 0 for the
// sky, 3 channels. Measurements are taken in the middle of a pixel, whatever the number of samples.
Image take_measurement(Renderer& renderer, const Scene& scene, const StillOptions& options, Channel channel);

}  // namespace terrella
