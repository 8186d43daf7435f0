#include "native/cmd_measure.hpp"

#include <functional>
#include <memory>
#include <optional>

#include "base/file.hpp"
#include "base/text.hpp"
#include "measure/ground_models.hpp"
#include "native/failures.hpp"
#include "native/measure_extremes.hpp"
#include "native/measure_ground.hpp"
#include "native/measure_trade.hpp"
#include "native/options.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

struct MeasureOptions {
  SceneOptions scene;
  std::string out;
  bool extremes = false;
  bool ground = false;
  bool flight = false;
  int frames = 0;
  bool quick = false;
  bool path = false;
  std::optional<std::string> size, gl, against;
};

bool names_a_scene(const SceneOptions& scene) {
  return scene.preset || scene.scene_file || scene.link || scene.quality || !scene.settings.empty();
}

// What belongs to other kinds of measuring.
void refuse_for_extremes(const MeasureOptions& options, Issues& issues) {
  if (names_a_scene(options.scene))
    issues.add("--extremes", "draws scenes of its own; leave out --preset, --scene, --link, --quality and --set.");
  const auto refuse = [&](bool given, const char* option) {
    if (given) issues.add(option, "is for the trade of speed for accuracy; --extremes has none of it.");
  };
  refuse(options.size.has_value(), "--size");
  refuse(options.gl.has_value(), "--gl");
  refuse(options.against.has_value(), "--against");
  refuse(options.path, "--path");
  if (options.frames != 0) issues.add("--frames", "is for --ground.");
  if (options.flight) issues.add("--flight", "is for --ground.");
  if (options.ground) issues.add("--ground", "is measured by itself; leave out --extremes.");
}

void refuse_for_ground(const MeasureOptions& options, Issues& issues) {
  const auto refuse = [&](bool given, const char* option) {
    if (given) issues.add(option, "is for the trade of speed for accuracy; --ground has none of it.");
  };
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

// What is measured of pictures, whatever is measured of them.
template <class Task>
void read_pictures(const MeasureOptions& options, Task& task, Issues& issues) {
  constexpr int largest = 4096;
  task.folder = options.out;
  if (options.size) read_size(*options.size, task.plan.width, task.plan.height, largest, issues);
  if (options.gl) check_gl(*options.gl, issues);
  task.api = options.gl == "es" ? Api::es : Api::core;
}

// The scene that is named, or those presets that show grounds of all kinds.
std::vector<SceneDocument> grounds(const MeasureOptions& options, Issues& issues) {
  std::vector<SceneDocument> documents;
  if (!names_a_scene(options.scene)) {
    for (const char* const name : {"blue", "highlands", "giant"}) documents.push_back({find_preset(name)->scene, name});
    return documents;
  }
  const SceneChoice choice = choose_scene(options.scene);
  issues.add(choice.issues);
  if (!has_nodes(ground_technique(choice.document.scene)))
    issues.add("--ground", "is for planets of real size; there are blue, highlands and giant.");
  return {choice.document};
}

GroundTask understand_ground(const MeasureOptions& options, Issues& issues) {
  GroundTask task;
  refuse_for_ground(options, issues);
  task.documents = grounds(options, issues);
  task.plan = ground_plan(options.quick);
  if (options.frames < 0 || options.frames > 1000) issues.add("--frames", "must be a whole number, 0 to 1000.");
  if (options.flight && options.frames != 0) issues.add("--flight", "draws nothing; leave out --frames.");
  task.plan.frames = options.frames;
  if (options.flight) task.plan.flown = options.quick ? 60 : 600;  // 20 s of 30 a second
  read_pictures(options, task, issues);
  return task;
}

TradeTask understand_trade(const MeasureOptions& options, Issues& issues) {
  TradeTask task;
  const SceneChoice choice = choose_scene(options.scene);
  issues.add(choice.issues);
  task.document = choice.document;
  task.plan = trade_plan(options.quick);
  task.plan.path_only = options.path;
  read_pictures(options, task, issues);
  if (options.frames != 0) issues.add("--frames", "is for --ground.");
  if (options.flight) issues.add("--flight", "is for --ground.");
  if (options.against) read_old(*options.against, task, issues);
  return task;
}

// Has what is asked for measured once it is understood; returns the exit code.
int measure(const MeasureOptions& options) {
  Issues issues;
  std::function<std::string()> work;
  if (options.extremes) {
    refuse_for_extremes(options, issues);
    work = [&] { return measure_extremes(options.out, options.quick); };
  } else if (options.ground) {
    work = [task = understand_ground(options, issues)] { return measure_ground(task); };
  } else {
    work = [task = understand_trade(options, issues)] { return measure_trade(task); };
  }
  if (!issues.empty()) return report_bad_input(issues);
  const std::string failure = work();
  return failure.empty() ? 0 : report_failure(failure);
}

}  // namespace

void add_measure_command(CLI::App& program, int& exit_code) {
  CLI::App* command = program.add_subcommand(
      "measure", "What accuracy costs, what holds at the extremes, or what a ground of real size costs");
  const auto options = std::make_shared<MeasureOptions>();
  add_scene_options(*command, options->scene);
  command->add_option("--out", options->out, "The folder for report.json and index.html")->required();
  command->add_option(
      "--size", options->size,
      "Pixels of the pictures, WIDTHxHEIGHT (480x270, 160x90 if quick; of --ground 1920x1080, 480x270)");
  command->add_option("--against", options->against, "An older report.json: tells what is slower or less accurate");
  command->add_option("--gl", options->gl, "core or es (core)");
  command->add_flag("--extremes", options->extremes,
                    "Drive the renderer to the ends of every parameter, view and size instead");
  command->add_flag("--ground", options->ground,
                    "Measure instead what a ground of real size costs for the same error, from eye level to far away");
  command->add_option("--frames", options->frames, "With --ground: how many frames of each view to draw and time (0)");
  command->add_flag("--flight", options->flight,
                    "With --ground: time what the CPU does in a flight from orbit to the ground instead");
  command->add_flag("--path", options->path, "Measure only the steps that hold quality.target_ms, with this scene");
  command->add_flag("--quick", options->quick, "Small pictures, few settings and rounds: under a minute");
  command->callback([options, &exit_code] { exit_code = measure(*options); });
}

}  // namespace terrella
