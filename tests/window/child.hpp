// Another program, run by the tests.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace terrella::test {

class Child {
 public:
  struct Start {
    std::vector<std::string> command = {};      // the program first, found as a shell would
    std::vector<std::string> environment = {};  // "NAME=value" sets it, "NAME" takes it away
    std::string folder = ".";                   // to run in
    std::string complaints = {};                // the file that takes its stderr; empty: the tests' own
  };

  // Fails with a sentence if there is no such program.
  static Result<Child> start(const Start& start);
  // Ends it, if it has not ended.
  ~Child();
  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;

  // Its exit code once it has ended; 128 and more: by a signal, as shells tell it.
  std::optional<int> ended();

  // That it has computed so far, in all its threads; 0 once it has ended.
  [[nodiscard]] std::chrono::nanoseconds work() const;

 private:
  explicit Child(int process) : process_(process) {}

  int process_;  // 0: it has ended
  int code_ = 0;
};

}  // namespace terrella::test
