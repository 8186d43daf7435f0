#include "app/slices.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace terrella {
namespace {

// What a band is meant to take: what a screen of 60 pictures a second waits for the next; less would wait for it.
constexpr double band_ms = 17.0;
constexpr double slow_ms = 25.0;       // a picture that takes longer is drawn in bands,
constexpr double quick_ms = 18.0;      // one that takes less no more
constexpr double shortest_ms = 10.0;   // a band may take so little
constexpr double longest_ms = 24.0;    // or so much before their number changes
constexpr double uneven = 1.3;         // the dearest band may cost so many times the mean before borders move,
constexpr double worth_moving = 0.85;  // if that lowers its cost to this part
// Screens that show few pictures a second make each come late; to ask what it takes costs a little.
constexpr int late_in_a_row = 3, pictures_of_trust = 100;

}  // namespace

Slices::Band Slices::band(int i) const {
  const auto at = static_cast<std::size_t>(i);
  return {borders_.at(at), borders_.at(at + 1)};
}

double Slices::cost(const Band& band) const {
  return std::accumulate(costs_.begin() + band.first, costs_.begin() + band.end, 0.0);
}

void Slices::whole_came_after(double ms) {
  slow_ = ms > slow_ms ? slow_ + 1 : 0;
  time_to_trust_ = std::max(0, time_to_trust_ - 1);
}

bool Slices::wants_time_of(int i) const {
  if (count_ == 1) return slow_ >= late_in_a_row && time_to_trust_ == 0;
  return !known_.test(static_cast<std::size_t>(i)) || i == next_to_time_;
}

void Slices::took(int i, double ms) {
  const Band band = this->band(i);
  const auto first = costs_.begin() + band.first, end = costs_.begin() + band.end;
  const double before = cost(band);
  if (before <= 0.0 || count_ == 1) {
    std::fill(first, end, ms / (band.end - band.first));
  } else {
    // What a machine does beside may double the time of one band; it is not to move all the others.
    const double factor = 0.5 + 0.5 * std::min(ms / before, 2.0);
    std::for_each(first, end, [&](double& strip) { strip *= factor; });
  }
  known_.set(static_cast<std::size_t>(i));
}

void Slices::decide() {
  if (known_.none()) return;
  next_to_time_ = (next_to_time_ + 1) % count_;
  const double all = cost({0, strips}), each = all / count_;
  const int wanted = std::clamp(static_cast<int>(std::lround(all / band_ms)), 2, most);
  if (count_ == 1) {
    time_to_trust_ = pictures_of_trust;
    known_.reset();
    if (all > slow_ms) part_anew(wanted);
  } else if (all < quick_ms) {
    part_anew(1);
  } else if ((each < shortest_ms || each > longest_ms) && wanted != count_) {
    part_anew(wanted);
  } else if (known_.count() == static_cast<std::size_t>(count_) && dearest() > uneven * each) {
    Slices moved = *this;
    moved.part_anew(count_);
    if (moved.dearest() < worth_moving * dearest()) *this = moved;
  }
}

double Slices::dearest() const {
  double most_of_all = 0.0;
  for (int i = 0; i < count_; ++i) most_of_all = std::max(most_of_all, cost(band(i)));
  return most_of_all;
}

// Bands that cost the same, as far as is known; each has a strip at the least.
void Slices::part_anew(int count) {
  count_ = count;
  known_.reset();
  next_to_time_ = slow_ = 0;
  const double all = cost({0, strips});
  double below = 0.0;
  int border = 0;
  for (int i = 1; i < count; ++i) {
    const int first = border + 1, last = strips - (count - i);
    do below += costs_.at(static_cast<std::size_t>(border++));
    while (border < last && below + 0.5 * costs_.at(static_cast<std::size_t>(border)) < all * i / count);
    borders_.at(static_cast<std::size_t>(i)) = std::max(first, border);
  }
  borders_.at(static_cast<std::size_t>(count)) = strips;
}

}  // namespace terrella
