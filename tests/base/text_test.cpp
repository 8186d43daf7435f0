#include "base/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <nlohmann/json.hpp>

namespace terrella {
namespace {

TEST(FormatNumber, ReadsWell) {
  EXPECT_EQ(format_number(0), "0");
  EXPECT_EQ(format_number(0.1), "0.1");
  EXPECT_EQ(format_number(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(format_number(6371000), "6371000");
  EXPECT_EQ(format_number(1e8), "1e8");
  EXPECT_EQ(format_number(-1.25e12), "-1.25e12");
  EXPECT_EQ(format_number(1203000000), "1.203e9");
  EXPECT_EQ(format_number(-2e5), "-2e5");
  EXPECT_EQ(format_number(2.5e-7), "2.5e-7");
  EXPECT_EQ(format_number(1e300), "1e300");
}

TEST(FormatNumber, SaysWhatIsNotFinite) {
  const double endless = std::numeric_limits<double>::infinity();
  EXPECT_EQ(format_number(endless), "inf");
  EXPECT_EQ(format_number(-endless), "-inf");
  EXPECT_EQ(format_number(std::nan("")), "nan");
}

TEST(FormatNumber, ReadsBackAsTheSameDouble) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100'000; ++i) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    const std::optional<double> back = parse_number(format_number(value));
    ASSERT_TRUE(back) << format_number(value);
    ASSERT_EQ(*back, value);
  }
}

TEST(ParseNumber, TakesWhatJsonTakesAndNothingElse) {
  for (const char* text : {"0", "-0", "1.5", "-1e3", "1E+3", "10", "0.001", "1e-400"}) {
    EXPECT_TRUE(parse_number(text)) << text;
    EXPECT_TRUE(nlohmann::json::accept(text)) << text;
  }
  for (const char* text : {"", "-", "+1", " 1", "1 ", ".5", "5.", "1e", "1e+", "0x10", "nan", "inf", "01", "1,5"}) {
    EXPECT_FALSE(parse_number(text)) << text;
  }
}

TEST(ParseTypedNumber, TakesWhatPeopleType) {
  const std::pair<const char*, double> typed[] = {{".5", 0.5},    {"-.5", -0.5}, {"+1", 1.0},   {"5.", 5.0},
                                                  {"+.25", 0.25}, {"-3.", -3.0}, {"1.e3", 1e3}, {"1.5", 1.5}};
  for (const auto& [text, value] : typed) EXPECT_EQ(parse_typed_number(text), value) << text;
  for (const char* text : {"", ".", "-.", "+", "-", "+-1", "++1", "..5", ".e3", "1,5", "0x10"}) {
    EXPECT_FALSE(parse_typed_number(text)) << text;
  }
}

TEST(ParseNumber, MakesAnInfinityOfWhatIsTooLarge) {
  EXPECT_EQ(parse_number("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_number("-1e999"), -std::numeric_limits<double>::infinity());
}

TEST(Shortened, CutsBetweenCharactersAndSaysSo) {
  EXPECT_EQ(shortened("storm", 5), "storm");
  EXPECT_EQ(shortened("storms", 5), "storm…");
  EXPECT_EQ(shortened("äöüß", 3), "äöü…");
  EXPECT_EQ(shortened("a\nb\x1b[31m"), "a b [31m");
  EXPECT_EQ(shortened("a\xff"), "a?");
}

TEST(JsonQuoted, IsReadBackByAnotherReader) {
  for (const std::string text : {"", "a\"b", "back\\slash", "line\nbreak", "\x01\x7f", "Größe 🌍"}) {
    EXPECT_EQ(nlohmann::json::parse(json_quoted(text)).get<std::string>(), text);
  }
}

TEST(TextOf, PutsItsPiecesTogether) {
  EXPECT_EQ(text_of("at most ", 8, ' ', true, ' ', 0.5, std::string_view(" m")), "at most 8 true 0.5 m");
  EXPECT_EQ(text_of(), "");
}

}  // namespace
}  // namespace terrella
