// What a frame may cost at the most, by what the needs say is modelled.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planet/needs.hpp"
#include "render/renderer.hpp"

namespace terrella {

// Upper bounds for a frame of colour of which nothing was left to be made, and for all that is held after it.
struct Cost {
  std::int64_t triangles = 0;
  int draw_calls = 0;
  std::int64_t noise_evaluations = 0;
  std::int64_t gpu_bytes = 0;
  int textures = 0;
  std::vector<std::string> programs;  // that may be held
};

// bytes_a_pixel: of the picture of light. Points of light (stars, towns) are bounded by what their searches can find.
Cost promised_cost(const Needs& needs, const View& view, int bytes_a_pixel);

// A sentence for each way in which the work exceeds the promise.
std::vector<std::string> beyond(const RenderStats& work, const Cost& promised);

}  // namespace terrella
