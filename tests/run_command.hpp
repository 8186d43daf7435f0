// A command of the program, run within the test.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include <CLI/CLI.hpp>

namespace terrella::test {

struct Outcome {
  int code;
  std::string said;  // on standard error
};

// add: adds the command to a program, as add_render_command does; line: what follows the program's name.
template <class Add>
Outcome run_command(const Add& add, const std::string& line) {
  CLI::App program;
  Outcome outcome{0, {}};
  add(program, outcome.code);
  testing::internal::CaptureStderr();
  program.parse(line);
  outcome.said = testing::internal::GetCapturedStderr();
  return outcome;
}

}  // namespace terrella::test
