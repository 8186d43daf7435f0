// A table: a scene and a view, and what must be modelled.
#include "planet/needs.hpp"

#include <gtest/gtest.h>

#include <functional>

#include <glm/geometric.hpp>

#include "height_maps.hpp"
#include "planet/icosphere_groups.hpp"
#include "planet/spheres.hpp"
#include "scene/choices.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

// From so many metres over it.
Scene real_sea(double height) {
  Scene scene;
  scene.planet.radius = 6.36e6;
  scene.terrain.height = 11e3;
  scene.water.level = 9e3;
  scene.camera.altitude = scene.water.level + height;
  scene.waves.count = 20;
  scene.waves.spectrum = choice("waves.spectrum", "wind");
  return scene;
}

struct Case {
  const char* name;
  std::function<void(Scene&)> change;
  std::function<bool(const Needs&)> holds;
  std::function<void(View&)> see = [](View&) {};
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
    {"a map that is not here changes nothing", [](Scene& s) { s.terrain.map.name = "earth.png"; },
     [](const Needs& n) { return !n.ground_mapped; }},
    {"near the ground pixels compute what neither of the maps can hold",
     [](Scene& s) {
       s.camera.altitude = 0.05;
       s.terrain.map = {"earth.png", test::smooth_map(4096, 2048)};
     },
     [](const Needs& n) { return n.ground_mapped && n.pixel_octaves_first == 8; }},
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
    {"or under as many pixels as quality asks for",
     [](Scene& s) {
       s.waves.count = 8;
       s.quality.wave_height = 16.0;
     },
     [](const Needs& n) { return n.water == Water::calm; }},
    {"pixels add layers where texels are larger than quality allows",
     [](Scene& s) { s.quality.ground_texel_size = s.quality.cloud_texel_size = 0.25; },
     [](const Needs& n) { return refines_ground(n) && n.cloud_pixel_end > n.cloud_pixel_first; }},
    {"and none where it allows large ones",
     [](Scene& s) {
       s.camera.altitude = 0.5;
       s.quality.ground_texel_size = s.quality.cloud_texel_size = 64.0;
     },
     [](const Needs& n) { return !refines_ground(n) && n.cloud_pixel_end == n.cloud_pixel_first; }},
    {"large layers of ripples alone where quality leaves out the rest",
     [](Scene& s) {
       s.camera.altitude = 0.2;
       s.quality.finest_layer = 64.0;
     },
     [](const Needs& n) { return n.ripple_layers == 2; }},
    {"which the default does not", [](Scene& s) { s.camera.altitude = 0.2; },
     [](const Needs& n) { return n.ripple_layers > 2; }},
    {"clouds renewed less often where more may be lost", [](Scene& s) { s.quality.cloud_loss = 0.2; },
     [](const Needs& n) { return n.cloud_interval == 4.0 * 3.125; }},  // 3.125 s: with the default
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
    {"clouds a little over the sea, as fine as keeps them out of it",
     [](Scene& s) {
       s.water.ice_latitude = 90.0;
       s.clouds.height = s.water.level + 0.0012;
     },
     [](const Needs& n) { return n.cloud_level == 5; }},
    {"and finer over ice, which is nearer to them",
     [](Scene& s) {
       s.water.ice_latitude = 60.0;
       s.terrain.height = 0.05;
       s.clouds.height = s.water.level + 0.0012;
     },
     [](const Needs& n) { return n.cloud_level == 6; }},
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
    {"a bare scene needs nothing at all",
     [](Scene& s) {
       s.terrain.model = s.water.model = s.clouds.model = s.air.model = s.stars.model = 0;
       s.rings.density = 0.0;
     },
     [](const Needs& n) {
       return n.ground == Ground::none && n.water == Water::none && n.clouds == Clouds::none && n.air == Air::none &&
              n.stars == Stars::none && n.night == NightSide::none && n.sun == SunImage::none &&
              n.rings == Rings::none && !n.moving;
     }},
    {"a ground of no layers is flat and needs none at its pixels",
     [](Scene& s) {
       s.terrain.octaves = 0;
       s.camera.altitude = 0.05;
     },
     [](const Needs& n) { return n.ground == Ground::icosphere && n.pixel_octaves_first == n.pixel_octaves_end; }},
    {"a ground of coarse layers needs none at its pixels from close by",
     [](Scene& s) {
       s.terrain.octaves = 3;
       s.camera.altitude = 0.1;
     },
     [](const Needs& n) { return n.pixel_octaves_first == n.pixel_octaves_end; }},
    {"a finer map of the ground leaves fewer layers to its pixels",
     [](Scene& s) {
       s.camera.altitude = 0.05;
       s.quality.ground_texels = 2048;
     },
     [](const Needs& n) { return n.ground_texels == 2048 && n.pixel_octaves_first == 8; }},
    {"from the next star, single pixels need the coarsest of everything", [](Scene& s) { s.camera.altitude = 1e12; },
     [](const Needs& n) {
       return n.ground_level == group_level && n.water_level == group_level && n.cloud_level == group_level &&
              n.cloud_octaves == 1 && n.ripple_layers == 0 && n.pixel_octaves_end == n.pixel_octaves_first;
     }},
    {"a narrow field of view needs more at the pixels than a wide one", [](Scene& s) { s.camera.fov = 1.0; },
     [](const Needs& n) {
       return n.pixel_octaves_end > n.pixel_octaves_first && n.cloud_pixel_end > n.cloud_pixel_first &&
              n.ripple_layers > 2;
     }},
    {"a wide field of view needs less", [](Scene& s) { s.camera.fov = 170.0; },
     [](const Needs& n) {
       return n.ground_level == group_level && n.pixel_octaves_end == n.pixel_octaves_first && n.ripple_layers == 0;
     }},
    {"a smooth ground needs no fine mesh", [](Scene& s) { s.terrain.height = 0.0; },
     [](const Needs& n) { return n.ground_level == group_level; }},
    {"ground alone has neither water nor ripples",
     [](Scene& s) {
       s.water.model = choice("water.model", "none");
       s.water.ripples = 1.0;
     },
     [](const Needs& n) { return n.water == Water::none && n.ripple_layers == 0 && n.water_lift == 0.0; }},
    {"waves of a wind are there on a planet of real size", [](Scene& s) { s = real_sea(200.0); },
     [](const Needs& n) { return n.water == Water::waves && n.sea_swell > 0.0 && n.water_hides > 0.0; }},
    {"but not from so far that the longest is smaller than a pixel", [](Scene& s) { s = real_sea(4e5); },
     [](const Needs& n) { return n.water == Water::calm && n.sea_swell == 0.0; }},
    {"a sea of waves has no ripples beside them", [](Scene& s) { s.waves.count = 8; },
     [](const Needs& n) { return n.water == Water::waves && n.ripple_layers == 0; }},
    {"waves that stand move nothing",
     [](Scene& s) {
       s.waves.count = 8;
       s.waves.speed = s.clouds.speed = s.clouds.drift = 0.0;
     },
     [](const Needs& n) { return n.water == Water::waves && !n.moving; }},
    {"waves that run move",
     [](Scene& s) {
       s.waves.count = 8;
       s.clouds.speed = s.clouds.drift = 0.0;
     },
     [](const Needs& n) { return n.moving; }},
    {"waves on no water",
     [](Scene& s) {
       s.waves.count = 8;
       s.water.level = 0.0;
     },
     [](const Needs& n) { return n.water == Water::none; }},
    {"a crust needs the noise of ripples, which break it up",
     [](Scene& s) {
       s.water.ripples = 0.0;
       s.water.crust = 0.5;
     },
     [](const Needs& n) { return n.ripple_layers == 2; }},
    {"waves need a mesh that can carry them", [](Scene& s) { s.waves.count = 8; },
     [](const Needs& n) { return n.water_level == 6; }},
    {"and a finer one where less than a fifth of a pixel is asked for",
     [](Scene& s) {
       s.waves.count = 8;
       s.quality.pixel_error = 0.19;
     },
     [](const Needs& n) { return n.water_level == 7; }},
    {"a calm sea does not", [](Scene&) {}, [](const Needs& n) { return n.water_level < 6; }},
    {"drift alone moves clouds without changing them",
     [](Scene& s) {
       s.clouds.speed = s.water.ripple_speed = 0.0;
       s.clouds.drift = 1.0;
     },
     [](const Needs& n) { return n.moving && n.cloud_interval == 0.0; }},
    {"drift of no clouds moves nothing",
     [](Scene& s) {
       s.clouds.model = choice("clouds.model", "none");
       s.water.ripple_speed = 0.0;
     },
     [](const Needs& n) { return !n.moving; }},
    {"fewer layers of clouds change more slowly", [](Scene& s) { s.clouds.octaves = 2; },
     [](const Needs& n) { return n.cloud_octaves == 2 && n.cloud_interval == 4.0 * 3.125; }},
    {"no air by its model alone leaves the rest", [](Scene& s) { s.air.model = choice("air.model", "none"); },
     [](const Needs& n) { return n.clouds == Clouds::shell && n.stars == Stars::noise && n.ground != Ground::none; }},
    {"no stars by their model", [](Scene& s) { s.stars.model = choice("stars.model", "none"); },
     [](const Needs& n) { return n.stars == Stars::none && n.sun == SunImage::none; }},
    {"no rings", [](Scene&) {}, [](const Needs& n) { return n.rings == Rings::none; }},
    {"rings", [](Scene& s) { s.rings.density = 0.5; }, [](const Needs& n) { return n.rings == Rings::plane; }},
    {"rings that end before they begin",
     [](Scene& s) {
       s.rings.density = 0.5;
       s.rings.outer = s.rings.inner;
     },
     [](const Needs& n) { return n.rings == Rings::none; }},
    {"rings beside a planet of nothing else",
     [](Scene& s) {
       s.terrain.model = s.water.model = s.clouds.model = s.air.model = 0;
       s.rings.density = 0.5;
     },
     [](const Needs& n) { return n.rings == Rings::plane && n.ground == Ground::none && n.night == NightSide::none; }},
    {"a dark sun is not drawn",
     [](Scene& s) {
       s.sun.latitude = 0.0;
       s.sun.longitude = 180.0;
       s.sun.intensity = 0.0;
     },
     [](const Needs& n) { return n.sun == SunImage::none; }},
    {"a sun without glare just beside the picture is not drawn",
     [](Scene& s) {
       s.camera.latitude = 0.0;
       s.camera.pitch = 0.0;
       s.sun.latitude = 40.0;
       s.sun.longitude = 90.0;
       s.sun.glare = 0.0;
     },
     [](const Needs& n) { return n.sun == SunImage::none; }},
    {"a window on its side shows the sun that an upright one does not",
     [](Scene& s) {
       s.camera.latitude = 0.0;
       s.camera.pitch = 0.0;
       s.sun.latitude = 50.0;  // 40 degrees right of what is ahead
       s.sun.longitude = 90.0;
       s.sun.glare = 0.0;
     },
     [](const Needs& n) { return n.sun == SunImage::disc; }, [](View& v) { v.width = 4 * v.height; }},
    {"and the upright one",
     [](Scene& s) {
       s.camera.latitude = 0.0;
       s.camera.pitch = 0.0;
       s.sun.latitude = 50.0;  // 40 degrees right of what is ahead
       s.sun.longitude = 90.0;
       s.sun.glare = 0.0;
     },
     [](const Needs& n) { return n.sun == SunImage::none; }, [](View& v) { v.width = v.height / 2; }},
    {"a picture of one pixel needs the coarsest of everything", [](Scene&) {},
     [](const Needs& n) {
       return n.water_level == group_level && n.cloud_level == group_level && n.cloud_octaves == 1 &&
              n.ripple_layers == 0;
     },
     [](View& v) { v.width = v.height = 1; }},
    {"a picture of many rows needs more than one of few", [](Scene&) {},
     [](const Needs& n) { return n.ripple_layers > 2 && n.pixel_octaves_end > n.pixel_octaves_first; },
     [](View& v) {
       v.width = 7680;
       v.height = 4320;
     }},
    {"time itself changes nothing of what is modelled", [](Scene&) {},
     [](const Needs& n) {
       return n.water == Water::calm && n.ripple_layers == 2 && n.cloud_octaves == 5 && n.cloud_interval == 3.125;
     },
     [](View& v) { v.seconds = 1e9; }},
};

TEST(Needs, AreWhatTheTableSays) {
  for (const Case& entry : cases) {
    Scene scene;
    entry.change(scene);
    View view;
    entry.see(view);
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
