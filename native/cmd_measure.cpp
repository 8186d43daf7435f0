#include "native/cmd_measure.hpp"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "base/file.hpp"
#include "gl/caps.hpp"
#include "measure/report.hpp"
#include "native/egl_context.hpp"
#include "native/failures.hpp"
#include "native/options.hpp"
#include "native/progress_bar.hpp"

namespace terrella {
namespace {

struct MeasureOptions {
  SceneOptions scene;
  std::string out;
  bool extremes = false;
  bool quick = false;
};

Issues understand(const MeasureOptions& options) {
  Issues issues;
  const SceneOptions& scene = options.scene;
  const bool has_scene = scene.preset || scene.scene_file || scene.link || !scene.settings.empty();
  if (!options.extremes) {
    issues.add("measure", "only the extremes can be measured so far; give --extremes.");
  } else if (has_scene) {
    issues.add("--extremes", "draws scenes of its own; leave out --preset, --scene, --link and --set.");
  }
  return issues;
}

// Adds what is found in one kind of context; returns what went wrong, or nothing.
std::string measure_in(Api api, ExtremesReport& report) {
  const auto context = EglContext::make(api);
  if (!context) return context.sentence();
  if (!gl::caps().full_float_targets)
    return "This machine's OpenGL cannot draw to 32 bit floats, which measuring needs.";
  const char* const name = api == Api::core ? "core" : "es";
  report.renderer = gl::caps().renderer;
  Renderer renderer;
  examine_all(
      renderer, name, report.extent, [&](double part) { show_progress(name, part); }, report);
  if (api == Api::core) {
    show_progress("where techniques hold", 0.0);
    report.limits = measure_limits(renderer, report.extent);
    report.invariances = measure_invariances(renderer, report.extent);
    show_progress("where techniques hold", 1.0);
  }
  return {};
}

std::string make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  return error ? text_of(folder, ": cannot be made: ", error.message(), ".") : std::string();
}

std::string write(const std::string& folder, const ExtremesReport& report) {
  for (const auto& [name, text] :
       {std::pair("report.json", extremes_json(report)), std::pair("index.html", extremes_page(report))}) {
    const Result<Done> done = write_file_whole((std::filesystem::path(folder) / name).string(), text);
    if (!done) return done.sentence();
  }
  return {};
}

// Measures and writes; returns what went wrong or does not hold, or nothing.
std::string measure(const MeasureOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  std::string failure = make_folder(options.out);  // before minutes of work
  ExtremesReport report;
  report.extent = options.quick ? Extent::quick : Extent::full;
  for (const Api api : {Api::core, Api::es}) {
    if (failure.empty()) failure = measure_in(api, report);
  }
  if (!failure.empty()) return failure;
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  failure = write(options.out, report);
  if (failure.empty() && !report.holds())
    failure = text_of("Not all holds at the extremes; ", options.out, "/index.html tells what.");
  return failure;
}

}  // namespace

void add_measure_command(CLI::App& program, int& exit_code) {
  CLI::App* command = program.add_subcommand("measure", "What holds at the ends of what can be asked for");
  const auto options = std::make_shared<MeasureOptions>();
  add_scene_options(*command, options->scene);
  command->add_option("--out", options->out, "The folder for report.json and index.html")->required();
  command->add_flag("--extremes", options->extremes,
                    "Drive the renderer to the ends of every parameter, view and size");
  command->add_flag("--quick", options->quick,
                    "Small pictures and coarse maps only: about a minute instead of three to five");
  command->callback([options, &exit_code] {
    const Issues issues = understand(*options);
    if (!issues.empty()) {
      exit_code = report_bad_input(issues);
      return;
    }
    const std::string failure = measure(*options);
    if (!failure.empty()) exit_code = report_failure(failure);
  });
}

}  // namespace terrella
