// How far a picture is from the truth, in the ways that one may ask for.
#pragma once

#include <vector>

#include "base/image.hpp"
#include "measure/truth.hpp"

namespace terrella {

struct PictureError {
  double mean_square = 0.0;    // of the finished picture's values, sRGB, 0..1
  double flip = 0.0;           // mean of what flip.hpp tells, 0..1
  double visible = 0.0;        // part of the pixels that are off by a difference one can see (visible_share)
  double silhouette = 0.0;     // pixels of the shown picture by which outlines are off: what only one of both shows as
                               // planet, by the outline's length; as drawn, without what scaling does to it
  double normal_median = 0.0;  // degrees
  double normal_p99 = 0.0;     // degrees

  [[nodiscard]] double psnr() const;  // dB
};

// Of each the mean; nothing off where there are none.
PictureError mean_of(const std::vector<PictureError>& errors);

// What is drawn of the surface itself, at the size it is drawn at.
struct DrawnGeometry {
  Image distance, normal;
};

struct Judgement {
  PictureError error;
  Image flip;  // of each pixel
};

// picture: as take_picture gives it.
Judgement judge(const Image& picture, const DrawnGeometry& drawn, Truth& truth);

}  // namespace terrella
