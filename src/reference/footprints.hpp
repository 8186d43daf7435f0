#pragma once

namespace terrella::reference {

// What to leave out of the scene, to see what it costs: layers of noise that samples so far apart (rad) can't show. 0:
// nothing.
struct Footprints {
  double ground = 0.0, clouds = 0.0, ripples = 0.0;
};

}  // namespace terrella::reference
