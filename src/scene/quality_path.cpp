#include "scene/quality_path.hpp"

#include <string>
#include <vector>

#include "base/check.hpp"
#include "base/text.hpp"
#include "scene/link.hpp"

namespace terrella {
namespace {

QualityStep make_step(const char* preset, double cost, double psnr, double visible, const char* settings) {
  SceneDocument document;
  const Issues issues = load_link(document, settings);
  CHECK(issues.empty(), "quality_path.inc: ", settings);
  return {preset, cost, psnr, visible, document.scene.quality};
}

}  // namespace

std::span<const QualityStep> quality_path() {
  static const std::vector<QualityStep> path = {
#define STEP(preset, cost, psnr, visible, settings) make_step(preset, cost, psnr, visible, settings),
#include "scene/quality_path.inc"
#undef STEP
  };
  return path;
}

const QualityStep* find_quality(std::string_view preset) {
  for (const QualityStep& step : quality_path()) {
    if (!preset.empty() && step.preset == preset) return &step;
  }
  return nullptr;
}

std::vector<std::string_view> quality_names() {
  std::vector<std::string_view> names;
  for (const QualityStep& step : quality_path()) {
    if (!step.preset.empty()) names.push_back(step.preset);
  }
  return names;
}

Issue no_such_quality(std::string_view preset) {
  const std::vector<std::string_view> names = quality_names();
  return {"quality", text_of('"', shortened(preset), "\" is not a preset of quality; allowed are ", listed(names),
                             did_you_mean(nearest_name(preset, names)))};
}

Scene with_quality(Scene scene, const QualityStep& step) {
  const double target = scene.quality.target_ms;
  scene.quality = step.quality;
  scene.quality.target_ms = target;
  return scene;
}

bool has_quality(const Scene& scene, const QualityStep& step) { return with_quality(scene, step) == scene; }

}  // namespace terrella
