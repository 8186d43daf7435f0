// A place for the camera to fly to.
#pragma once

#include <optional>

namespace terrella {

struct Destination {
  double latitude = 0.0, longitude = 0.0;  // degrees, within the ranges of the camera's
  std::optional<double> altitude;          // m over the sphere; nothing: by how high over the ground one is

  bool operator==(const Destination&) const = default;
};

}  // namespace terrella
