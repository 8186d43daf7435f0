#include "scene/uniforms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "random_scene.hpp"

namespace terrella {
namespace {

using Block = std::vector<std::byte>;

// Members by name, with the parameter each stands for.
struct Member {
  const Parameter* parameter;
  std::size_t offset, bytes;
};

std::map<std::string, Member> members() {
  std::map<std::string, std::size_t> offsets;
  for (const BlockMember& member : block_members()) offsets[member.name] = member.offset;
  std::map<std::string, Member> all;
  for (const Parameter& parameter : parameters()) {
    const std::string name = std::string(parameter.group) + "_" + std::string(parameter.name);
    if (!offsets.contains(name)) continue;
    all[name] = {&parameter, offsets[name], parameter.type == Type::Color ? std::size_t{16} : std::size_t{4}};
  }
  EXPECT_EQ(all.size(), block_members().size()) << "a member that is no parameter";
  return all;
}

template <class T>
T read(const Block& block, const std::string& name, std::size_t index = 0) {
  T value{};
  std::memcpy(&value, block.data() + members().at(name).offset + index * sizeof value, sizeof value);
  return value;
}

TEST(SceneBlock, HoldsAllThatShadersMayAskFor) {
  const auto all = members();
  for (const Parameter& parameter : parameters()) {
    const bool left_out = parameter.group == "camera" || parameter.group == "quality" || parameter.group == "time" ||
                          parameter.type == Type::File;
    const std::string name = std::string(parameter.group) + "_" + std::string(parameter.name);
    EXPECT_NE(all.contains(name), left_out) << name;
  }
}

TEST(SceneBlock, IsLaidOutAsStd140Asks) {
  std::size_t end = 0;
  for (const BlockMember& member : block_members()) {
    const std::size_t bytes = members().at(member.name).bytes;
    EXPECT_EQ(member.offset % bytes, 0u) << member.name;
    EXPECT_EQ(member.offset, end) << member.name << ": a gap or an overlap";
    end = member.offset + bytes;
  }
  const std::size_t size = pack_scene({}).size();
  EXPECT_EQ(size % 16, 0u);
  EXPECT_TRUE(size >= end && size < end + 16) << size << " bytes for members that end at " << end;
}

TEST(SceneBlock, SortsColorsBeforeRealsBeforeInts) {
  int last_rank = 0;
  for (const BlockMember& member : block_members()) {
    const Type type = members().at(member.name).parameter->type;
    const int rank = type == Type::Color ? 0 : type == Type::Float ? 1 : 2;
    EXPECT_GE(rank, last_rank) << member.name;
    last_rank = rank;
  }
}

// A parameter moves its own bytes, and no others.
TEST(PackScene, GivesEachParameterItsPlace) {
  const Block before = pack_scene({});
  for (const auto& [name, member] : members()) {
    if (member.parameter->path == "planet.radius") continue;  // the unit of the others
    Scene scene;
    Random random(1);
    while (member.parameter->get(scene) == member.parameter->default_value) randomize(scene, *member.parameter, random);
    const Block after = pack_scene(scene);
    bool moved = false;
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (after[i] == before[i]) continue;
      moved = true;
      EXPECT_TRUE(i >= member.offset && i < member.offset + member.bytes) << name << " moved byte " << i;
    }
    EXPECT_TRUE(moved) << name;
  }
}

TEST(PackScene, DoesNotKnowCameraQualityAndTime) {
  Random random(2);
  Scene scene;
  for (const Parameter& parameter : parameters()) {
    if (parameter.group == "camera" || parameter.group == "quality" || parameter.group == "time") {
      randomize(scene, parameter, random);
    }
  }
  EXPECT_EQ(pack_scene(scene), pack_scene({}));
}

// A planet twice as large with everything on it twice as large is the same to a shader, to the bit.
TEST(PackScene, IsTheSameAtEverySize) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Scene small = random_document(random).scene;
    for (const double times : {2.0, 1024.0, 0.125}) ASSERT_EQ(pack_scene(scaled(small, times)), pack_scene(small));
  }
}

TEST(PackScene, MeasuresInRadii) {
  Scene scene;
  scene.planet.radius = 6'371'000;
  scene.terrain.height = 6'371;
  scene.waves.speed = 63.71;
  const Block block = pack_scene(scene);
  EXPECT_EQ(read<float>(block, "planet_radius"), 1.0f);
  EXPECT_EQ(read<float>(block, "terrain_height"), 1e-3f);
  EXPECT_EQ(read<float>(block, "waves_speed"), 1e-5f);
  EXPECT_EQ(read<float>(block, "terrain_frequency"), 1.25f) << "cells a radius stay as they are";
}

TEST(PackScene, GivesColorsAsLinearLight) {
  Scene scene;
  scene.sun.color = {255, 0, 128};
  const Block block = pack_scene(scene);
  EXPECT_EQ(read<float>(block, "sun_color", 0), 1.0f);
  EXPECT_EQ(read<float>(block, "sun_color", 1), 0.0f);
  EXPECT_NEAR(read<float>(block, "sun_color", 2), 0.2158605, 1e-6);  // IEC 61966-2-1
  EXPECT_EQ(read<float>(block, "sun_color", 3), 1.0f);
  for (int channel = 1; channel < 256; ++channel) {
    EXPECT_GT(linear_light(static_cast<std::uint8_t>(channel)), linear_light(static_cast<std::uint8_t>(channel - 1)));
  }
}

TEST(PackScene, GivesBoolsAndChoicesAsInts) {
  Scene scene;
  scene.terrain.ridged = true;
  scene.water.model = 3;
  scene.waves.count = 100;
  const Block block = pack_scene(scene);
  EXPECT_EQ(read<std::int32_t>(block, "terrain_ridged"), 1);
  EXPECT_EQ(read<std::int32_t>(block, "water_model"), 3);
  EXPECT_EQ(read<std::int32_t>(block, "waves_count"), 100);
}

TEST(PackScene, IsFiniteEverywhere) {
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    const Block block = pack_scene(random_document(random).scene);
    for (const auto& [name, member] : members()) {
      if (member.parameter->type == Type::Float) {
        float value = 0;
        std::memcpy(&value, block.data() + member.offset, sizeof value);
        ASSERT_TRUE(std::isfinite(value)) << name;
      }
    }
  }
}

}  // namespace
}  // namespace terrella
