#include "scene/camera_path.hpp"

#include <gtest/gtest.h>

#include <string>

#include "scene/json_reader.hpp"

namespace terrella {
namespace {

// What is said about a path, a line each.
std::string said(std::string_view text) {
  Issues issues;
  read_path(text, {}, issues);
  std::string all;
  for (const std::string& sentence : issues.sentences()) all += sentence + "\n";
  return all;
}

std::string said_of_views(const std::string& views) {
  return said("{\"terrella_path\": 1, \"views\": [" + views + "]}");
}

TEST(ReadPath, TellsInEachViewWhatDiffersFromTheOneBefore) {
  Camera start;
  start.fov = 30.0;
  start.altitude = 7.0;
  Issues issues;
  const std::vector<PathView> views = read_path(
      R"({"terrella_path": 1, "title": "Down", "about": "A test",
          "views": [{}, {"altitude": 500, "pitch": -10, "at": 2.5}, {"heading": 90, "latitude": 90}, {"at": 1e3}]})",
      start, issues);
  EXPECT_EQ(issues.sentences(), std::vector<std::string>{});
  ASSERT_EQ(views.size(), 4u);
  std::vector<PathView> expected(4, {start, std::nullopt});
  for (std::size_t i = 1; i < 4; ++i) {
    expected[i].camera.altitude = 500.0;
    expected[i].camera.pitch = -10.0;
  }
  for (std::size_t i = 2; i < 4; ++i) {
    expected[i].camera.heading = 90.0;
    expected[i].camera.latitude = 90.0;
  }
  expected[1].at = 2.5;
  expected[3].at = 1000.0;
  EXPECT_EQ(views, expected);
}

TEST(ReadPath, SaysWhichKeyIsWrongAndWhatIsAllowed) {
  EXPECT_EQ(said_of_views(R"({"latitud": 3}, {"camera.latitude": 3})"),
            "view 1, latitud: there is no such key; allowed are latitude, longitude, altitude, heading, pitch, roll, "
            "fov, at; "
            "did you mean latitude?\n"
            "view 2, camera.latitude: there is no such key; allowed are latitude, longitude, altitude, heading, pitch, "
            "roll, fov, at.\n");
  EXPECT_EQ(said(R"({"terrella_path": 1, "view": [], "views": [{}, {}]})"),
            "view: there is no such key; allowed are terrella_path, views, title, about; did you mean views?\n");
  EXPECT_EQ(said_of_views(R"({"fov": 20, "fov": 30}, {})"), "view 1, fov: is given more than once.\n");
  EXPECT_EQ(said(R"({"terrella_path": 1, "views": [{}, {}], "views": [{}, {}]})"), "views: is given more than once.\n");
}

TEST(ReadPath, SaysWhichNumberIsWrongAndWhatIsAllowed) {
  EXPECT_EQ(said_of_views(R"({"latitude": 95}, {"altitude": "high"}, {"fov": null}, {"pitch": [1]})"),
            "view 1, latitude: 95 is out of range; allowed are -90 to 90 deg.\n"
            "view 2, altitude: \"high\" is not a number; allowed are 0 to 1e12 m.\n"
            "view 3, fov: null is not a number; allowed are 1 to 170 deg.\n"
            "view 4, pitch: [1] is not a number; allowed are -90 to 90 deg.\n");
  EXPECT_EQ(said_of_views(R"({}, {"at": -1}, {"at": 1e999}, {"at": true}, {"at": NaN}, {"at": {}})"),
            "view 2, at: -1 is out of range; allowed are 0 to 1e9 s.\n"
            "view 3, at: 1e999 is out of range; allowed are 0 to 1e9 s.\n"
            "view 4, at: true is not a number; allowed are 0 to 1e9 s.\n"
            "view 5, at: NaN is not a number; allowed are 0 to 1e9 s.\n"
            "view 6, at: {} is not a number; allowed are 0 to 1e9 s.\n");
}

TEST(ReadPath, SaysWhichTimesDoNotRise) {
  EXPECT_EQ(said_of_views(R"({"at": 3}, {"at": 5})"), "view 1, at: 3 is not 0, when a path begins.\n");
  EXPECT_EQ(said_of_views(R"({}, {"at": 0})"), "view 2, at: 0 is not later than 0 of view 1; times rise.\n");
  EXPECT_EQ(said_of_views(R"({"at": 0}, {"at": 5}, {}, {"at": 4}, {"at": 6})"),
            "view 4, at: 4 is not later than 5 of view 2; times rise.\n");
}

TEST(ReadPath, NeedsAVersionAndTwoViews) {
  EXPECT_EQ(said("{}"),
            "terrella_path: is missing; a path begins with {\"terrella_path\": 1, \"views\": […]}.\n"
            "views: there is none; a path leads through 2 to 1000 views.\n");
  EXPECT_EQ(said(R"({"terrella_path": 2, "views": [{}, {}]})"),
            "terrella_path: version 2 is not known; this program reads version 1.\n");
  EXPECT_EQ(said_of_views("{}"), "views: there is only one; a path leads through 2 to 1000 views.\n");
  std::string many = "{}";
  for (int i = 0; i < 1000; ++i) many += ",{}";
  EXPECT_EQ(said_of_views(many), "views: there are 1001; a path leads through 2 to 1000 views.\n");
  EXPECT_EQ(said(R"({"terrella_path": 1, "views": {"latitude": 3}})"),
            "views.latitude: there is no such key; allowed are terrella_path, views, title, about.\n"
            "views: there is none; a path leads through 2 to 1000 views.\n");
  EXPECT_EQ(
      said(R"({"terrella_path": 1, "views": 5})"),
      "views: 5 is not a list of views, [{…}, {…}].\nviews: there is none; a path leads through 2 to 1000 views.\n");
  EXPECT_EQ(said_of_views("{}, 7, [1]"), "view 2: 7 is not a view, {…}.\nview 3: [1] is not a view, {…}.\n");
}

TEST(ReadPath, SaysWhereItIsNoJson) {
  EXPECT_EQ(said(""), "The text is empty; a path is a JSON object, at least {}.\n");
  EXPECT_EQ(said("[{}]"), "A path is a JSON object, {…}, and this begins with \"[{}]\".\n");
  EXPECT_EQ(said("{\"terrella_path\": 1,\n \"views\": [{}, {}"),
            "Line 2, column 18: the text breaks off; the rest was not read.\n");
  EXPECT_EQ(
      said("{\"views\": [{} {}]}"),
      "Line 1, column 15: a comma or a closing bracket should stand here, not \"{}]}\"; the rest was not read.\n");
  EXPECT_EQ(said(std::string(kLongestJson + 1, ' ')), "The path is 1000001 bytes long; at most 1000000 are read.\n");
}

// Wherever a text breaks off there is a sentence.
TEST(ReadPath, TakesNoPartForTheWhole) {
  const std::string whole = R"({"terrella_path": 1, "views": [{"at": 0}, {"altitude": 500, "at": 12}]})";
  EXPECT_EQ(said(whole), "");
  for (std::size_t length = 0; length < whole.size(); ++length) EXPECT_NE(said(whole.substr(0, length)), "") << length;
}

TEST(ReadPath, BearsAnything) {
  const std::string many(200'000, '[');
  EXPECT_NE(said_of_views(many), "");
  std::string keys = "{";
  for (int i = 0; i < 50'000; ++i) keys += "\"a" + std::to_string(i) + "\":1,";
  EXPECT_NE(said_of_views(keys + "\"b\":2},{}").find("more.\n"), std::string::npos);
}

}  // namespace
}  // namespace terrella
