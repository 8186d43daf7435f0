#include "native/cmd_keys.hpp"

#include <cstdio>

#include "panel/keys.hpp"

namespace terrella {

void add_keys_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("keys", "What keys and mouse do in the window and on the page");
  command->callback([] { std::fputs(keys_text().c_str(), stdout); });
}

}  // namespace terrella
