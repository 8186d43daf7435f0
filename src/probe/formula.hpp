// Functions of the probe's table that follow from what is declared of their arguments.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "probe/table.hpp"

namespace terrella::probe {

// A formula of the picture. Every argument has a range with two ends. Its numbers are those of the arguments as they
// come: a word as its place among the words, a whole number that stays with the host as its bits, a list of objects
// after its length.
//
// A triple within -1 to 1 is a unit vector where arguments are made up.
struct Formula {
  std::string_view name;
  std::vector<Arg> args;
  std::vector<Output> outputs;

  // The allowed error: what answers change by when each argument in turn is off by so many u of itself, a triple by so
  // many u of its length, and as many u of the answer and of what it is made from.
  double on_cpu = 4.0;
  double on_gpu = 4.0;

  // The size of what answers are made from, where that may be larger than they are.
  std::function<double(std::span<const double> numbers)> made_from = {};

  // Changes arguments that were made up one by one where they have to fit together.
  std::function<void(Json& args, Random& random)> fit = {};

  int rarity = 1;
};

Function function_of(Formula formula);

// An argument made up from all over its range, the ends among them.
Json made_up(const Arg& arg, Random& random);

}  // namespace terrella::probe
