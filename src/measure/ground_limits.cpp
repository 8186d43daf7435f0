#include "measure/ground_limits.hpp"

#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "measure/words.hpp"

namespace terrella {
namespace {

struct TriangleLimit {
  double target;  // px
  std::int64_t most;
};

constexpr std::array of_each = {TriangleLimit{1.0, 200'000}};
constexpr std::array of_best = {TriangleLimit{1.0, 50'000}, TriangleLimit{2.0, 13'000}};
constexpr double most_ms = 1.0;

std::string view_in_words(const GroundRow& row) {
  return text_of(row.scene, " from ", figure(row.altitude), " m at ", figure(row.target), " px");
}

// Those that every model is to draw.
bool same_view(const GroundRow& a, const GroundRow& b) {
  return a.scene == b.scene && a.altitude == b.altitude && a.target == b.target;
}

}  // namespace

double cpu_ms(const GroundRow& row) { return row.measured.look_ms + row.measured.choose_ms; }

std::vector<std::string> broken_by(const GroundRow& row) {
  std::vector<std::string> broken;
  const auto say = [&](const auto&... what) {
    broken.push_back(text_of(row.model, ", ", view_in_words(row), ": ", what..., "."));
  };
  if (row.measured.places == 0) say("no ground is seen");
  if (!row.reaches_target()) say("99 of 100 places are off by ", figure(row.measured.seen.p99), " px");
  if (row.measured.lacking > 0) say("no room for ", row.measured.lacking, " nodes");
  if (cpu_ms(row) > most_ms) say(figure(cpu_ms(row)), " ms to choose nodes, more than ", figure(most_ms));
  if (row.measured.allocations > 0) say(row.measured.allocations, " allocations to choose nodes");
  for (const TriangleLimit& limit : of_each) {
    if (row.target == limit.target && row.measured.seen_triangles > limit.most)
      say(row.measured.seen_triangles, " visible triangles, more than ", limit.most);
  }
  return broken;
}

std::vector<std::string> broken_limits(const GroundTable& table) {
  std::vector<std::string> broken;
  for (auto row = table.rows.begin(); row != table.rows.end(); ++row) {
    for (std::string& sentence : broken_by(*row)) broken.push_back(std::move(sentence));
    const auto is_same = [&](const GroundRow& other) { return same_view(*row, other); };
    if (std::any_of(table.rows.begin(), row, is_same)) continue;
    std::int64_t fewest = row->measured.seen_triangles;
    for (const GroundRow& other : table.rows) {
      if (is_same(other)) fewest = std::min(fewest, other.measured.seen_triangles);
    }
    for (const TriangleLimit& limit : of_best) {
      if (row->target == limit.target && fewest > limit.most)
        broken.push_back(text_of("The best of all models, ", view_in_words(*row), ": ", fewest,
                                 " visible triangles, more than ", limit.most, "."));
    }
  }
  return broken;
}

}  // namespace terrella
