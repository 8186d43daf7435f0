#pragma once

#include <CLI/CLI.hpp>

namespace terrella {

// Adds `terrella manual [--json]`, which prints on standard output.
void add_manual_command(CLI::App& program);

}  // namespace terrella
