// Numbers that tell how far a picture or a measurement is from another one.
#pragma once

#include "base/image.hpp"

namespace terrella {

// Peak signal to noise ratio, dB, of two pictures of one size and values whose peak is 1; 200 where they are equal.
double psnr(const Image& a, const Image& b);

// Of all values of a picture.
double mean_of(const Image& image);

// The value that a share (0..1) of all values of a picture does not pass.
double quantile_of(const Image& image, double share);

// What is seen where, beside a reference of the same size.
struct GeometryError {
  double silhouette = 0.0;       // part of the pixels in which only one of both shows the planet
  double distance_median = 0.0;  // relative, of pixels in which both do
  double distance_p99 = 0.0;
  double normal_median = 0.0;  // angle, degrees, of the same pixels
  double normal_p99 = 0.0;
};

// distance: 1 channel, infinite for the sky; normal: 3 channels, unit.
GeometryError geometry_error(const Image& distance, const Image& normal, const Image& true_distance,
                             const Image& true_normal);

}  // namespace terrella
