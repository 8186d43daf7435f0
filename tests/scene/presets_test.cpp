#include "scene/presets.hpp"

#include <gtest/gtest.h>

#include <set>

#include "scene/json.hpp"
#include "scene/link.hpp"
#include "scene/preset_texts.hpp"

namespace terrella {
namespace {

TEST(Presets, LoadWithoutASingleIssue) {
  for (const PresetText& file : preset_texts()) {
    SceneDocument document;
    EXPECT_EQ(load_json(document, file.json).sentences(), std::vector<std::string>{}) << file.name;
    ASSERT_NE(find_preset(file.name), nullptr) << file.name;
    EXPECT_EQ(document.scene, find_preset(file.name)->scene) << file.name;
  }
  EXPECT_EQ(presets().size(), preset_texts().size());
}

TEST(Presets, BeginWithTheDefault) {
  ASSERT_FALSE(presets().empty());
  EXPECT_EQ(presets()[0].name, kDefaultPreset);
  EXPECT_EQ(presets()[0].scene, Scene{});
}

TEST(Presets, AreDifferentWorlds) {
  std::set<std::string> titles;
  for (const Preset& preset : presets()) {
    EXPECT_TRUE(titles.insert(preset.title).second) << preset.title;
    EXPECT_GE(preset.title.size(), 3u) << preset.name;
    EXPECT_GE(preset.about.size(), 10u) << preset.name;
    EXPECT_FALSE(preset.about.ends_with('.')) << preset.name;
    for (const Preset& other : presets()) {
      EXPECT_EQ(other.scene == preset.scene, &other == &preset) << preset.name << " and " << other.name;
    }
  }
}

// A file's name is a link's value, without escapes.
TEST(Presets, HaveNamesThatFitALink) {
  for (const Preset& preset : presets()) {
    EXPECT_EQ(preset.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_-"), std::string::npos)
        << preset.name;
  }
}

TEST(Presets, AreShortAsJsonAndAsLink) {
  for (const Preset& preset : presets()) {
    const SceneDocument document{preset.scene, preset.name};
    const bool is_default = preset.name == kDefaultPreset;
    EXPECT_EQ(to_link(document), is_default ? "" : "preset=" + preset.name);
    SceneDocument by_json, by_link;
    EXPECT_TRUE(load_json(by_json, to_json(document)).empty());
    EXPECT_TRUE(load_link(by_link, to_link(document)).empty());
    EXPECT_EQ(by_json, document);
    EXPECT_EQ(by_link, document);
  }
}

// Each difference from the defaults survives when a scene is told without its preset's name.
TEST(Presets, RoundTripByTheirValuesAlone) {
  for (const Preset& preset : presets()) {
    const SceneDocument from_default{preset.scene, std::string(kDefaultPreset)};
    SceneDocument by_json, by_link;
    EXPECT_TRUE(load_json(by_json, to_json(from_default)).empty());
    EXPECT_TRUE(load_link(by_link, to_link(from_default)).empty());
    EXPECT_EQ(by_json, from_default) << preset.name;
    EXPECT_EQ(by_link, from_default) << preset.name;
  }
}

TEST(Presets, AMisspeltNameIsAnsweredWithTheNearest) {
  EXPECT_EQ(find_preset("strom"), nullptr);
  EXPECT_EQ(no_such_preset("strom").text(), "preset: there is no preset \"strom\"; did you mean storm?");
  EXPECT_EQ(no_such_preset("").text(), "preset: there is no preset \"\".");
}

}  // namespace
}  // namespace terrella
