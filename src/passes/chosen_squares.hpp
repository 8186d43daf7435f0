// Small squares of which only some are in the picture: those alone are on the GPU, sent again when others come in.
#pragma once

#include <utility>
#include <vector>

#include "gl/mesh.hpp"

namespace terrella {

class ChosenSquares {
 public:
  explicit ChosenSquares(int vec4s_each) : squares_(vec4s_each) {}

  // From now on all that is chosen counts as new.
  void forget() {
    chosen_.clear();
    squares_.set({});
  }

  // chosen: places of the squares to draw among all; append(place, data): adds the floats of one.
  template <class Append>
  void draw(std::vector<std::size_t> chosen, const Append& append) {
    if (chosen != chosen_) {
      std::vector<float> data;
      for (const std::size_t place : chosen) append(place, data);
      squares_.set(data);
      chosen_ = std::move(chosen);
    }
    squares_.draw();
  }

 private:
  gl::Squares squares_;
  std::vector<std::size_t> chosen_;
};

}  // namespace terrella
