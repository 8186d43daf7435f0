#include "native/cmd_render.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/stats.hpp"
#include "base/file.hpp"
#include "base/milliseconds.hpp"
#include "gl/caps.hpp"
#include "native/egl_context.hpp"
#include "native/failures.hpp"
#include "native/options.hpp"
#include "native/picture.hpp"
#include "native/progress_bar.hpp"
#include "native/render_path.hpp"
#include "planet/validity.hpp"

namespace terrella {
namespace {

struct RenderOptions {
  SceneOptions scene;
  std::string size = "1280x720";
  double time = 0.0;
  std::string out;
  std::string channel = "color";
  int samples = 1;
  bool reference = false;
  bool transparent = false;
  std::optional<std::string> path;
  std::optional<double> seconds;
  int frames = 0;
  bool why = false;
  std::string stats;
  std::string gl = "core";
};

bool ends_with(const std::string& text, std::string_view end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void read_channel(const std::string& text, PictureTask& task, Issues& issues) {
  const auto found = std::find(channel_names.begin(), channel_names.end(), text);
  if (found != channel_names.end()) {
    task.channel = static_cast<Channel>(found - channel_names.begin());
    return;
  }
  issues.add("--channel",
             text_of(json_quoted(shortened(text)), " is not a channel; there are color, distance, normal and height",
                     did_you_mean(nearest_name(text, channel_names))));
}

// What belongs to drawing by the GPU alone.
void refuse_for_reference(const RenderOptions& options, Issues& issues) {
  const auto refuse = [&](bool given, const char* option) {
    if (given) issues.add(option, "is for pictures that the GPU draws, and --reference asks for none of them.");
  };
  refuse(options.transparent, "--transparent");
  refuse(options.frames > 0 && !options.path, "--frames");
  refuse(options.why, "--why");
}

// What belongs to a single picture, or to a path alone.
void refuse_for_path(const RenderOptions& options, Issues& issues) {
  const auto refuse = [&](bool given, const char* option) {
    if (given) issues.add(option, "is for a single picture; leave it out, or leave out --path.");
  };
  if (options.path) {
    refuse(options.why, "--why");
    refuse(!options.stats.empty(), "--stats");
  } else if (options.seconds) {
    issues.add("--seconds", "is how long the flight along a path takes; give --path as well.");
  }
}

PictureTask understand(const RenderOptions& options, Issues& issues) {
  PictureTask task;
  const SceneChoice choice = choose_scene(options.scene);
  issues.add(choice.issues);
  task.scene = choice.document.scene;
  read_size(options.size, task.still.width, task.still.height, 16384, issues);
  read_channel(options.channel, task, issues);
  task.still.seconds = options.time;
  task.still.samples = options.samples;
  task.still.transparent = options.transparent;
  if (!std::isfinite(options.time) || std::abs(options.time) > 1e12) {
    issues.add("--time", "must be a number of seconds, -1e12 to 1e12.");
  }
  if (options.samples < 1 || options.samples > 64) issues.add("--samples", "must be a whole number, 1 to 64.");
  if (!options.path && (options.frames < 0 || options.frames > 1'000'000))
    issues.add("--frames", "must be a whole number, 0 to 1000000.");
  check_gl(options.gl, issues);
  task.pfm = ends_with(options.out, ".pfm");
  if (!task.pfm && !ends_with(options.out, ".png")) {
    issues.add("--out", text_of(json_quoted(shortened(options.out)), " must end in .png or .pfm."));
  } else if (!task.pfm && task.channel != Channel::color) {
    issues.add("--out", text_of("the channel ", options.channel, " is not a picture; give a file that ends in .pfm."));
  }
  if (options.reference) refuse_for_reference(options, issues);
  refuse_for_path(options, issues);
  if (task.pfm && options.transparent) issues.add("--transparent", "is for pictures; give a file that ends in .png.");
  return task;
}

// Frames as a window would draw them, each timed until its picture is there.
std::vector<double> time_frames(Renderer& renderer, const PictureTask& task, int count) {
  std::vector<double> times;
  View view;
  view.width = task.still.width;
  view.height = task.still.height;
  for (int i = 0; i < count; ++i) {
    const auto start = std::chrono::steady_clock::now();
    view.seconds = task.still.seconds + i / 60.0;
    renderer.draw(task.scene, view, {Channel::color, i == 0 ? Effort::complete : Effort::live, false});
    renderer.wait();
    if (i > 0) times.push_back(milliseconds_since(start));
  }
  return times;
}

std::int64_t count_nonfinite(const Image& image, Channel channel) {
  std::int64_t count = 0;
  for (const float value : image.pixels) {
    const bool sky = std::isinf(value) && value > 0.0F && channel != Channel::color && channel != Channel::normal;
    if (!std::isfinite(value) && !sky) ++count;
  }
  return count;
}

void print_needs(const Needs& needs) {
  for (const Decision& d : needs.decisions) {
    std::printf("%-22s %-10s %s\n", d.what.c_str(), d.chosen.c_str(), d.why.c_str());
  }
}

std::vector<std::string> beyond_range(const Renderer& renderer, const PictureTask& task) {
  View view;
  view.width = task.still.width;
  view.height = task.still.height;
  view.seconds = task.still.seconds;
  std::vector<std::string> sentences;
  for (const Issue& issue : beyond_validity(task.scene, view, renderer.pose(), renderer.needs())) {
    sentences.push_back(issue.text());
  }
  return sentences;
}

std::string write_image(const RenderOptions& options, const PictureTask& task, const Image& image) {
  const Result<Done> done = write_file_whole(options.out, encoded(task, image));
  return done ? std::string() : done.sentence();
}

std::string write_stats(const RenderOptions& options, const PictureTask& task, StatsReport& report) {
  if (options.stats.empty()) return {};
  report.width = task.still.width;
  report.height = task.still.height;
  report.frames = 1 + options.frames;
  const Result<Done> done = write_file_whole(options.stats, to_json(report) + "\n");
  return done ? std::string() : done.sentence();
}

// Draws and writes; returns what went wrong, or nothing.
std::string render_reference(const RenderOptions& options, const PictureTask& task) {
  const auto start = std::chrono::steady_clock::now();
  const Image image = picture_by_reference(task, [](double part) { show_progress("drawing", part); });
  StatsReport report;
  report.renderer = "reference";
  report.first_frame_ms = milliseconds_since(start);
  report.nonfinite_pixels = count_nonfinite(image, task.channel);
  const std::string failure = write_image(options, task, image);
  return failure.empty() ? write_stats(options, task, report) : failure;
}

std::string render(const RenderOptions& options, const PictureTask& task) {
  const auto start = std::chrono::steady_clock::now();
  const auto context = EglContext::make(options.gl == "es" ? Api::es : Api::core);
  if (!context) return context.sentence();
  if (std::string why = why_too_large(task); !why.empty()) return why;
  Renderer renderer;
  const Image image = picture_by_gpu(renderer, task);
  StatsReport report;
  report.first_frame_ms = milliseconds_since(start);
  report.nonfinite_pixels = count_nonfinite(image, task.channel);
  report.work = renderer.stats();
  if (const std::string failure = write_image(options, task, image); !failure.empty()) return failure;
  if (options.why) print_needs(renderer.needs());
  if (options.frames > 0) {
    report.frame_ms = time_frames(renderer, task, options.frames + 1);
    report.work = renderer.stats();
  }
  report.renderer = gl::renderer_name();
  report.needs = renderer.needs();
  report.issues = beyond_range(renderer, task);
  return write_stats(options, task, report);
}

// Returns the exit code.
int render_single(const RenderOptions& options, const PictureTask& task) {
  const std::string failure = options.reference ? render_reference(options, task) : render(options, task);
  return failure.empty() ? 0 : report_failure(failure);
}

int run(const RenderOptions& options) {
  Issues issues;
  const PictureTask task = understand(options, issues);
  std::optional<PathTask> path;
  if (options.path) {
    path = understand_path({*options.path, options.seconds, options.frames, options.out, options.reference, options.gl},
                           task, issues);
  }
  if (!issues.empty()) return report_bad_input(issues);
  return path ? render_path(*path) : render_single(options, task);
}

}  // namespace

void add_render_command(CLI::App& program, int& exit_code) {
  CLI::App* command = program.add_subcommand("render", "One picture, no window and no display needed");
  const auto options = std::make_shared<RenderOptions>();
  add_scene_options(*command, options->scene);
  command->add_option("--size", options->size, "Pixels, WIDTHxHEIGHT (1280x720)");
  command->add_option("--time", options->time, "Seconds since the scene began, of a path's first picture (0)");
  command
      ->add_option("--out", options->out,
                   "The picture: .png, or .pfm for linear light and measurements; of a path NAME.png")
      ->required();
  command->add_option("--channel", options->channel, "color, distance, normal or height (color)");
  command->add_option("--samples", options->samples, "N for N x N samples a pixel (1)");
  command->add_flag("--reference", options->reference, "Draw by the double-precision reference, on the CPU");
  command->add_flag("--transparent", options->transparent, "The planet alone, with opacity, for laying over anything");
  command->add_option("--path", options->path, "Fly through the views of a file; writes NAME-0001.png and so on")
      ->type_name("FILE.json");
  command->add_option("--seconds", options->seconds, "How long the flight takes (as long as the path says)");
  command->add_option("--frames", options->frames,
                      "With --path: how many pictures; else draw N frames more after warming up, to time them (0)");
  command->add_flag("--why", options->why, "Print what is modelled, how finely and for what reason");
  command->add_option("--stats", options->stats, "Write times, work and decisions as JSON");
  command->add_option("--gl", options->gl, "core or es (core)");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace terrella
