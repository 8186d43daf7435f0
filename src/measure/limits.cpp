#include "measure/limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace terrella {

bool Limit::keeps_its_word() const { return worst_within() <= demand; }

double Limit::worst_within() const {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  std::optional<double> worst;
  for (const LimitPoint& point : points) {
    if (point.warned) continue;
    worst = std::max(worst.value_or(0.0), std::isnan(point.error) ? unknown : point.error);
  }
  return worst.value_or(unknown);
}

bool Limit::ends() const {
  return std::any_of(points.begin(), points.end(), [&](const LimitPoint& p) { return p.warned && p.error > demand; });
}

std::vector<Limit> measure_limits(Renderer& renderer, Extent extent) {
  std::vector<Limit> limits;
  for (const auto measure : {limits_of_detail, limits_of_stillness, limits_of_time}) {
    for (Limit& limit : measure(renderer, extent)) limits.push_back(std::move(limit));
  }
  return limits;
}

}  // namespace terrella
