#include "native/cmd_presets.hpp"

#include <cstdio>
#include <memory>

#include "scene/manual.hpp"

namespace terrella {

void add_presets_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("presets", "The presets, a line each");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "As JSON");
  command->callback([json] { std::fputs((*json ? presets_json() : presets_text()).c_str(), stdout); });
}

}  // namespace terrella
