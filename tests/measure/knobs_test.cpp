#include "measure/knobs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "effort.hpp"
#include "measure/cameras.hpp"
#include "measure/effects.hpp"
#include "measure/image_error.hpp"
#include "measure/studio.hpp"
#include "measure/subject.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

double number_in(const Value& value) {
  if (const auto* whole = std::get_if<int>(&value)) return *whole;
  if (const auto* yes = std::get_if<bool>(&value)) return *yes ? 1.0 : 0.0;
  return std::get<double>(value);
}

TEST(Knobs, HaveValuesThatTheirParametersTakeInOrder) {
  std::set<std::string_view> paths;
  for (const Knob& knob : knobs()) {
    EXPECT_TRUE(paths.insert(knob.path).second) << knob.path;
    const Parameter* parameter = find_parameter(knob.path);
    ASSERT_NE(parameter, nullptr) << knob.path;
    EXPECT_EQ(parameter->group, "quality");
    ASSERT_GE(knob.values.size(), 2U) << knob.path;
    for (const Value& value : knob.values) {
      Scene scene;
      EXPECT_FALSE(assign(scene, *parameter, value)) << knob.path << ' ' << to_text(value);
      EXPECT_EQ(parameter->get(scene), value) << "of the parameter's own type";
    }
    if (parameter->type == Type::Choice) continue;
    const auto rises = [](const Value& a, const Value& b) { return number_in(a) < number_in(b); };
    const auto falls = [](const Value& a, const Value& b) { return number_in(a) > number_in(b); };
    EXPECT_TRUE(std::is_sorted(knob.values.begin(), knob.values.end(), rises) ||
                std::is_sorted(knob.values.begin(), knob.values.end(), falls))
        << knob.path;
  }
}

TEST(Knobs, TryTheScenesOwnValueInItsPlace) {
  const Knob falling = {"quality.pixel_error", {8.0, 2.0, 0.5}}, rising = {"quality.ground_texels", {64, 256, 1024}};
  Scene scene;
  scene.quality.pixel_error = 3.0;
  scene.quality.ground_texels = 2048;
  EXPECT_EQ(values_for(falling, scene, false), (std::vector<Value>{8.0, 3.0, 2.0, 0.5}));
  EXPECT_EQ(values_for(rising, scene, false), (std::vector<Value>{64, 256, 1024, 2048}));
  EXPECT_EQ(values_for(falling, scene, true), (std::vector<Value>{8.0, 3.0, 2.0}));
  EXPECT_EQ(values_for(rising, scene, true), (std::vector<Value>{64, 2048}));
  scene.quality.pixel_error = 8.0;
  EXPECT_EQ(values_for(falling, scene, true), (std::vector<Value>{8.0, 2.0}));
}

TEST(Knobs, NameASettingByWhatDiffersFromTheDefaults) {
  Scene scene;
  EXPECT_EQ(setting_id(scene), "default");
  scene.quality.resolution_scale = 0.5;
  scene.quality.antialias = false;
  EXPECT_EQ(setting_id(scene), "quality.antialias=false&quality.resolution_scale=0.5");
}

TEST(Cameras, DependOnTheSceneAloneAndStayOutOfTheGround) {
  for (const Preset& preset : presets()) {
    std::set<std::string> names;
    for (const Viewpoint& camera : cameras_of(preset.scene)) {
      EXPECT_TRUE(names.insert(camera.name).second);
      const Scene scene = seen_by(preset.scene, camera);
      EXPECT_FALSE(camera.name != "own" && pose_of(scene, {}).raised) << preset.name << ' ' << camera.name;
      for (const Parameter& parameter : parameters()) {
        if (parameter.group != "camera") continue;
        Scene checked;
        EXPECT_FALSE(assign(checked, parameter, parameter.get(scene))) << parameter.path;
      }
    }
    EXPECT_GE(names.size(), 3U);
  }
}

TEST(Effects, AreThoseThatTheSceneHas) {
  Scene scene = find_preset("temperate")->scene;
  std::set<std::string> names;
  for (const Effect& effect : effects()) {
    EXPECT_TRUE(names.insert(effect.name).second) << effect.name;
    Scene without = scene;
    effect.leave_out(without);
    EXPECT_FALSE(has(without, effect)) << effect.name;
  }
  const auto has_one = [&](const char* name) {
    return std::any_of(effects().begin(), effects().end(),
                       [&](const Effect& e) { return e.name == std::string_view(name) && has(scene, e); });
  };
  EXPECT_TRUE(has_one("clouds"));
  EXPECT_TRUE(has_one("cloud_shadow"));
  EXPECT_FALSE(has_one("rings"));
  EXPECT_FALSE(has_one("waves"));
  scene.clouds.coverage = 0.0;
  EXPECT_FALSE(has_one("clouds"));
  EXPECT_FALSE(has_one("cloud_shadow"));
}

// The finest setting of all knobs is nearer to the truth than the cheapest. Without points of light, whose size is told
// in pixels that are drawn.
TEST(Knobs, BuyAccuracy) {
  const test::Studio studio;
  const int width = test::sanitized ? 32 : 96, height = test::sanitized ? 18 : 54;
  Scene scene = find_preset("temperate")->scene;
  scene.stars.density = scene.lights.density = 0.0;
  Scene cheapest = scene, finest = scene;
  for (const Knob& knob : knobs()) {
    cheapest = turned(cheapest, knob, knob.values.front());
    finest = turned(finest, knob, knob.values.back());
  }
  const Truth truth(scene, width, height, {40.0, 13}, [](double) {});
  EXPECT_EQ(truth.samples(), 13);
  EXPECT_GT(truth.self_psnr(), 30.0);
  Subject subject(width, height);
  const double cheap = psnr(subject.pose(cheapest), truth.picture()),
               fine = psnr(subject.pose(finest), truth.picture());
  EXPECT_GT(fine, cheap + 3.0) << cheap << " dB";
}

}  // namespace
}  // namespace terrella
