#include "measure/covering.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <tuple>
#include <utility>

#include "base/check.hpp"

namespace terrella {
namespace {

constexpr int unset = -1;
constexpr int tries = 12;  // rows drawn for each that is kept

// Which pairs of values have not met yet.
class OpenPairs {
 public:
  explicit OpenPairs(std::span<const int> levels) : levels_(levels) {
    for (const int count : levels) {
      first_.push_back(size_);
      size_ += static_cast<std::size_t>(count);
    }
    open_.assign(size_ * size_, false);
    for (std::size_t f = 0; f < levels.size(); ++f) {
      for (std::size_t g = f + 1; g < levels.size(); ++g) {
        for (int a = 0; a < levels[f]; ++a) {
          for (int b = 0; b < levels[g]; ++b) set(f, a, g, b, true);
        }
      }
    }
  }

  [[nodiscard]] bool any() const { return count_ > 0; }
  [[nodiscard]] bool holds(std::size_t f, int a, std::size_t g, int b) const { return open_[at(f, a, g, b)]; }

  // How many open pairs a value has with those that a row has set already.
  [[nodiscard]] int gain(const std::vector<int>& row, std::size_t f, int value) const {
    int gained = 0;
    for (std::size_t g = 0; g < row.size(); ++g) {
      if (g != f && row[g] != unset && holds(f, value, g, row[g])) ++gained;
    }
    return gained;
  }

  [[nodiscard]] int gain(const std::vector<int>& row) const {
    int gained = 0;
    for (std::size_t f = 0; f < row.size(); ++f) gained += gain(row, f, row[f]);
    return gained / 2;
  }

  void close(const std::vector<int>& row) {
    for (std::size_t f = 0; f < row.size(); ++f) {
      for (std::size_t g = f + 1; g < row.size(); ++g) {
        if (holds(f, row[f], g, row[g])) set(f, row[f], g, row[g], false);
      }
    }
  }

  // The first one from a place on, as factors and values of a row that sets nothing else.
  [[nodiscard]] std::vector<int> row_of_one(std::size_t from) const {
    std::vector<int> row(levels_.size(), unset);
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const std::size_t place = (from + i) % open_.size();
      if (!open_[place]) continue;
      put(row, place / size_);
      put(row, place % size_);
      break;
    }
    return row;
  }

  [[nodiscard]] std::size_t places() const { return open_.size(); }

 private:
  [[nodiscard]] std::size_t at(std::size_t f, int a, std::size_t g, int b) const {
    return (first_[f] + static_cast<std::size_t>(a)) * size_ + first_[g] + static_cast<std::size_t>(b);
  }
  void set(std::size_t f, int a, std::size_t g, int b, bool open) {
    open_[at(f, a, g, b)] = open_[at(g, b, f, a)] = open;
    count_ += open ? 1 : -1;
  }
  void put(std::vector<int>& row, std::size_t value) const {
    const auto factor =
        static_cast<std::size_t>(std::upper_bound(first_.begin(), first_.end(), value) - 1 - first_.begin());
    row[factor] = static_cast<int>(value - first_[factor]);
  }

  std::span<const int> levels_;
  std::vector<std::size_t> first_;  // number of each factor's first value, all values counted through
  std::size_t size_ = 0;
  std::vector<bool> open_;
  std::int64_t count_ = 0;
};

std::size_t below(std::mt19937& random, std::size_t end) { return random() % end; }

// The standard's shuffle differs between its libraries.
void shuffle(std::vector<std::size_t>& order, std::mt19937& random) {
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[below(random, i)]);
}

std::vector<int> try_row(const OpenPairs& open, std::span<const int> levels, std::mt19937& random) {
  std::vector<int> row = open.row_of_one(below(random, open.places()));
  std::vector<std::size_t> order(levels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  shuffle(order, random);
  for (const std::size_t f : order) {
    if (row[f] != unset) continue;
    const auto count = static_cast<std::size_t>(levels[f]), start = below(random, count);
    int best = unset, most = -1;
    for (std::size_t i = 0; i < count; ++i) {
      const int value = static_cast<int>((start + i) % count);
      const int gained = open.gain(row, f, value);
      if (gained > most) std::tie(best, most) = std::pair(value, gained);
    }
    row[f] = best;
  }
  return row;
}

}  // namespace

std::vector<std::vector<int>> covering_pairs(std::span<const int> levels, unsigned seed) {
  for (const int count : levels) CHECK(count >= 1, "a factor of ", count, " values");
  std::mt19937 random(seed);
  OpenPairs open(levels);
  std::vector<std::vector<int>> rows;
  while (open.any()) {
    std::vector<int> best;
    int most = -1;
    for (int i = 0; i < tries; ++i) {
      std::vector<int> row = try_row(open, levels, random);
      const int gained = open.gain(row);
      if (gained > most) {
        most = gained;
        best = std::move(row);
      }
    }
    open.close(best);
    rows.push_back(std::move(best));
  }
  return rows;
}

}  // namespace terrella
