#include "measure/quality_presets.hpp"

#include <algorithm>
#include <optional>

#include "measure/image_error.hpp"

namespace terrella {
namespace {

constexpr double times_cheaper = 1.6;

struct Wish {
  const char* name;
  double target;  // dB
};
constexpr Wish wishes[] = {{"high", 40.0}, {"balanced", 34.0}, {"fast", 28.0}};

using Front = std::vector<std::size_t>;

class Choice {
 public:
  Choice(const std::vector<Offer>& offers, const Front& front) : offers_(offers), front_(front) {}

  // The cheapest that reaches a target.
  [[nodiscard]] std::optional<std::size_t> reaching(double target) const {
    const auto reaches = [&](std::size_t i) { return psnr_of(offers_[i].mean_square) >= target; };
    const auto found = std::find_if(front_.begin(), front_.end(), reaches);
    return found == front_.end() ? std::nullopt : std::optional(*found);
  }

  // The most accurate of those that take from so long to so long, ms.
  [[nodiscard]] std::optional<std::size_t> between(double least, double most) const {
    std::optional<std::size_t> best;
    for (const std::size_t i : front_) {
      if (offers_[i].ms >= least && offers_[i].ms <= most) best = i;
    }
    return best;
  }

 private:
  const std::vector<Offer>& offers_;
  const Front& front_;
};

}  // namespace

std::vector<QualityPreset> quality_presets(const std::vector<Offer>& offers, const Front& front) {
  if (front.empty()) return {};
  const Choice choice(offers, front);
  double least = 0.0;  // ms that one which misses its target must take, so as not to displace one that does not
  for (const Wish& wish : wishes) {
    const auto reaching = choice.reaching(wish.target);
    if (reaching) least = std::max(least, times_cheaper * offers[*reaching].ms);
  }
  std::vector<QualityPreset> presets = {{"reference", front.back(), 0.0, true}};
  for (const Wish& wish : wishes) {
    const double most = offers[presets.back().setting].ms / times_cheaper;
    const std::optional<std::size_t> reaching = choice.reaching(wish.target);
    const std::optional<std::size_t> chosen = reaching ? reaching : choice.between(least, most);
    if (chosen && offers[*chosen].ms <= most)
      presets.push_back({wish.name, *chosen, wish.target, reaching.has_value()});
  }
  std::reverse(presets.begin(), presets.end());
  return presets;
}

}  // namespace terrella
