#include "scene/parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "scene/choices.hpp"

namespace terrella {
namespace {

TEST(Parameters, HaveAPathOfTheirOwn) {
  std::set<std::string_view> paths;
  for (const Parameter& parameter : parameters()) {
    EXPECT_TRUE(paths.insert(parameter.path).second) << parameter.path << " stands twice";
    EXPECT_EQ(std::string(parameter.group) + "." + std::string(parameter.name), parameter.path);
    EXPECT_EQ(find_parameter(parameter.path), &parameter);
    EXPECT_NE(find_group(parameter.group), nullptr) << parameter.group;
  }
  EXPECT_EQ(find_parameter("waves.nothing"), nullptr);
  EXPECT_EQ(find_group("nothing"), nullptr);
}

TEST(Parameters, HoldTheirDefaultInANewScene) {
  for (const Parameter& parameter : parameters()) {
    EXPECT_EQ(parameter.get(Scene{}), parameter.default_value) << parameter.path;
  }
}

TEST(Parameters, AllowTheirOwnDefault) {
  for (const Parameter& parameter : parameters()) {
    Scene scene;
    const auto issue = assign(scene, parameter, parameter.default_value);
    EXPECT_FALSE(issue) << issue->text();
    EXPECT_EQ(scene, Scene{}) << parameter.path;
  }
}

TEST(Parameters, HaveARangeThatTheirSliderFits) {
  for (const Parameter& parameter : parameters()) {
    EXPECT_TRUE(std::isfinite(parameter.min) && std::isfinite(parameter.max)) << parameter.path;
    if (parameter.type == Type::Float || parameter.type == Type::Int) {
      EXPECT_LT(parameter.min, parameter.max) << parameter.path;
    }
    EXPECT_EQ(parameter.unit == "m", parameter.is_length()) << parameter.path;
  }
}

TEST(Parameters, ExplainThemselvesInOneSentence) {
  for (const Parameter& parameter : parameters()) {
    EXPECT_GE(parameter.help.size(), 8u) << parameter.path;
    EXPECT_FALSE(parameter.help.ends_with('.')) << parameter.path;
    EXPECT_EQ(parameter.help.find('|'), std::string_view::npos) << parameter.path << " would break the manual's table";
  }
}

// What the contract promises to every version, so that links and files live on.
TEST(Parameters, KeepTheNamesThatWerePromised) {
  for (const char* path : {"planet.radius",
                           "planet.seed",
                           "camera.latitude",
                           "camera.longitude",
                           "camera.altitude",
                           "camera.heading",
                           "camera.pitch",
                           "camera.fov",
                           "sun.latitude",
                           "sun.longitude",
                           "sun.intensity",
                           "sun.color",
                           "terrain.model",
                           "terrain.height",
                           "terrain.frequency",
                           "terrain.octaves",
                           "terrain.persistence",
                           "terrain.lacunarity",
                           "terrain.power",
                           "terrain.ridged",
                           "water.model",
                           "water.level",
                           "water.color",
                           "water.roughness",
                           "waves.count",
                           "waves.amplitude",
                           "waves.length",
                           "waves.steepness",
                           "waves.speed",
                           "waves.spread",
                           "waves.seed",
                           "clouds.model",
                           "clouds.coverage",
                           "clouds.height",
                           "clouds.thickness",
                           "clouds.frequency",
                           "clouds.octaves",
                           "clouds.warp",
                           "clouds.speed",
                           "clouds.density",
                           "clouds.color",
                           "air.model",
                           "air.height",
                           "air.density",
                           "air.color",
                           "air.exponent",
                           "air.wrap",
                           "stars.model",
                           "stars.density",
                           "stars.brightness",
                           "stars.seed",
                           "quality.pixel_error",
                           "quality.target_ms",
                           "terrain.ridge_sharpness",
                           "quality.resolution_scale"}) {
    EXPECT_NE(find_parameter(path), nullptr) << path;
  }
}

TEST(Choice, IsTheIndexOfItsName) {
  Scene scene;
  for (const Parameter& parameter : parameters()) {
    for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
      ASSERT_FALSE(assign(scene, parameter, std::string(parameter.choices[i])));
      EXPECT_EQ(*std::get<int*>(parameter.field(scene)), static_cast<int>(i)) << parameter.path;
      EXPECT_EQ(choice_name(scene, parameter.path), parameter.choices[i]);
    }
  }
  scene.water.model = choice("water.model", "waves");
  EXPECT_EQ(choice_name(scene, "water.model"), "waves");
}

}  // namespace
}  // namespace terrella
