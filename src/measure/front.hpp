// Which settings are worth their time.
#pragma once

#include <cstddef>
#include <vector>

namespace terrella {

// What a setting asks and gives.
struct Offer {
  double ms = 0.0;           // of a frame
  double mean_square = 0.0;  // error, of values 0..1
};

// Whether a is nowhere worse than b and somewhere better.
bool dominates(const Offer& a, const Offer& b);

// The Pareto front: those that no other dominates, by number, from the cheapest to the most accurate; of equal ones the
// first.
std::vector<std::size_t> front_of(const std::vector<Offer>& offers);

// Those that may be on the front though their times are only estimates, and are worth being there: none that is faster
// by the part `off` of their time is as accurate but for the part `slight` of their mean square error.
std::vector<std::size_t> nearly_on_front(const std::vector<Offer>& offers, double off, double slight);

// The front with so much between neighbours that it is noticed: each takes at least so many times as long as the one
// before. Both of its ends stay. front: as front_of gives it.
std::vector<std::size_t> thinned(const std::vector<Offer>& offers, const std::vector<std::size_t>& front, double step);

}  // namespace terrella
