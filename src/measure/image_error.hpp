// Numbers that tell how far a picture or a measurement is from another one.
#pragma once

#include "base/image.hpp"

namespace terrella {

// Peak signal to noise ratio, dB, of two pictures of one size and values whose peak is 1; 200 where they are equal.
double psnr(const Image& a, const Image& b);

// Mean of the squares of what two pictures of one size differ by, over all of their values.
double mean_square_error(const Image& a, const Image& b);

// The ratio for a mean square error of values whose peak is 1, dB; 200 where it is 0.
double psnr_of(double mean_square);

// The part of the pixels (0..1) whose colours one can tell apart where they lie side by side: more than 2.3 apart in
// CIE 1976 L*a*b* (Mahy, Van Eycken, Oosterlinck 1994, "Evaluation of uniform color spaces developed after the adoption
// of CIELAB and CIELUV"). sRGB, 3 channels, 0..1, of one size.
double visible_share(const Image& a, const Image& b);

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

// Length in pixels of the line between planet and sky, from how often rows and columns cross it (Cauchy and Crofton, in
// two directions: right within a tenth for a straight line, and for a circle). distance: as above.
double outline_length(const Image& distance);

}  // namespace terrella
