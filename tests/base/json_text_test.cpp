#include "base/json_text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace terrella {
namespace {

TEST(JsonText, IsReadAsWhatItWasMadeOf) {
  const std::string text = json_object({{"a", "1"},
                                        {"none", ""},
                                        {"list", json_list({"1.5", json_object({}), json_list({})})},
                                        {"texts", json_texts({"a \"quoted\" \\ one", "two\nlines", "ü"})}});
  const nlohmann::json expected = {{"a", 1},
                                   {"list", {1.5, nlohmann::json::object(), nlohmann::json::array()}},
                                   {"texts", {"a \"quoted\" \\ one", "two\nlines", "ü"}}};
  EXPECT_EQ(nlohmann::json::parse(text), expected);
}

}  // namespace
}  // namespace terrella
