// What is not needed costs nothing: no program, no texture, no draw call, no memory. And what a decision leaves out is
// not missed.
#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "measure/cases.hpp"
#include "measure/stability.hpp"
#include "measure/studio.hpp"
#include "scene/choices.hpp"
#include "scene/parameters.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

// Everything there is, in sight: by the night side, over which the sun rises, with rings.
Scene everything() {
  Scene scene = find_preset("temperate")->scene;
  make_cheap(scene);
  scene.quality.pixel_error = 0.5;  // with more, so small a picture would show the sea over most of the land
  scene.rings.density = 0.5;
  scene.camera.pitch = -60.0;
  scene.sun.latitude = 20.0;
  scene.sun.longitude = 150.0;
  scene.lights.density = 1.0;
  return scene;
}

View picture_view() {
  View view;
  view.width = 160;
  view.height = 90;
  return view;
}

// The second of two frames, for which nothing is left to be made.
RenderStats settled(Renderer& renderer, const Scene& scene) {
  for (int i = 0; i < 2; ++i) renderer.draw(scene, picture_view(), {});
  return renderer.stats();
}

std::set<std::string> names(const RenderStats& stats) { return {stats.programs.begin(), stats.programs.end()}; }

struct Case {
  const char* name;
  std::function<void(Scene&)> without;
  std::set<std::string> programs;  // that are not held
  int draw_calls;                  // that are not made
  int textures;                    // that are not held
};

const Case cases[] = {
    {"clouds", [](Scene& s) { s.clouds.coverage = 0.0; }, {"clouds/bake", "clouds/shell"}, 1, 1},
    {"air", [](Scene& s) { s.air.density = 0.0; }, {"air/fresnel"}, 1, 0},
    {"stars", [](Scene& s) { s.stars.density = 0.0; }, {"stars/noise", "stars/glow"}, 2, 0},
    {"sun", [](Scene& s) { s.sun.size = s.sun.glare = 0.0; }, {"sun/disc"}, 2, 0},
    {"sun beside the picture", [](Scene& s) { s.sun.longitude = 60.0; }, {"sun/disc"}, 2, 0},
    {"lights", [](Scene& s) { s.lights.density = 0.0; }, {"lights/night"}, 1, 0},
    {"rings", [](Scene& s) { s.rings.density = 0.0; }, {"rings/plane", "rings/shadow"}, 3, 0},
    {"water", [](Scene& s) { s.water.level = 0.0; }, {"water/calm"}, 1, 2},
    {"ground and its lights",
     [](Scene& s) { s.terrain.model = choice("terrain.model", "none"); },
     {"ground/bake", "ground/icosphere", "lights/night"},
     2,
     1},
};

TEST(WhatIsNotNeeded, CostsNothing) {
  test::Studio rich;
  for (const Case& entry : cases) {
    const RenderStats with = settled(rich.renderer, everything());
    Scene scene = everything();
    entry.without(scene);
    const RenderStats without = settled(rich.renderer, scene);
    std::set<std::string> expected = names(with);
    for (const std::string& program : entry.programs) EXPECT_EQ(expected.erase(program), 1U) << program;
    EXPECT_EQ(names(without), expected) << entry.name;
    EXPECT_EQ(without.draw_calls, with.draw_calls - entry.draw_calls) << entry.name;
    EXPECT_EQ(without.textures, with.textures - entry.textures) << entry.name;
    EXPECT_LT(without.triangles, with.triangles) << entry.name;
    // Other passes may have more to show for it, but no maps.
    if (entry.textures > 0) {
      EXPECT_LT(without.gpu_bytes, with.gpu_bytes) << entry.name;
    }
  }
}

// A renderer that never had it holds as little as one that gave it back.
TEST(WhatIsNotNeeded, IsNeverMade) {
  for (const Case& entry : cases) {
    Scene scene = everything();
    entry.without(scene);
    RenderStats given_back, never_had;
    {
      test::Studio studio;
      settled(studio.renderer, everything());
      given_back = settled(studio.renderer, scene);
    }
    {
      test::Studio studio;
      never_had = settled(studio.renderer, scene);
    }
    EXPECT_EQ(names(never_had), names(given_back)) << entry.name;
    EXPECT_EQ(never_had.textures, given_back.textures) << entry.name;
    EXPECT_EQ(never_had.draw_calls, given_back.draw_calls) << entry.name;
    EXPECT_LE(never_had.gpu_bytes, given_back.gpu_bytes) << entry.name;
  }
}

TEST(WhatIsNotNeeded, LeavesOfABareSceneTheScreenAlone) {
  test::Studio studio;
  Scene scene;
  scene.terrain.model = scene.water.model = scene.clouds.model = scene.air.model = scene.stars.model = 0;
  const RenderStats stats = settled(studio.renderer, scene);
  EXPECT_EQ(names(stats), (std::set<std::string>{"picture/tone"}));
  EXPECT_EQ(stats.draw_calls, 0);
  EXPECT_EQ(stats.triangles, 0);
  EXPECT_EQ(stats.noise_evaluations, 0);
  EXPECT_EQ(stats.textures, 3);  // the picture of light, and two of one texel for maps that there are not
  EXPECT_LT(stats.gpu_bytes, 160 * 90 * 12 + 4096);
}

TEST(WhatIsNotNeeded, IsNotComputedAtPixels) {
  test::Studio studio;
  Scene scene = everything();
  scene.camera.altitude = 0.06;
  scene.water.ripples = 0.5;
  const auto noise = [&] { return settled(studio.renderer, scene).noise_evaluations; };
  const std::int64_t all = noise();
  scene.water.ripples = 0.0;
  const std::int64_t without_ripples = noise();
  scene.terrain.height = 0.0;
  const std::int64_t without_hills = noise();
  scene.clouds.octaves = 1;
  EXPECT_GT(all, without_ripples);
  EXPECT_GT(without_ripples, without_hills);
  EXPECT_GE(without_hills, noise());
}

// Just before a decision leaves something out it must be next to nothing.
struct Edge {
  const char* preset;
  const char* path;
  double value;  // where it is still modelled; at 0 it is not
};

const Edge edges[] = {
    {"temperate", "water.ripples", 1e-4},    {"lava", "water.ripples", 1e-4},
    {"storm", "waves.amplitude", 1e-5},      {"temperate", "clouds.density", 1e-3},
    {"temperate", "clouds.speed", 1e-5},     {"rings", "rings.density", 1e-3},
    {"night", "lights.density", 1e-3},       {"night", "lights.brightness", 1e-3},
    {"temperate", "stars.brightness", 1e-3}, {"dusk", "sun.glare", 1e-3},
    {"dusk", "sun.intensity", 1e-3},         {"temperate", "terrain.height", 1e-5},
};

std::vector<float> light(Renderer& renderer, const Scene& scene, int width = 160, int height = 90) {
  View view;
  view.width = width;
  view.height = height;
  view.seconds = 3.0;
  renderer.draw(scene, view, {Channel::color, Effort::complete, true});
  return renderer.read_light();
}

TEST(WhatADecisionLeavesOut, IsNotMissed) {
  test::Studio studio;
  for (const Edge& edge : edges) {
    Scene scene = find_preset(edge.preset)->scene;
    make_cheap(scene);
    const Parameter& parameter = *find_parameter(edge.path);
    ASSERT_FALSE(assign(scene, parameter, edge.value));
    const std::vector<float> before = light(studio.renderer, scene);
    ASSERT_FALSE(assign(scene, parameter, 0.0));
    // Measured: at the most 5.3e-4, for the intensity of the sun; 0.2 where lava lost its crust with its ripples.
    EXPECT_GT(light_psnr(before, light(studio.renderer, scene)), 60.0) << edge.preset << ", " << edge.path;
  }
}

TEST(WhatADecisionLeavesOut, AreWavesOfUnderHalfAPixel) {
  test::Studio studio;
  int calm = 0;
  for (const double altitude : {3.0, 5.0, 10.0, 30.0, 100.0}) {
    Scene scene = find_preset("storm")->scene;
    make_cheap(scene);
    scene.quality.pixel_error = 0.75;
    scene.camera.altitude = altitude;
    scene.water.model = choice("water.model", "auto");
    const std::vector<float> chosen = light(studio.renderer, scene);
    calm += studio.renderer.needs().water == Water::calm ? 1 : 0;
    scene.water.model = choice("water.model", "waves");
    // Measured: 44.0 dB of light where the sea becomes calm, for the sake of a few sparkles; from further away nothing.
    EXPECT_GT(light_psnr(chosen, light(studio.renderer, scene)), 43.0) << altitude;
  }
  EXPECT_GT(calm, 1);
}

}  // namespace
}  // namespace terrella
