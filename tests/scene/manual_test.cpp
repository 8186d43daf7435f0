#include "scene/manual.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "scene/parameters.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

using nlohmann::json;

TEST(ManualJson, DescribesEveryParameterAsPromised) {
  const json manual = json::parse(manual_json());
  ASSERT_EQ(manual.size(), parameters().size());
  for (const json& item : manual) {
    EXPECT_EQ(item.size(), 8u);
    const Parameter* parameter = find_parameter(item.at("path").get<std::string>());
    ASSERT_NE(parameter, nullptr) << item;
    const auto type = item.at("type").get<std::string>();
    const bool is_number = type == "float" || type == "int";
    EXPECT_EQ(item.at("min").is_number(), is_number) << item;
    EXPECT_EQ(item.at("max").is_number(), is_number) << item;
    EXPECT_EQ(item.at("default").is_number(), is_number) << item;
    EXPECT_EQ(item.at("default").is_boolean(), type == "bool") << item;
    EXPECT_EQ(item.at("default").is_string(), type == "color" || type == "choice" || type == "file") << item;
    EXPECT_EQ(item.at("choices").empty(), type != "choice") << item;
    EXPECT_EQ(item.at("unit").get<std::string>(), parameter->unit);
    EXPECT_EQ(item.at("help").get<std::string>(), parameter->help);
  }
}

// What the manual says of a default and a range is what a user may give.
TEST(ManualJson, GivesValuesThatAreTaken) {
  for (const json& item : json::parse(manual_json())) {
    const auto text = [&](const char* key) {
      const json& value = item.at(key);
      return value.is_string() ? value.get<std::string>() : value.dump();
    };
    Scene scene;
    const std::string path = item.at("path");
    EXPECT_FALSE(assign_text(scene, path, text("default"))) << item;
    EXPECT_EQ(scene, Scene{}) << item;
    for (const json& choice : item.at("choices")) EXPECT_FALSE(assign_text(scene, path, choice.get<std::string>()));
    if (!item.at("min").is_number()) continue;
    EXPECT_FALSE(assign_text(scene, path, text("min"))) << item;
    EXPECT_FALSE(assign_text(scene, path, text("max"))) << item;
  }
}

TEST(ManualText, HasALineForEachParameterAndATitleForEachGroup) {
  const std::string manual = manual_text();
  for (const Parameter& parameter : parameters()) {
    const std::size_t at = manual.find("\n| `" + std::string(parameter.path) + "` | ");
    ASSERT_NE(at, std::string::npos) << parameter.path;
    const std::string line = manual.substr(at + 1, manual.find('\n', at + 1) - at - 1);
    EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 7) << line;
    EXPECT_NE(line.find(parameter.help), std::string::npos) << line;
  }
  for (const Group& group : groups()) {
    EXPECT_NE(manual.find("\n## " + std::string(group.title) + "\n"), std::string::npos) << group.name;
  }
}

TEST(PresetsJson, ListsEveryPresetAsPromised) {
  const json list = json::parse(presets_json());
  ASSERT_EQ(list.size(), presets().size());
  for (const json& item : list) {
    EXPECT_EQ(item.size(), 3u);
    const Preset* preset = find_preset(item.at("name").get<std::string>());
    ASSERT_NE(preset, nullptr) << item;
    EXPECT_EQ(item.at("title").get<std::string>(), preset->title);
    EXPECT_EQ(item.at("radius").get<double>(), preset->scene.planet.radius);
  }
}

TEST(PresetsText, HasALineForEachPreset) {
  const std::string text = presets_text();
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), presets().size());
  for (const Preset& preset : presets()) EXPECT_NE(text.find(preset.title), std::string::npos);
}

}  // namespace
}  // namespace terrella
