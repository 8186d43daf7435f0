#include "base/issues.hpp"

#include <algorithm>
#include <array>

#include "base/text.hpp"

namespace terrella {
namespace {

constexpr std::size_t kLongestName = 64;

// Damerau's distance, each pair of letters swapped at most once. Row i of the table tells what the first i letters of a
// cost; three rows are enough at a time.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::array<std::array<std::size_t, kLongestName + 1>, 3> rows{};
  for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    auto& row = rows[i % 3];
    const auto& last = rows[(i + 2) % 3];
    const auto& before_last = rows[(i + 1) % 3];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return rows[a.size() % 3][b.size()];
}

}  // namespace

std::string Issue::text() const { return path.empty() ? sentence : text_of(path, ": ", sentence); }

void Issues::add(Issue issue) {
  ++count_;
  if (!full()) listed_.push_back(std::move(issue));
}

void Issues::add(const Issues& others) {
  for (const Issue& issue : others.listed_) add(issue);
  count_ += others.count_ - others.listed_.size();
}

std::vector<std::string> Issues::sentences() const {
  std::vector<std::string> texts;
  for (const Issue& issue : listed_) texts.push_back(issue.text());
  if (count_ > listed_.size()) texts.push_back(text_of("and ", count_ - listed_.size(), " more."));
  return texts;
}

std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates) {
  if (name.empty() || name.size() > kLongestName) return {};
  std::string_view nearest;
  std::size_t least = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const std::string_view candidate : candidates) {
    const std::size_t shorter = std::min(name.size(), candidate.size());
    const std::size_t longer = std::max(name.size(), candidate.size());
    if (longer > kLongestName || longer - shorter >= least) continue;
    const std::size_t distance = edit_distance(name, candidate);
    const bool shares_a_letter = distance < longer;
    if (distance < least && shares_a_letter) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string did_you_mean(std::string_view nearest) {
  return nearest.empty() ? "." : text_of("; did you mean ", nearest, "?");
}

}  // namespace terrella
