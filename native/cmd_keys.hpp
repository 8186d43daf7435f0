#pragma once

#include <CLI/CLI.hpp>

namespace terrella {

// Adds `terrella keys`, which prints on standard output.
void add_keys_command(CLI::App& program);

}  // namespace terrella
