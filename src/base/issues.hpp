#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace terrella {

// What is wrong with one thing that a user gave.
struct Issue {
  std::string path;      // the parameter, "waves.steepness"; empty where the whole input is meant
  std::string sentence;  // ends with its own full stop or question mark

  // "waves.steepness: 1.4 is out of range; allowed are 0 to 1."
  std::string text() const;
};

// The sentences for a user's bad input, in the order they were found. Only the first few are kept, so that hostile
// input costs neither memory nor the reader's patience; the others are counted.
class Issues {
 public:
  static constexpr std::size_t kMostListed = 20;

  void add(Issue issue);
  void add(std::string path, std::string sentence) { add(Issue{std::move(path), std::move(sentence)}); }
  void add(const Issues& others);
  // Counts one that nobody will read.
  void add_unlisted() { ++count_; }

  bool empty() const { return count_ == 0; }
  // Whether further ones will only be counted: no need to word them.
  bool full() const { return listed_.size() >= kMostListed; }
  std::size_t count() const { return count_; }
  std::span<const Issue> listed() const { return listed_; }

  // Each listed issue's text, then "and N more." if there were more.
  std::vector<std::string> sentences() const;

 private:
  std::vector<Issue> listed_;
  std::size_t count_ = 0;
};

// The candidate that a misspelt name most likely means: the one with the fewest letters to insert, remove, replace or
// swap; empty if none is near. Names longer than 64 bytes have none.
std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates);

// "; did you mean waves.count?" or, if nothing is near, ".": the end of a sentence about a name.
std::string did_you_mean(std::string_view nearest);

}  // namespace terrella
