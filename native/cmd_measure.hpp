#pragma once

#include <CLI/CLI.hpp>

namespace terrella {

// Adds `terrella measure [scene] --out FOLDER …`: what accuracy costs, or, with --extremes, what holds at the ends of
// what can be asked for, as report.json and index.html. Sets exit_code to 1 where this machine could not, where
// something does not hold, or where it is worse than an older report; and to 2 for bad input.
void add_measure_command(CLI::App& program, int& exit_code);

}  // namespace terrella
