#include "native/cmd_manual.hpp"

#include <cstdio>
#include <memory>

#include "scene/manual.hpp"

namespace terrella {

void add_manual_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("manual", "Every parameter: path, type, default, range, unit, help");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "As JSON");
  command->callback([json] { std::fputs((*json ? manual_json() : manual_text()).c_str(), stdout); });
}

}  // namespace terrella
