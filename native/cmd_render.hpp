#pragma once

#include <CLI/CLI.hpp>

namespace terrella {

// Adds `terrella render [scene] --out FILE …`: one picture, without a window. Sets exit_code to 1 or 2 where it fails.
void add_render_command(CLI::App& program, int& exit_code);

}  // namespace terrella
