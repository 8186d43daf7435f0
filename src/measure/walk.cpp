#include "measure/walk.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "measure/image_error.hpp"

namespace terrella {
namespace {

// dB for each ms more; what gains nothing is worth the less the longer it takes.
double worth(const Offer& from, const Offer& to) {
  const double least = 0.02 * from.ms;  // no time can be told better
  const double gain = psnr_of(to.mean_square) - psnr_of(from.mean_square);
  const double longer = std::max(to.ms - from.ms, least);
  return gain > 0.0 ? gain / longer : gain - longer;
}

class Way {
 public:
  Way(const std::vector<int>& counts, const std::function<Offer(const Levels&)>& measure)
      : counts_(counts), measure_(measure), at_(counts.size(), 0), promises_(counts.size()) {
    here_ = measure_(at_);
  }

  [[nodiscard]] const Levels& at() const { return at_; }

  // Returns whether there was a step left.
  bool step() {
    ++steps_;
    std::optional<std::size_t> best;
    Offer there;
    for (const std::size_t knob : worth_trying()) {
      const Offer offer = measure_(raised(knob));
      promises_[knob] = {worth(here_, offer), steps_};
      if (best && promises_[knob].worth <= promises_[*best].worth) continue;
      best = knob;
      there = offer;
    }
    if (!best) return false;
    at_ = raised(*best);
    here_ = there;
    promises_[*best] = {};
    return true;
  }

 private:
  struct Promise {
    double worth = std::numeric_limits<double>::infinity();  // as long as nothing is known
    int step = 0;                                            // at which it was last tried
  };

  [[nodiscard]] Levels raised(std::size_t knob) const {
    Levels levels = at_;
    ++levels[knob];
    return levels;
  }

  [[nodiscard]] std::vector<std::size_t> worth_trying() const {
    std::vector<std::size_t> open, untried;
    for (std::size_t k = 0; k < counts_.size(); ++k) {
      if (at_[k] + 1 < counts_[k]) (std::isinf(promises_[k].worth) ? untried : open).push_back(k);
    }
    std::sort(open.begin(), open.end(),
              [&](std::size_t a, std::size_t b) { return promises_[a].worth > promises_[b].worth; });
    constexpr std::size_t best = 2;
    if (open.size() > best) {
      const auto oldest = std::min_element(open.begin() + best, open.end(), [&](std::size_t a, std::size_t b) {
        return promises_[a].step < promises_[b].step;
      });
      std::iter_swap(open.begin() + best, oldest);
      open.resize(best + 1);
    }
    open.insert(open.end(), untried.begin(), untried.end());
    return open;
  }

  const std::vector<int>& counts_;
  const std::function<Offer(const Levels&)>& measure_;
  Levels at_;
  Offer here_;
  std::vector<Promise> promises_;
  int steps_ = 0;
};

}  // namespace

std::vector<Levels> walk_up(const std::vector<int>& counts, const std::function<Offer(const Levels&)>& measure) {
  Way way(counts, measure);
  std::vector<Levels> levels = {way.at()};
  while (way.step()) levels.push_back(way.at());
  return levels;
}

}  // namespace terrella
