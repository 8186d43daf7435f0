#include "planet/journey.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "base/check.hpp"

namespace terrella {
namespace {

// If nobody says how long it takes.
double seconds_of(const Flight& flight) { return std::max(1.0, flight.length()); }

std::vector<double> times_of(std::span<const PathView> views, const std::vector<Flight>& flights) {
  std::vector<double> liked{0.0}, times(views.size(), 0.0);
  for (const Flight& flight : flights) liked.push_back(liked.back() + seconds_of(flight));
  std::size_t last = 0;  // whose time is known
  for (std::size_t i = 1; i < views.size(); ++i) {
    if (!views[i].at && i + 1 < views.size()) continue;
    times[i] = views[i].at.value_or(times[last] + liked[i] - liked[last]);
    for (std::size_t j = last + 1; j < i; ++j) {
      times[j] = std::lerp(times[last], times[i], (liked[j] - liked[last]) / (liked[i] - liked[last]));
    }
    last = i;
  }
  return times;
}

// A cubic from 0 to 1 with these slopes at its ends (0 or 1), and straight on beyond them.
double part_between(double x, double slope_at_start, double slope_at_end) {
  if (x < 0.0) return slope_at_start * x;
  if (x > 1.0) return 1.0 + slope_at_end * (x - 1.0);
  return glm::smoothstep(0.0, 1.0, x) + x * (1.0 - x) * (slope_at_start * (1.0 - x) - slope_at_end * x);
}

}  // namespace

Journey::Journey(const Scene& scene, std::span<const PathView> views) : radius_(scene.planet.radius) {
  CHECK(views.size() >= 2, views.size(), " views");
  for (std::size_t i = 1; i < views.size(); ++i) flights_.emplace_back(scene, views[i - 1].camera, views[i].camera);
  times_ = times_of(views, flights_);
}

Camera Journey::at(double seconds) const {
  if (!(seconds > 0.0)) return flights_.front().from();
  if (seconds >= times_.back()) return flights_.back().to();
  const auto next = std::upper_bound(times_.begin(), times_.end(), seconds);
  const std::size_t view = static_cast<std::size_t>(next - times_.begin());  // the next one
  for (const std::size_t near : {view - 1, view}) {
    if (flies_through(near) && std::abs(seconds - times_[near]) < around(near)) return passing(near, seconds);
  }
  return flights_[view - 1].at(part_of(view - 1, seconds));
}

bool Journey::flies_through(std::size_t view) const {
  return view > 0 && view < flights_.size() && flights_[view - 1].moves() && flights_[view].moves();
}

double Journey::around(std::size_t view) const {
  return 0.25 * std::min(times_[view] - times_[view - 1], times_[view + 1] - times_[view]);
}

double Journey::part_of(std::size_t flight, double seconds) const {
  const double x = (seconds - times_[flight]) / (times_[flight + 1] - times_[flight]);
  if (!flights_[flight].moves()) return x;
  return part_between(x, flies_through(flight) ? 1.0 : 0.0, flies_through(flight + 1) ? 1.0 : 0.0);
}

// Both flights lead through the view at its time, so that whatever is between them does as well.
Camera Journey::passing(std::size_t view, double seconds) const {
  const Step before = flights_[view - 1].from_end(part_of(view - 1, seconds));
  const Step after = flights_[view].from_start(part_of(view, seconds));
  const double share = glm::smoothstep(0.0, 1.0, 0.5 + 0.5 * (seconds - times_[view]) / around(view));
  return camera_at(facing_of(flights_[view].from()), between(before, after, share), radius_);
}

}  // namespace terrella
