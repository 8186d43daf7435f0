// A flight through any number of views, by the clock.
#pragma once

#include <span>
#include <vector>

#include "planet/flight.hpp"
#include "scene/camera_path.hpp"

namespace terrella {

class Journey {
 public:
  // views: two or more; times, where there are any, rise and begin with 0. Views without a time stand between their
  // neighbours as what is perceived of the flights to them says; after the last time a flight takes as many seconds as
  // its length, one at least. Total, as a Flight is.
  Journey(const Scene& scene, std::span<const PathView> views);

  // How long it takes, s, > 0.
  [[nodiscard]] double seconds() const { return times_.back(); }

  // The view at a time; before and after the journey, at its ends, exactly these. It begins and ends at rest, and also
  // rests between two views from one place and height, where it turns at most. All other views it flies through without
  // a stop: from a quarter of the flight before (or after, if that is shorter) to a quarter of the flight after, the
  // camera passes from one flight to the next, so that neither its velocity nor its turning ever jumps.
  [[nodiscard]] Camera at(double seconds) const;

 private:
  [[nodiscard]] bool flies_through(std::size_t view) const;
  // Half of the time in which it passes a view, s.
  [[nodiscard]] double around(std::size_t view) const;
  // Which part of a flight is done; it goes on beyond its ends where views are flown through. What only turns begins
  // and ends gently by itself.
  [[nodiscard]] double part_of(std::size_t flight, double seconds) const;
  [[nodiscard]] Camera passing(std::size_t view, double seconds) const;

  std::vector<Flight> flights_;
  std::vector<double> times_;  // of views, s
  double radius_;              // of the planet, m
};

}  // namespace terrella
