#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace terrella {

// What a log is told of a long work, where no terminal shows a bar: nothing of a work that is soon done, else a line
// for every tenth at most, and no two within a while of each other.
class ProgressLines {
 public:
  static constexpr double apart = 20.0;  // s

  // The line to write now, without its end, or nothing. what: a few words; another work begins with other words, or
  // where less is done than before. part: 0..1. seconds: of a clock that never goes back.
  std::optional<std::string> line(std::string_view what, double part, double seconds);

 private:
  std::string what_;
  double part_ = 1.0, said_at_ = 0.0;
  int tenths_ = 0;    // that have been told
  bool any_ = false;  // whether this work has been told of
};

}  // namespace terrella
