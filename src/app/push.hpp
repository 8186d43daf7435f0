#pragma once

namespace terrella {

// Which ways the held keys push the camera, each -1..1: to the right, ahead, up, nearer, turn right, look up.
struct Push {
  double right = 0.0, ahead = 0.0, up = 0.0, nearer = 0.0, turn = 0.0, tilt = 0.0;
  bool fast = false;  // by itself it pushes nowhere
  bool jump = false;

  bool operator==(const Push&) const = default;
};

inline bool pushes(const Push& push) { return push != Push{.fast = push.fast}; }

}  // namespace terrella
