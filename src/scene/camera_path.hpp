// A path of views, along which a camera flies, as a file tells it:
//   {"terrella_path": 1, "views": [{"altitude": 1e7}, {"latitude": 47, "longitude": 8, "altitude": 500, "at": 12}]}
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "base/issues.hpp"
#include "scene/scene.hpp"

namespace terrella {

// The version of the paths that this program reads.
inline constexpr int kPathVersion = 1;

// So many views a path has at most.
inline constexpr std::size_t kMostViews = 1000;

// From where a picture is taken; altitude in m over the sphere, angles in degrees.
using Camera = decltype(Scene::camera);

struct PathView {
  Camera camera;
  std::optional<double> at;  // s since the path began; rising from view to view, 0 for the first

  bool operator==(const PathView&) const = default;
};

// Reads a path's JSON. A view tells what differs from the one before, the first what differs from `start`; all are
// parameters of the group camera, by their names alone, and "at". "title" and "about" are passed over. Where there is
// an issue, what is read is no path to be flown.
std::vector<PathView> read_path(std::string_view text, const Camera& start, Issues& issues);

}  // namespace terrella
