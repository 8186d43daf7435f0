#pragma once

#include <CLI/CLI.hpp>

namespace terrella {

// Adds `terrella presets [--json]`, which prints on standard output.
void add_presets_command(CLI::App& program);

}  // namespace terrella
