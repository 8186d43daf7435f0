// How different two pictures look to someone who flips between them.
#pragma once

#include "base/image.hpp"

namespace terrella {

// FLIP for pictures of low dynamic range (Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild 2020, "FLIP:
// A Difference Evaluator for Alternating Images"): colours as they are seen from a distance, and edges and points that
// only one of the pictures has. reference, test: sRGB, 3 channels, 0..1, of one size. pixels_per_degree: of the eye's
// field, by default of a screen of 3840 pixels and 0.7 m seen from 0.7 m. Returns 1 channel, 0 (alike) to 1.
Image flip(const Image& reference, const Image& test, double pixels_per_degree = 67.0);

}  // namespace terrella
