#pragma once

#include <CLI/CLI.hpp>

namespace terrella {

// Adds `terrella view [scene]`: a window with the planet and the panel. Sets exit_code to 1 or 2 where it fails.
void add_view_command(CLI::App& program, int& exit_code);

}  // namespace terrella
