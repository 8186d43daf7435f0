// `terrella render --path`: the pictures of a camera that flies through the views of a file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/issues.hpp"
#include "gl/api.hpp"
#include "native/picture.hpp"
#include "planet/journey.hpp"
#include "scene/camera_path.hpp"

namespace terrella {

struct PathOptions {
  std::string file;
  std::optional<double> seconds;
  int frames = 0;
  std::string out;
  bool reference = false;
  std::string gl;  // core or es
};

// The options, checked and understood.
struct PathTask {
  PathOptions options;
  PictureTask picture;  // but for the camera; its time is that of the first picture
  std::vector<PathView> views;
  Journey journey;

  // How long the pictures last, s of whoever looks at them.
  [[nodiscard]] double seconds() const { return options.seconds.value_or(journey.seconds()); }
};

// Reads the path. Nothing where there is an issue.
std::optional<PathTask> understand_path(const PathOptions& options, const PictureTask& picture, Issues& issues);

// The picture of an index from 0; the first shows the first view, the last the last one.
PictureTask picture_of(const PathTask& task, int index);

// Draws what is not there yet. Returns the exit code.
int render_path(const PathTask& task);

}  // namespace terrella
