#include "base/utf8.hpp"

#include <gtest/gtest.h>

namespace terrella {
namespace {

TEST(Utf8, EveryCodePointIsOneCharacter) {
  for (std::uint32_t code = 1; code <= 0x10ffff; ++code) {
    std::string text;
    append_utf8(text, code);
    ASSERT_EQ(utf8_length(text), text.size()) << code;
    ASSERT_EQ(find_not_utf8(text), std::string::npos) << code;
  }
}

TEST(Utf8, SurrogatesAndWhatIsTooLargeAreReplaced) {
  for (const std::uint32_t code : {0xd800u, 0xdfffu, 0x110000u, 0xffffffffu}) {
    std::string text;
    append_utf8(text, code);
    EXPECT_EQ(text, "\xef\xbf\xbd");
  }
}

TEST(Utf8, WhatIsNotUtf8IsFoundAndRepaired) {
  const char* const bad[] = {
      "\xff",
      "\x80",              // no lead bytes
      "\xc3",              // cut off
      "\xc3(",             // not followed by what was promised
      "\xc0\xaf",          // overlong
      "\xed\xa0\x80",      // a surrogate
      "\xf4\x90\x80\x80",  // beyond U+10FFFF
  };
  for (const char* bytes : bad) {
    const std::string text = std::string("ä") + bytes + "z";
    EXPECT_EQ(find_not_utf8(text), 2u);
    const std::string repaired = repaired_utf8(text);
    EXPECT_EQ(find_not_utf8(repaired), std::string::npos);
    EXPECT_TRUE(repaired.starts_with("ä") && repaired.ends_with("z"));
  }
}

TEST(Utf8, GoodTextIsNotChanged) { EXPECT_EQ(repaired_utf8("Grüße, 地球 🌍"), "Grüße, 地球 🌍"); }

}  // namespace
}  // namespace terrella
