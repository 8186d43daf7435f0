// How different two pictures look to someone who flips between them.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/image.hpp"

namespace terrella {

// FLIP for pictures of low dynamic range (Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild 2020, "FLIP:
// A Difference Evaluator for Alternating Images"): colours as they are seen from a distance, and edges and points that
// only one of the pictures has. reference, test: sRGB, 3 channels, 0..1, of one size. pixels_per_degree: of the eye's
// field, by default of a screen of 3840 pixels and 0.7 m seen from 0.7 m. Returns 1 channel, 0 (alike) to 1.
Image flip(const Image& reference, const Image& test, double pixels_per_degree = 67.0);

// The same for many pictures beside one reference, which is looked at once.
class Flip {
 public:
  explicit Flip(const Image& reference, double pixels_per_degree = 67.0);
  [[nodiscard]] Image against(const Image& test) const;

 private:
  struct Looked {
    std::vector<glm::dvec3> colors;    // L*a*b* as seen
    std::vector<glm::dvec2> features;  // edges and points of the picture itself
  };
  [[nodiscard]] Looked look_at(const Image& image) const;

  int width_, height_;
  double pixels_per_degree_;
  Looked reference_;
};

}  // namespace terrella
