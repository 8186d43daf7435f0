#include "measure/trials.hpp"

#include <algorithm>
#include <cmath>

#include "measure/stability.hpp"
#include "planet/validity.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

bool warned(const Scene& scene, const View& view, const std::string& path) {
  const Pose pose = pose_of(scene, view);
  const std::vector<Issue> issues = beyond_validity(scene, view, pose, needs_of(scene, view, pose));
  return std::any_of(issues.begin(), issues.end(), [&](const Issue& issue) { return issue.path == path; });
}

}  // namespace

View small_view(double seconds) {
  View view;
  view.width = 96;
  view.height = 54;
  view.seconds = seconds;
  return view;
}

Scene usual(Scene scene) {
  make_cheap(scene);
  scene.quality.pixel_error = 0.75;
  scene.camera.latitude = 40.0;
  return scene;
}

Scene bare_sea() {
  Scene scene = usual({});
  scene.terrain.model = scene.clouds.model = no_model;
  scene.water.ice_latitude = 90.0;
  return scene;
}

Scene bare_ground(const char* preset) {
  Scene scene = usual(find_preset(preset)->scene);
  scene.water.model = scene.clouds.model = no_model;
  return scene;
}

Scene cheap(const char* preset) {
  Scene scene = find_preset(preset)->scene;
  make_cheap(scene);
  return scene;
}

std::vector<float> light_of(Renderer& renderer, const Scene& scene, const View& view) {
  renderer.draw(scene, view, {Channel::color, Effort::complete, true});
  return renderer.read_light();
}

double contrast_of(Pixels light) {
  double variance = 0.0;
  for (std::size_t channel = 0; channel < 4; ++channel) {
    double sum = 0.0, squares = 0.0;
    for (std::size_t i = channel; i < light.size(); i += 4) {
      sum += double{light[i]};
      squares += double{light[i]} * double{light[i]};
    }
    const double count = static_cast<double>(light.size()) / 4.0;
    variance += std::max(0.0, squares / count - sum * sum / count / count) / 4.0;
  }
  return std::sqrt(variance);
}

double mean_difference(Pixels a, Pixels b) { return std::pow(10.0, -0.05 * light_psnr(a, b)); }

Limit follow(Limit limit, const Scene& start, const std::vector<double>& values, const Change& change,
             const Error& error) {
  for (const double value : values) {
    Scene scene = start;
    View view = small_view();
    change(scene, view, value);
    limit.points.push_back({value, error(scene, view), warned(scene, view, limit.path)});
  }
  return limit;
}

}  // namespace terrella
