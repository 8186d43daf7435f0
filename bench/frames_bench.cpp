// What a frame costs: `make bench`. Frames are drawn as a window draws them, on whatever OpenGL this machine offers.
#include <benchmark/benchmark.h>

#include "gl/caps.hpp"
#include "native/egl_context.hpp"
#include "render/renderer.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

void wait_for_gpu() {
  unsigned char pixel[4];
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
}

void draw_preset(benchmark::State& state, const Scene& scene) {
  auto context = EglContext::make(Api::core);
  if (!context) {
    state.SkipWithError(context.sentence().c_str());
    return;
  }
  Renderer renderer;
  View view;
  renderer.draw(scene, view, {Channel::color, Effort::complete, false});
  wait_for_gpu();
  for (auto _ : state) {
    view.seconds += 1.0 / 10.0;
    renderer.draw(scene, view, {Channel::color, Effort::live, false});
    wait_for_gpu();
  }
  const RenderStats stats = renderer.stats();
  state.counters["triangles"] = static_cast<double>(stats.triangles);
  state.counters["noise"] = static_cast<double>(stats.noise_evaluations);
  state.counters["MB"] = static_cast<double>(stats.gpu_bytes) / 1e6;
}

// A terrain slider under the hand: every frame has another ground.
void drag_terrain(benchmark::State& state) {
  auto context = EglContext::make(Api::core);
  if (!context) {
    state.SkipWithError(context.sentence().c_str());
    return;
  }
  Renderer renderer;
  Scene scene;
  View view;
  for (auto _ : state) {
    scene.terrain.height += 1e-5;
    renderer.draw(scene, view, {Channel::color, Effort::hurried, false});
    wait_for_gpu();
  }
}

const bool registered = [] {
  for (const Preset& preset : presets()) {
    benchmark::RegisterBenchmark(("frame/" + preset.name).c_str(),
                                 [&preset](benchmark::State& state) { draw_preset(state, preset.scene); })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  }
  benchmark::RegisterBenchmark("frame/temperate, terrain dragged", drag_terrain)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
  return true;
}();

}  // namespace
}  // namespace terrella
