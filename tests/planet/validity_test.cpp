#include "planet/validity.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "scene/choices.hpp"
#include "scene/parameters.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

std::vector<std::string> sentences(const Scene& scene, double seconds = 0.0) {
  View view;
  view.seconds = seconds;
  const Pose pose = pose_of(scene, view);
  std::vector<std::string> all;
  for (const Issue& issue : beyond_validity(scene, view, pose, needs_of(scene, view, pose)))
    all.push_back(issue.text());
  return all;
}

TEST(Validity, IsThatOfEveryPresetForThirtyYears) {
  for (const Preset& preset : presets()) {
    EXPECT_EQ(sentences(preset.scene), std::vector<std::string>{}) << preset.name;
    EXPECT_EQ(sentences(preset.scene, 1e9), std::vector<std::string>{}) << preset.name;
  }
}

struct Case {
  const char* sentence;
  std::function<void(Scene&)> change;
};

// Each in range before the change and out of it after.
const Case cases[] = {
    {"camera.altitude: the camera was under the surface and was raised above it.",
     [](Scene& s) {
       s.camera.altitude = 0.0;
       s.water.ripples = 0.0;
     }},
    {"camera.altitude: the camera comes no nearer to the surface than 0.0001 m on this planet.",
     [](Scene& s) {
       s.terrain.model = choice("terrain.model", "none");
       s.camera.altitude = s.water.level + 5e-5;
       s.water.ripples = 0.0;
     }},
    {"camera.altitude: 0.001 m over the surface ripples swim by more than a tenth of a pixel when the camera moves; "
     "they "
     "hold from 0.00174 m on.",
     [](Scene& s) {
       s.terrain.model = choice("terrain.model", "none");
       s.camera.altitude = s.water.level + 1e-3;
     }},
    {"terrain.height: 7 m is more than the mesh of the ground holds still under a moving camera; it does up to 3 m on "
     "this planet.",
     [](Scene& s) {
       s.terrain.height = 7.0;
       s.camera.altitude = 20.0;
     }},
    {"water.level: 1e+03 m is more than the mesh of the sea holds still under a moving camera; it does up to 100 m on "
     "this planet.",
     [](Scene& s) {
       s.water.level = 1000.0;
       s.camera.altitude = 3000.0;
     }},
    {"terrain.frequency: 30 cells in a radius are more than the mesh of the ground can raise; it does up to 12.1, "
     "finer "
     "hills are flat and only shaded.",
     [](Scene& s) { s.terrain.frequency = 30.0; }},
    {"clouds.frequency: 100 cells in a radius are more than the map of the clouds can hold; it does up to 57.6 with "
     "quality.cloud_texels 384, finer clouds fade away.",
     [](Scene& s) { s.clouds.frequency = 100.0; }},
};

TEST(Validity, IsToldWithTheParameterItsValueAndTheRange) {
  for (const Case& entry : cases) {
    Scene scene;
    EXPECT_TRUE(sentences(scene).empty());
    entry.change(scene);
    EXPECT_EQ(sentences(scene), std::vector<std::string>{entry.sentence});
  }
}

TEST(Validity, EndsWhereWavesAreSoFastThatTimeCannotTellTheirPlace) {
  Scene scene = find_preset("storm")->scene;
  scene.waves.speed = 1e4;
  EXPECT_TRUE(sentences(scene, 1.0).empty());
  const std::vector<std::string> told = sentences(scene, 1e9);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].rfind("waves.speed: 1e+04 m/s is more than can be followed for 1e+09 s; up to 110 m/s ", 0), 0U)
      << told[0];
}

Scene waves_from_low() {
  Scene scene = find_preset("storm")->scene;
  scene.terrain.model = choice("terrain.model", "none");
  scene.water.level = 0.2;
  scene.camera.altitude = 0.24;
  scene.camera.pitch = -8.0;
  return scene;
}

TEST(Validity, EndsWhereWavesAreTooShortForTheMeshOfTheSea) {
  const std::vector<std::string> told = sentences(waves_from_low());
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(
      told[0],
      "waves.length: the shortest of the waves have 0.0335 m, which is less than the mesh of the sea can raise; it "
      "does from 0.0827 m on, shorter ones are flat and only shaded.");
  Scene longer = waves_from_low();
  longer.waves.length = 0.5;
  EXPECT_TRUE(sentences(longer).empty());
  Scene lower = waves_from_low();
  lower.waves.amplitude = 1e-4;  // too low to be seen
  EXPECT_TRUE(sentences(lower).empty());
}

TEST(Validity, SaysNothingOfWhatIsNotModelled) {
  Scene scene;
  scene.terrain.model = scene.water.model = scene.clouds.model = 0;
  scene.terrain.height = scene.water.level = 1e6;
  scene.terrain.frequency = scene.clouds.frequency = 1e4;
  EXPECT_TRUE(sentences(scene).empty());
}

TEST(Validity, SaysNothingOfWhatCannotBeSeen) {
  Scene scene;
  scene.terrain.frequency = scene.clouds.frequency = 1e4;
  scene.camera.altitude = 1000.0;
  EXPECT_TRUE(sentences(scene).empty());
}

TEST(Validity, IsTheSameOnAPlanetOfAnySize) {
  for (const Case& entry : cases) {
    Scene scene;
    entry.change(scene);
    EXPECT_EQ(sentences(scaled(scene, 1e4)).size(), sentences(scene).size()) << entry.sentence;
  }
}

}  // namespace
}  // namespace terrella
