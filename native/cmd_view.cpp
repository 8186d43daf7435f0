#include "native/cmd_view.hpp"

#include <memory>

#include "native/failures.hpp"
#include "native/options.hpp"
#include "native/window.hpp"

namespace terrella {

void add_view_command(CLI::App& program, int& exit_code) {
  CLI::App* command = program.add_subcommand("view", "A window with the planet and the panel");
  const auto options = std::make_shared<SceneOptions>();
  add_scene_options(*command, *options);
  command->callback([options, &exit_code] {
    const SceneChoice choice = choose_scene(*options);
    if (!choice.issues.empty()) {
      exit_code = report_bad_input(choice.issues);
      return;
    }
    const auto window = Window::open();
    if (window) {
      (*window)->run(choice.document);
    } else {
      exit_code = report_failure(window.sentence());
    }
  });
}

}  // namespace terrella
