#include "native/cmd_measure.hpp"

#include <memory>
#include <optional>

#include "base/file.hpp"
#include "base/text.hpp"
#include "native/failures.hpp"
#include "native/measure_extremes.hpp"
#include "native/measure_trade.hpp"
#include "native/options.hpp"

namespace terrella {
namespace {

struct MeasureOptions {
  SceneOptions scene;
  std::string out;
  bool extremes = false;
  bool quick = false;
  bool path = false;
  std::optional<std::string> size, gl, against;
};

// What belongs to the trade alone.
void refuse_for_extremes(const MeasureOptions& options, Issues& issues) {
  const SceneOptions& scene = options.scene;
  if (scene.preset || scene.scene_file || scene.link || scene.quality || !scene.settings.empty())
    issues.add("--extremes", "draws scenes of its own; leave out --preset, --scene, --link, --quality and --set.");
  const auto refuse = [&](bool given, const char* option) {
    if (given) issues.add(option, "is for the trade of speed for accuracy; --extremes has none of it.");
  };
  refuse(options.size.has_value(), "--size");
  refuse(options.gl.has_value(), "--gl");
  refuse(options.against.has_value(), "--against");
  refuse(options.path, "--path");
}

void read_old(const std::string& path, TradeTask& task, Issues& issues) {
  constexpr std::size_t longest = 50'000'000;  // bytes
  const Result<std::string> text = read_file(path, longest);
  if (!text) return issues.add("--against", text.sentence());
  const Result<TradeSummary> before = read_trade(*text);
  if (!before) return issues.add(path, before.sentence());
  const std::string why_not = why_not_comparable(*before, to_be_measured(task.document, task.plan));
  if (!why_not.empty()) return issues.add(path, why_not);
  task.against = path;
  task.before = *before;
}

TradeTask understand(const MeasureOptions& options, Issues& issues) {
  constexpr int largest = 4096;
  TradeTask task;
  const SceneChoice choice = choose_scene(options.scene);
  issues.add(choice.issues);
  task.document = choice.document;
  task.plan = trade_plan(options.quick);
  task.plan.path_only = options.path;
  task.folder = options.out;
  if (options.size) read_size(*options.size, task.plan.width, task.plan.height, largest, issues);
  if (options.gl) check_gl(*options.gl, issues);
  task.api = options.gl == "es" ? Api::es : Api::core;
  if (options.against) read_old(*options.against, task, issues);
  return task;
}

// Returns the exit code.
int measure(const MeasureOptions& options) {
  Issues issues;
  std::optional<TradeTask> task;
  if (options.extremes) {
    refuse_for_extremes(options, issues);
  } else {
    task = understand(options, issues);
  }
  if (!issues.empty()) return report_bad_input(issues);
  const std::string failure = task ? measure_trade(*task) : measure_extremes(options.out, options.quick);
  return failure.empty() ? 0 : report_failure(failure);
}

}  // namespace

void add_measure_command(CLI::App& program, int& exit_code) {
  CLI::App* command = program.add_subcommand("measure", "What accuracy costs, or what holds at the extremes");
  const auto options = std::make_shared<MeasureOptions>();
  add_scene_options(*command, options->scene);
  command->add_option("--out", options->out, "The folder for report.json and index.html")->required();
  command->add_option("--size", options->size, "Pixels of the pictures, WIDTHxHEIGHT (480x270; 160x90 if quick)");
  command->add_option("--against", options->against, "An older report.json: tells what is slower or less accurate");
  command->add_option("--gl", options->gl, "core or es (core)");
  command->add_flag("--extremes", options->extremes,
                    "Drive the renderer to the ends of every parameter, view and size instead");
  command->add_flag("--path", options->path, "Measure only the steps that hold quality.target_ms, with this scene");
  command->add_flag("--quick", options->quick, "Small pictures, few settings and rounds: under a minute");
  command->callback([options, &exit_code] { exit_code = measure(*options); });
}

}  // namespace terrella
