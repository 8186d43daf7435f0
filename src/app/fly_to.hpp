// A flight of a few seconds to a place, without a hand.
#pragma once

#include <optional>

#include "planet/flight.hpp"
#include "planet/pose.hpp"
#include "scene/destination.hpp"
#include "scene/scene.hpp"

namespace terrella {

// The scene's camera as it would look around at a place: with the same heading, level, its pitch changed as on coming
// nearer in orbit. clearance: over the ground there, planet radii, where it has no altitude; nothing: as here.
Camera view_of_place(const Scene& scene, const Destination& there, std::optional<double> clearance);

class FlyTo {
 public:
  // From the scene's camera.
  void start(const Scene& scene, const Camera& to);
  void stop() { flight_.reset(); }
  [[nodiscard]] bool moving() const { return flight_.has_value(); }

  // Moves on by dt (s). Where anything else has changed the scene since the last call, the flight ends instead.
  void tick(Scene& scene, const View& view, double dt);

 private:
  std::optional<Flight> flight_;
  Scene left_;  // as the last call has left it
  double seconds_ = 0.0, passed_ = 0.0;
};

}  // namespace terrella
