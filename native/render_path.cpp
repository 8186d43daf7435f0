#include "native/render_path.hpp"

#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>

#include "base/file.hpp"
#include "base/text.hpp"
#include "native/egl_context.hpp"
#include "native/failures.hpp"
#include "native/picture_series.hpp"
#include "native/progress_bar.hpp"
#include "scene/json.hpp"
#include "scene/parameters.hpp"

namespace terrella {
namespace {

constexpr int most_frames = 1'000'000;
constexpr double longest = 1e9;  // s

std::string member(const std::string& name, const std::string& value) {
  return text_of("  ", json_quoted(name), ": ", value, ",\n");
}

std::string camera_json(const PathView& view) {
  Scene scene;
  scene.camera = view.camera;
  std::string json = "    {";
  for (const Parameter& parameter : parameters()) {
    if (parameter.group != "camera") continue;
    json += text_of(json_quoted(parameter.name), ": ", json_value(parameter.get(scene)), ", ");
  }
  return json + text_of("\"at\": ", view.at ? format_number(*view.at) : "null", "}");
}

// What may follow a sentence about the number of pictures.
std::string at_thirty_a_second(double seconds) {
  const double frames = std::round(30.0 * seconds) + 1.0;
  if (frames > most_frames) return {};
  return text_of("; it takes ", printed_number(seconds, 4), " s, in which ", frames, " are 30 a second");
}

// All that the pictures depend on, a member a line. The camera of the scene is where the first view has it from.
std::string about(const PathTask& task) {
  const PictureTask& picture = task.picture;
  std::string json = "{\n  \"terrella_series\": 1,\n";
  json += member("size", json_quoted(text_of(picture.still.width, 'x', picture.still.height)));
  json += member("frames", text_of(task.options.frames));
  json += member("seconds", format_number(task.seconds()));
  json += member("time", format_number(picture.still.seconds));
  json += member("samples", text_of(picture.still.samples));
  json += member("channel", json_quoted(channel_names.at(static_cast<std::size_t>(picture.channel))));
  json += member("transparent", text_of(picture.still.transparent));
  json += member("format", json_quoted(picture.pfm ? "pfm" : "png"));
  json += member("drawn_by", json_quoted(task.options.reference ? "reference" : task.options.gl));
  for (const Parameter& parameter : parameters()) {
    if (parameter.group != "camera")
      json += member(std::string(parameter.path), json_value(parameter.get(picture.scene)));
  }
  json += "  \"views\": [\n";
  for (const PathView& view : task.views) json += camera_json(view) + (&view == &task.views.back() ? "\n" : ",\n");
  return json + "  ]\n}\n";
}

// progress: may be told which part of the picture is done, 0..1.
using Draw = std::function<Image(const PictureTask&, const std::function<void(double)>& progress)>;

// Returns what went wrong, or nothing.
std::string draw_missing(const PathTask& task, const PictureSeries& series, const std::vector<int>& missing,
                         const Draw& draw) {
  for (std::size_t i = 0; i < missing.size(); ++i) {
    // All is done only when the last picture is written.
    const auto show = [&](double part) {
      if (part < 1.0) show_progress("drawing", (static_cast<double>(i) + part) / static_cast<double>(missing.size()));
    };
    show(0.0);
    const PictureTask picture = picture_of(task, missing[i]);
    const Result<Done> done = write_file_whole(series.file(missing[i]), encoded(picture, draw(picture, show)));
    if (!done) return done.sentence();
  }
  show_progress("drawing", 1.0);
  return {};
}

std::string draw_by_gpu(const PathTask& task, const PictureSeries& series, const std::vector<int>& missing) {
  const auto context = EglContext::make(task.options.gl == "es" ? Api::es : Api::core);
  if (!context) return context.sentence();
  if (std::string why = why_too_large(task.picture); !why.empty()) return why;
  Renderer renderer;
  return draw_missing(task, series, missing,
                      [&](const PictureTask& picture, const auto&) { return picture_by_gpu(renderer, picture); });
}

std::string draw_by_reference(const PathTask& task, const PictureSeries& series, const std::vector<int>& missing) {
  return draw_missing(task, series, missing, [](const PictureTask& picture, const auto& progress) {
    return picture_by_reference(picture, progress);
  });
}

std::vector<int> missing_of(const PathTask& task, const PictureSeries& series) {
  std::vector<int> missing;
  for (int i = 0; i < task.options.frames; ++i) {
    if (!series.has(i, task.picture)) missing.push_back(i);
  }
  return missing;
}

}  // namespace

std::optional<PathTask> understand_path(const PathOptions& options, const PictureTask& picture, Issues& issues) {
  Issues found;
  std::vector<PathView> views;
  if (const Result<std::string> text = read_file(options.file, kLongestJson); !text) {
    found.add("--path", text.sentence());
  } else {
    views = read_path(*text, picture.scene.camera, found);
  }
  if (options.seconds && !(*options.seconds > 0.0 && *options.seconds <= longest)) {
    found.add("--seconds", text_of("must be a number over 0, at most ", longest, "."));
  }
  std::optional<PathTask> task;
  if (found.empty()) task = PathTask{options, picture, views, Journey(picture.scene, views)};
  if (options.frames < 1 || options.frames > most_frames) {
    found.add("--frames", text_of("must say how many pictures of the path to draw, 1 to ", most_frames,
                                  task ? at_thirty_a_second(task->seconds()) : std::string(), "."));
  }
  issues.add(found);
  return found.empty() ? task : std::nullopt;
}

PictureTask picture_of(const PathTask& task, int index) {
  PictureTask picture = task.picture;
  const double part = index == 0 ? 0.0 : static_cast<double>(index) / (task.options.frames - 1);
  picture.scene.camera = task.journey.at(part * task.journey.seconds());
  picture.still.seconds += part * task.seconds() * task.picture.scene.time.speed;
  return picture;
}

int render_path(const PathTask& task) {
  const PictureSeries series(task.options.out, task.options.frames, about(task));
  if (const std::optional<Issue> issue = series.in_the_way()) {
    Issues issues;
    issues.add(*issue);
    return report_bad_input(issues);
  }
  if (const Result<Done> done = series.begin(); !done) return report_failure(done.sentence());
  const std::vector<int> missing = missing_of(task, series);
  const int there = task.options.frames - static_cast<int>(missing.size());
  if (there > 0) std::fprintf(stderr, "%d of %d pictures are there already.\n", there, task.options.frames);
  if (missing.empty()) return 0;
  const std::string failure =
      task.options.reference ? draw_by_reference(task, series, missing) : draw_by_gpu(task, series, missing);
  return failure.empty() ? 0 : report_failure(failure);
}

}  // namespace terrella
