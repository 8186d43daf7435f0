#include "app/develop.hpp"

#include <algorithm>

#include "formulas/formulas.hpp"

namespace terrella {

Image developed(const Image& light, int tone) {
  Image picture(light.width, light.height, light.channels);
  for (int y = 0; y < light.height; ++y) {
    for (int x = 0; x < light.width; ++x) {
      const float* from = light.at(x, y);
      const float noise = f32::dither(glm::vec2(x, y)) / 255.0F;
      const bool opaque = light.channels == 3;
      const float opacity = opaque ? 1.0F : std::clamp(from[3], 0.0F, 1.0F);
      const glm::vec3 full = glm::vec3(from[0], from[1], from[2]) / std::max(opacity, 1e-3F);
      const glm::vec3 shown = f32::srgb(f32::tone_map(full, tone)) + noise;
      for (int c = 0; c < 3; ++c) picture.at(x, y)[c] = std::clamp(shown[c], 0.0F, 1.0F);
      if (!opaque) picture.at(x, y)[3] = opacity;
    }
  }
  return picture;
}

}  // namespace terrella
