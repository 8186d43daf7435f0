#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "random_scene.hpp"
#include "scene/parameters.hpp"

namespace terrella {
namespace {

// The sentence for a value given as text; empty if it was taken.
std::string sentence(std::string_view path, std::string_view text) {
  Scene scene;
  const auto issue = assign_text(scene, path, text);
  if (!issue) return "";
  EXPECT_EQ(scene, Scene{}) << path << " was refused and yet changed";
  return issue->text();
}

TEST(Assign, SaysWhatIsWrongAndWhatIsAllowed) {
  EXPECT_EQ(sentence("waves.steepness", "1.4"), "waves.steepness: 1.4 is out of range; allowed are 0 to 1.");
  EXPECT_EQ(sentence("planet.radius", "0"), "planet.radius: 0 is out of range; allowed are 1 to 1e8 m.");
  EXPECT_EQ(sentence("camera.longitude", "180.5"),
            "camera.longitude: 180.5 is out of range; allowed are -180 to 180 deg.");
  EXPECT_EQ(sentence("waves.count", "2.5"), "waves.count: 2.5 is not a whole number; allowed are 0 to 1000.");
  EXPECT_EQ(sentence("waves.count", "many"), "waves.count: \"many\" is not a whole number; allowed are 0 to 1000.");
  EXPECT_EQ(sentence("waves.steepness", ""), "waves.steepness: \"\" is not a number; allowed are 0 to 1.");
  EXPECT_EQ(sentence("terrain.ridged", "yes"),
            "terrain.ridged: \"yes\" is neither true nor false; allowed are true or false.");
  EXPECT_EQ(sentence("sun.color", "red"), "sun.color: \"red\" is not a colour; allowed are #000000 to #ffffff.");
  EXPECT_EQ(sentence("picture.tone", "filmc"),
            "picture.tone: \"filmc\" is not a choice; allowed are filmic, reinhard, linear; did you mean filmic?");
}

TEST(Assign, NamesTheNearestParameter) {
  EXPECT_EQ(sentence("wavs.count", "3"), "wavs.count: there is no such parameter; did you mean waves.count?");
  EXPECT_EQ(sentence("steepness", "1"), "steepness: there is no such parameter; did you mean waves.steepness?");
  EXPECT_EQ(sentence("qqqqqqqqqqqq", "1"), "qqqqqqqqqqqq: there is no such parameter.");
  EXPECT_EQ(sentence("", "1"), "\"\": there is no such parameter.");
}

TEST(Assign, QuotesNoMoreThanIsReadable) {
  const std::string text = sentence("waves.steepness", std::string(1'000'000, '9'));
  EXPECT_LT(text.size(), 200u);
  EXPECT_NE(text.find("99999…"), std::string::npos);
  EXPECT_LT(sentence(std::string(1'000'000, 'w'), "1").size(), 200u);
}

TEST(Assign, TakesWhatAUserMayWrite) {
  for (const auto& [path, text] : {std::pair{"terrain.ridged", "1"},
                                   {"terrain.ridged", "true"},
                                   {"sun.color", "#FF8800"},
                                   {"sun.color", "ff8800"},
                                   {"waves.count", "8"},
                                   {"waves.count", "8.0"},
                                   {"waves.count", "1e1"},
                                   {"planet.radius", "6.371e6"}}) {
    EXPECT_EQ(sentence(path, text), "");
  }
}

TEST(Assign, RefusesWhatIsJustOutsideAndTakesTheEnds) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Parameter& parameter : parameters()) {
    if (parameter.type != Type::Float && parameter.type != Type::Int) continue;
    Scene scene;
    EXPECT_FALSE(assign(scene, parameter, parameter.min)) << parameter.path;
    EXPECT_FALSE(assign(scene, parameter, parameter.max)) << parameter.path;
    const Scene before = scene;
    for (const double bad : {std::nextafter(parameter.min, -infinity), std::nextafter(parameter.max, infinity),
                             infinity, -infinity, std::nan(""), 1e308, -1e308}) {
      EXPECT_TRUE(assign(scene, parameter, bad)) << parameter.path << " took " << bad;
    }
    EXPECT_EQ(scene, before) << parameter.path;
  }
}

TEST(Assign, RefusesEveryOtherType) {
  const Value values[] = {0.5, 1, true, Color{1, 2, 3}, std::string("text")};
  for (const Parameter& parameter : parameters()) {
    int taken = 0;
    for (const Value& value : values) {
      Scene scene;
      if (!assign(scene, parameter, value)) ++taken;
    }
    EXPECT_LE(taken, 2) << parameter.path;  // a number may come as 0.5 and as 1
  }
}

TEST(Assign, GivesBackWhatItWasGiven) {
  Random random(7);
  for (int i = 0; i < 100; ++i) {
    const Scene scene = random_document(random).scene;
    Scene by_value, by_text;
    for (const Parameter& parameter : parameters()) {
      const Value value = parameter.get(scene);
      EXPECT_FALSE(assign(by_value, parameter, value)) << parameter.path;
      EXPECT_FALSE(assign_text(by_text, parameter.path, to_text(value))) << parameter.path;
    }
    EXPECT_EQ(by_value, scene);
    EXPECT_EQ(by_text, scene);
  }
}

}  // namespace
}  // namespace terrella
