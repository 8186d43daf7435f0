#include <cstdio>

#include <CLI/CLI.hpp>

#include "native/cmd_keys.hpp"
#include "native/cmd_manual.hpp"
#include "native/cmd_measure.hpp"
#include "native/cmd_presets.hpp"
#include "native/cmd_probe.hpp"
#include "native/cmd_render.hpp"
#include "native/cmd_view.hpp"

int main(int count, char** arguments) {
  CLI::App program("Terrella: procedural planets", "terrella");
  program.require_subcommand(1);
  int exit_code = 0;
  terrella::add_view_command(program, exit_code);
  terrella::add_render_command(program, exit_code);
  terrella::add_measure_command(program, exit_code);
  terrella::add_manual_command(program);
  terrella::add_presets_command(program);
  terrella::add_keys_command(program);
  terrella::add_probe_command(program, exit_code);
  try {
    program.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    const int code = program.exit(error);
    return code == 0 ? 0 : 2;
  }
  return exit_code;
}
