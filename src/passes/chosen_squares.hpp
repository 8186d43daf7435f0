// Small squares of which only some are in the picture: those alone are on the GPU, sent again when others come in.
#pragma once

#include <utility>
#include <vector>

#include "gl/mesh.hpp"
#include "passes/frame.hpp"
#include "passes/kept_parts.hpp"

namespace terrella {

class ChosenSquares {
 public:
  explicit ChosenSquares(int vec4s_each) : squares_(vec4s_each) {}

  // From now on all that is chosen counts as new.
  void forget() { parts_.forget(); }

  // chosen: places of the squares to draw among all; append(place, data): adds the floats of one. frame: for whose rows
  // they are.
  template <class Append>
  void draw(const Frame& frame, Chosen chosen, const Append& append) {
    const auto append_all = [&](const Chosen& places, std::vector<float>& data) {
      for (const std::uint32_t place : places) append(place, data);
    };
    const auto send = [&](const std::vector<float>& data) { squares_.set(data); };
    const auto [first, count] = parts_.range_of(std::move(chosen), draws_all(frame), append_all, send);
    squares_.draw(first, count);
  }

 private:
  gl::Squares squares_;
  KeptParts<float> parts_;
};

}  // namespace terrella
