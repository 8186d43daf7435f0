// Work that never changes, timed beside all else: where it takes longer, it is the machine that is slower.
#pragma once

#include "gl/target.hpp"

namespace terrella {

class ControlLoad {
 public:
  // Needs a current context.
  ControlLoad();

  // Copies a picture again and again, scaled: nothing of a planet, so that no change of the program changes it.
  void draw() const;

 private:
  gl::Target from_, to_;
};

}  // namespace terrella
