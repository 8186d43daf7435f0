#pragma once

#include <CLI/CLI.hpp>

namespace terrella {

// Adds `terrella probe`, which answers the JSON lines of standard input on standard output, or tries all functions
// itself. exit_code becomes 1 where a bound is missed, 2 for bad options; it must outlive the parsing.
void add_probe_command(CLI::App& program, int& exit_code);

}  // namespace terrella
