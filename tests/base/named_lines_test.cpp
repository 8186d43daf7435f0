#include "base/named_lines.hpp"

#include <gtest/gtest.h>

namespace terrella {
namespace {

TEST(NamedLines, AreReadAsTheyWereWritten) {
  NamedLines written;
  written.add("search", "sea level");
  written.add("empty", "");
  written.add("share", 0.1);
  written.add("tail", "ü {}");
  const std::vector<NamedLine> lines = lines_of(written.text());
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0].name, "search");
  EXPECT_EQ(lines[0].words, "sea level");
  EXPECT_EQ(lines[0].number(), 0.0);
  EXPECT_EQ(lines[1].name, "empty");
  EXPECT_EQ(lines[1].words, "");
  EXPECT_EQ(lines[2].number(), 0.1);
  EXPECT_EQ(lines[3].words, "ü {}");
}

TEST(NamedLines, NoWordsEndThem) {
  NamedLines lines;
  lines.add("notice", "one\ntwo\tthree\r");
  EXPECT_EQ(lines.text(), "notice one two three \n");
}

TEST(NamedLines, OfWhateverTextThereAreSome) {
  EXPECT_TRUE(lines_of("").empty());
  for (const std::string text : {"name", "name\n", "name "}) {
    ASSERT_EQ(lines_of(text).size(), 1U) << text;
    EXPECT_EQ(lines_of(text)[0].name, "name") << text;
    EXPECT_EQ(lines_of(text)[0].words, "") << text;
  }
  EXPECT_EQ(lines_of("\n\n").size(), 2U);
}

}  // namespace
}  // namespace terrella
