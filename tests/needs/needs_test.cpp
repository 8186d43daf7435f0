// A table: a scene and a view, and what must be modelled.
#include "planet/needs.hpp"

#include <gtest/gtest.h>

#include <functional>

#include <glm/geometric.hpp>

#include "planet/icosphere_groups.hpp"
#include "planet/spheres.hpp"
#include "scene/choices.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

struct Case {
  const char* name;
  std::function<void(Scene&)> change;
  std::function<bool(const Needs&)> holds;
};

const Case cases[] = {
    {"defaults", [](Scene&) {},
     [](const Needs& n) {
       return n.ground == Ground::icosphere && n.water == Water::calm && n.clouds == Clouds::shell &&
              n.air == Air::fresnel && n.stars == Stars::noise && n.moving;
     }},
    {"the default view needs no noise at its pixels", [](Scene&) {},
     [](const Needs& n) { return n.pixel_octaves_first == n.pixel_octaves_end; }},
    {"near the ground pixels compute what the map can't hold", [](Scene& s) { s.camera.altitude = 0.05; },
     [](const Needs& n) { return n.pixel_octaves_end > n.pixel_octaves_first; }},
    {"flat ground needs no noise at its pixels",
     [](Scene& s) {
       s.camera.altitude = 0.05;
       s.terrain.height = 0.0;
     },
     [](const Needs& n) { return n.pixel_octaves_first == n.pixel_octaves_end; }},
    {"no terrain", [](Scene& s) { s.terrain.model = choice("terrain.model", "none"); },
     [](const Needs& n) { return n.ground == Ground::none && n.water == Water::calm; }},
    {"no water", [](Scene& s) { s.water.model = choice("water.model", "none"); },
     [](const Needs& n) { return n.water == Water::none && n.ripple_layers == 0; }},
    {"a sea of no depth", [](Scene& s) { s.water.level = 0.0; }, [](const Needs& n) { return n.water == Water::none; }},
    {"waves asked for and seen", [](Scene& s) { s.waves.count = 8; },
     [](const Needs& n) { return n.water == Water::waves; }},
    {"waves of no height",
     [](Scene& s) {
       s.waves.count = 8;
       s.waves.amplitude = 0.0;
     },
     [](const Needs& n) { return n.water == Water::calm; }},
    {"waves under half a pixel are left out",
     [](Scene& s) {
       s.waves.count = 8;
       s.camera.altitude = 1000.0;
     },
     [](const Needs& n) { return n.water == Water::calm; }},
    {"unless the model asks for them",
     [](Scene& s) {
       s.waves.count = 8;
       s.camera.altitude = 1000.0;
       s.water.model = choice("water.model", "waves");
     },
     [](const Needs& n) { return n.water == Water::waves; }},
    {"calm asked for",
     [](Scene& s) {
       s.waves.count = 8;
       s.water.model = choice("water.model", "calm");
     },
     [](const Needs& n) { return n.water == Water::calm; }},
    {"ripples off", [](Scene& s) { s.water.ripples = 0.0; }, [](const Needs& n) { return n.ripple_layers == 0; }},
    {"ripples from close by", [](Scene& s) { s.camera.altitude = 0.06; },
     [](const Needs& n) { return n.ripple_layers > 2; }},
    {"ripples from afar", [](Scene&) {}, [](const Needs& n) { return n.ripple_layers == 2; }},
    {"ripples under two pixels", [](Scene& s) { s.water.ripple_frequency = 10000.0; },
     [](const Needs& n) { return n.ripple_layers == 0; }},
    {"no clouds", [](Scene& s) { s.clouds.model = choice("clouds.model", "none"); },
     [](const Needs& n) { return n.clouds == Clouds::none && n.cloud_octaves == 0; }},
    {"clouds of no coverage", [](Scene& s) { s.clouds.coverage = 0.0; },
     [](const Needs& n) { return n.clouds == Clouds::none; }},
    {"clouds of no density", [](Scene& s) { s.clouds.density = 0.0; },
     [](const Needs& n) { return n.clouds == Clouds::none; }},
    {"clouds of no octave", [](Scene& s) { s.clouds.octaves = 0; },
     [](const Needs& n) { return n.clouds == Clouds::none; }},
    {"cloud layers finer than their map are left out",
     [](Scene& s) {
       s.clouds.octaves = 10;
       s.quality.cloud_texels = 64;
     },
     [](const Needs& n) { return n.cloud_octaves >= 1 && n.cloud_octaves < 6; }},
    {"clouds from far away need fewer layers", [](Scene& s) { s.camera.altitude = 100.0; },
     [](const Needs& n) { return n.cloud_octaves < 5; }},
    {"clouds from afar need no layers at pixels", [](Scene&) {},
     [](const Needs& n) { return n.cloud_pixel_end == n.cloud_pixel_first; }},
    {"clouds from close by", [](Scene& s) { s.camera.altitude = 0.4; },
     [](const Needs& n) { return n.cloud_pixel_end > n.cloud_pixel_first; }},
    {"clouds without fine layers from close by",
     [](Scene& s) {
       s.camera.altitude = 0.4;
       s.clouds.octaves = 3;
     },
     [](const Needs& n) { return n.cloud_pixel_end == 3; }},
    {"clouds that stand need one map", [](Scene& s) { s.clouds.speed = 0.0; },
     [](const Needs& n) { return n.clouds == Clouds::shell && n.cloud_interval == 0.0; }},
    {"faster clouds are refreshed more often", [](Scene& s) { s.clouds.speed = 4.0; },
     [](const Needs& n) { return n.cloud_interval > 0.0 && n.cloud_interval < 0.05; }},
    {"no air", [](Scene& s) { s.air.model = choice("air.model", "none"); },
     [](const Needs& n) { return n.air == Air::none; }},
    {"air of no density", [](Scene& s) { s.air.density = 0.0; }, [](const Needs& n) { return n.air == Air::none; }},
    {"air of no height", [](Scene& s) { s.air.height = 0.0; }, [](const Needs& n) { return n.air == Air::none; }},
    {"no stars", [](Scene& s) { s.stars.density = 0.0; }, [](const Needs& n) { return n.stars == Stars::none; }},
    {"dark stars", [](Scene& s) { s.stars.brightness = 0.0; }, [](const Needs& n) { return n.stars == Stars::none; }},
    {"lights at night", [](Scene&) {}, [](const Needs& n) { return n.night == NightSide::lights; }},
    {"no lights", [](Scene& s) { s.lights.density = 0.0; }, [](const Needs& n) { return n.night == NightSide::none; }},
    {"dark lights", [](Scene& s) { s.lights.brightness = 0.0; },
     [](const Needs& n) { return n.night == NightSide::none; }},
    {"lights without a ground", [](Scene& s) { s.terrain.model = choice("terrain.model", "none"); },
     [](const Needs& n) { return n.night == NightSide::none; }},
    {"the sun beside the picture", [](Scene&) {}, [](const Needs& n) { return n.sun == SunImage::none; }},
    {"the sun in the picture",
     [](Scene& s) {
       s.sun.latitude = 0.0;
       s.sun.longitude = 180.0;
     },
     [](const Needs& n) { return n.sun == SunImage::disc; }},
    {"a sun that is not to be seen",
     [](Scene& s) {
       s.sun.longitude = 180.0;
       s.sun.size = s.sun.glare = 0.0;
     },
     [](const Needs& n) { return n.sun == SunImage::none; }},
    {"time that stands moves nothing", [](Scene& s) { s.time.speed = 0.0; }, [](const Needs& n) { return !n.moving; }},
    {"nothing that moves",
     [](Scene& s) {
       s.water.ripple_speed = 0.0;
       s.clouds.speed = s.clouds.drift = 0.0;
     },
     [](const Needs& n) { return !n.moving; }},
    {"a far planet needs a coarse mesh", [](Scene& s) { s.camera.altitude = 300.0; },
     [](const Needs& n) { return n.ground_level == group_level && n.water_level == group_level; }},
    {"near the ground its triangles are fine", [](Scene& s) { s.camera.altitude = 0.0; },
     [](const Needs& n) { return n.ground_tolerance < 1e-6; }},
    {"a smaller error needs a finer mesh", [](Scene& s) { s.quality.pixel_error = 0.1; },
     [](const Needs& n) { return n.ground_level == 7; }},
    {"a coarser error allows a coarser mesh", [](Scene& s) { s.quality.pixel_error = 16.0; },
     [](const Needs& n) { return n.ground_level < 6; }},
};

TEST(Needs, AreWhatTheTableSays) {
  for (const Case& entry : cases) {
    Scene scene;
    entry.change(scene);
    const View view;
    EXPECT_TRUE(entry.holds(needs_of(scene, view, pose_of(scene, view)))) << entry.name;
  }
}

TEST(Needs, GiveAReasonForEveryDecision) {
  for (const Preset& preset : presets()) {
    const View view;
    const Needs needs = needs_of(preset.scene, view, pose_of(preset.scene, view));
    EXPECT_GE(needs.decisions.size(), 5U);
    for (const Decision& d : needs.decisions) {
      EXPECT_FALSE(d.what.empty());
      EXPECT_FALSE(d.chosen.empty());
      EXPECT_GT(d.why.size(), 10U) << d.what;
    }
  }
}

// In a picture of so few rows, an error of 16 pixels is larger than the planet: lifted by it, the sea would lie before
// the near end of the depths, and one would look through the planet.
TEST(Needs, NeverLiftTheSeaNearTheEye) {
  Scene scene;
  scene.quality.pixel_error = 16.0;
  for (const int height : {1, 9, 36, 720}) {
    for (const double altitude : {0.01, 0.3, 2.25, 100.0}) {
      scene.camera.altitude = altitude;
      View view;
      view.width = view.height = height;
      const Pose pose = pose_of(scene, view);
      const Needs needs = needs_of(scene, view, pose);
      EXPECT_LT(water_radius(scene) + needs.water_lift, glm::length(pose.eye) - pose.near) << height << ' ' << altitude;
    }
  }
}

TEST(Needs, DefaultViewKeepsItsBudgetOfTriangles) {
  const View view;
  const Scene scene;
  const Needs n = needs_of(scene, view, pose_of(scene, view));
  const auto triangles = [](int level) { return 20 << (2 * level); };
  EXPECT_LE(triangles(n.ground_level) + triangles(n.water_level) + triangles(n.cloud_level), 150'000);
}

}  // namespace
}  // namespace terrella
