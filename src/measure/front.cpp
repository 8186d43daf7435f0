#include "measure/front.hpp"

#include <algorithm>
#include <numeric>

namespace terrella {

bool dominates(const Offer& a, const Offer& b) {
  return a.ms <= b.ms && a.mean_square <= b.mean_square && (a.ms < b.ms || a.mean_square < b.mean_square);
}

std::vector<std::size_t> front_of(const std::vector<Offer>& offers) {
  std::vector<std::size_t> order(offers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return offers[a].ms != offers[b].ms ? offers[a].ms < offers[b].ms : offers[a].mean_square < offers[b].mean_square;
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (front.empty() || offers[i].mean_square < offers[front.back()].mean_square) front.push_back(i);
  }
  return front;
}

std::vector<std::size_t> nearly_on_front(const std::vector<Offer>& offers, double off, double slight) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < offers.size(); ++i) {
    const auto is_better = [&](const Offer& other) {
      return other.ms <= (1.0 - off) * offers[i].ms && other.mean_square <= (1.0 + slight) * offers[i].mean_square;
    };
    if (std::none_of(offers.begin(), offers.end(), is_better)) kept.push_back(i);
  }
  return kept;
}

std::vector<std::size_t> thinned(const std::vector<Offer>& offers, const std::vector<std::size_t>& front, double step) {
  if (front.empty()) return {};
  std::vector<std::size_t> kept = {front.back()};
  for (auto i = front.rbegin(); i != front.rend(); ++i) {
    if (offers[*i].ms * step <= offers[kept.back()].ms) kept.push_back(*i);
  }
  if (kept.back() != front.front()) {
    if (kept.size() > 1) kept.pop_back();
    kept.push_back(front.front());
  }
  std::reverse(kept.begin(), kept.end());
  return kept;
}

}  // namespace terrella
