#include "scene/json_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace terrella {
namespace {

std::string flat(std::string_view json) {
  std::string text;
  const JsonReading reading = read_json(json);
  for (const Entry& entry : reading.entries) text += entry.path + "=" + entry.text + ";";
  return text + reading.trouble;
}

TEST(ReadJson, MakesAFlatListOfAScene) {
  EXPECT_EQ(flat(R"({"terrella": 1, "preset": "storm", "waves": {"steepness": 0.9, "count": 8}, "stars": {}})"),
            "terrella=1;preset=storm;waves.steepness=0.9;waves.count=8;");
  EXPECT_EQ(flat(" {\n} "), "");
  EXPECT_EQ(flat("\xef\xbb\xbf{\"a\":1}"), "a=1;") << "after a byte order mark";
}

TEST(ReadJson, KnowsEachTypeOfValue) {
  const auto value = [](std::string_view text) {
    return *read_json("{\"a\":" + std::string(text) + "}").entries.at(0).value;
  };
  EXPECT_EQ(value("-1.5e3"), Value(-1500.0));
  EXPECT_EQ(value("true"), Value(true));
  EXPECT_EQ(value("false"), Value(false));
  EXPECT_EQ(value("\"x\""), Value(std::string("x")));
  EXPECT_EQ(value("1e999"), Value(HUGE_VAL));
  for (const char* none : {"null", "NaN", "-Infinity", "undefined", "[1, {\"a\": \"]\"}]", "+1", ".5", "0x10"}) {
    EXPECT_TRUE(std::isnan(std::get<double>(value(none)))) << none;
  }
}

TEST(ReadJson, ResolvesEscapes) {
  EXPECT_EQ(flat(R"({"a\"b": "\\\/\b\f\n\r\tA\u00e4\ud83c\udf0d"})"), "a\"b=\\/\b\f\n\r\tAä🌍;");
  EXPECT_EQ(flat(R"({"a": "\ud83c-\udf0d\uzzzz\ud83c\u0041"})"),
            "a=\xef\xbf\xbd-\xef\xbf\xbd\xef\xbf\xbdzzzz\xef\xbf\xbd"
            "A;");
}

TEST(ReadJson, TakesABadValueForOneValue) {
  EXPECT_EQ(flat(R"({"waves": {"count": [[1], 2], "speed": NaN, "length": {"deep": {}}, "seed": 5}})"),
            "waves.count=[[1], 2];waves.speed=NaN;waves.length={\"deep\": {}};waves.seed=5;");
}

TEST(ReadJson, YieldsWhatStandsBeforeABreak) {
  EXPECT_EQ(flat(R"({"a": 1, "b": 2)"), "a=1;Line 1, column 16: the text breaks off; the rest was not read.");
  EXPECT_EQ(flat(R"({"a": 1, "b": "tw)"), "a=1;Line 1, column 18: the text breaks off; the rest was not read.");
  EXPECT_EQ(flat("{\"a\": 1,\n \"b\" 2}"),
            "a=1;Line 2, column 6: a colon should stand here, not \"2}\"; the rest was not read.");
  EXPECT_EQ(flat(R"({"a": 1,})"),
            "a=1;Line 1, column 9: a name in quotes should stand here, not \"}\"; the rest was not "
            "read.");
  EXPECT_EQ(flat(R"({"a": 1 "b": 2})"),
            "Line 1, column 9: a comma or a closing brace should stand here, not "
            "\"\"b\": 2}\"; the rest was not read.");
  EXPECT_EQ(flat(R"({"a": 1} {})"),
            "a=1;Line 1, column 10: the scene ends, but the text goes on; the rest was not read.");
}

TEST(ReadJson, SaysWhereThereIsNoScene) {
  EXPECT_EQ(flat(""), "The text is empty; a scene is a JSON object, at least {}.");
  EXPECT_EQ(flat("  "), "The text is empty; a scene is a JSON object, at least {}.");
  EXPECT_EQ(flat("[1, 2]"), "A scene is a JSON object, {…}, and this begins with \"[1, 2]\".");
}

// The entries of each object of the list, then those of the text itself.
std::string listed(std::string_view json) {
  std::string text;
  const JsonReading reading = read_json(json, {"walk", "steps"});
  for (const std::vector<Entry>& item : reading.list) {
    for (const Entry& entry : item) text += entry.path + "=" + entry.text + ";";
    text += "|";
  }
  for (const Entry& entry : reading.entries) text += entry.path + "=" + entry.text + ";";
  return text + reading.trouble;
}

TEST(ReadJson, ReadsTheListOfAForm) {
  EXPECT_EQ(listed(R"({"a": 1, "steps": [{"x": 1, "y": [2]}, {}, 7, "z"], "b": 2})"),
            "x=1;y=[2];||=7;|=z;|a=1;steps=[…];b=2;");
  EXPECT_EQ(listed(R"({"steps": [ ]})"), "steps=[…];");
  EXPECT_EQ(listed(R"({"steps": 3, "group": {"steps": [{"x": 1}]}})"), "steps=3;group.steps=[{\"x\": 1}];");
  EXPECT_EQ(listed(R"({"steps": [{"x": 1}, {"x": 2)"),
            "x=1;|steps=[…];Line 1, column 29: the text breaks off; the rest was not read.");
  EXPECT_EQ(listed(R"({"steps": [1}, "b": 2})"),
            "steps=[…];Line 1, column 13: a comma or a closing bracket should stand here, not \"}, \"b\": 2}\"; the "
            "rest was not read.");
  EXPECT_EQ(listed("7"), "A walk is a JSON object, {…}, and this begins with \"7\".");
}

TEST(ReadJson, KnowsNoListWhereTheFormHasNone) {
  EXPECT_EQ(flat(R"({"": [{"x": 1}], "steps": [{"x": 1}]})"), "=[{\"x\": 1}];steps=[{\"x\": 1}];");
}

// Wherever a text breaks off, there is a sentence, and no value that the whole text does not have.
TEST(ReadJson, NeverMakesUpAValue) {
  const std::string whole =
      R"({"terrella":1,"title":"a \u00e4","waves":{"count":15,"speed":0.125},"x":[[1,"]"]],"y":true})";
  const JsonReading all = read_json(whole);
  ASSERT_EQ(all.trouble, "");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const JsonReading part = read_json(std::string_view(whole).substr(0, length));
    EXPECT_NE(part.trouble, "") << length;
    ASSERT_LE(part.entries.size(), all.entries.size());
    for (std::size_t i = 0; i < part.entries.size(); ++i) {
      EXPECT_EQ(part.entries[i].path, all.entries[i].path) << length;
      EXPECT_EQ(part.entries[i].text, all.entries[i].text) << length;
    }
  }
}

TEST(ReadJson, BearsAnyDepth) {
  const std::string open(100'000, '['), close(100'000, ']');
  EXPECT_EQ(read_json("{\"a\":" + open + close + ",\"b\":1}").entries.size(), 2u);
  EXPECT_NE(read_json("{\"a\":" + open).trouble, "");
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
  EXPECT_NE(read_json(objects).trouble, "");
}

TEST(ReadJson, DoesNotRepeatALongNameForEachOfItsMembers) {
  std::string json = "{\"" + std::string(500'000, 'g') + "\":{\"a\":1";
  for (int i = 0; i < 50'000; ++i) json += ",\"a\":1";
  const JsonReading reading = read_json(json + "}}");
  ASSERT_EQ(reading.entries.size(), 50'001u);
  EXPECT_LT(reading.entries[0].path.size(), 100u);
}

}  // namespace
}  // namespace terrella
