#include <gtest/gtest.h>

#include <array>

#include "mutate.hpp"
#include "scene/json.hpp"
#include "scene/link.hpp"
#include "scene/preset_texts.hpp"
#include "scene/random_scene.hpp"
#include "targets.hpp"

// A fixed number of texts of each kind, the same in every run; `LLVMFuzzerTestOneInput` goes on from here for as long
// as one likes.
namespace terrella {
namespace {

constexpr int kTexts = 10'000;
constexpr int kScenes = 100;

constexpr auto kJsonWords = std::to_array<std::string_view>({"{",
                                                             "}",
                                                             "[",
                                                             "]",
                                                             ":",
                                                             ",",
                                                             "\"",
                                                             "\\",
                                                             "\\u",
                                                             "\\ud83c",
                                                             "\\u0000",
                                                             "null",
                                                             "true",
                                                             "NaN",
                                                             "-Infinity",
                                                             "1e999",
                                                             "-1e-999",
                                                             "0.1e",
                                                             "-",
                                                             "99999999999999999999",
                                                             "\xff",
                                                             "\xed\xa0\x80",
                                                             "\xef\xbb\xbf",
                                                             "\"terrella\":2,",
                                                             "{}",
                                                             "\"preset\":\"storm\",",
                                                             "\"preset\":\"strom\",",
                                                             "\"waves\":{\"count\":",
                                                             "\"wavs.count\":3,",
                                                             "\"sun\":7,",
                                                             "\"terrain\":{\"ridged\":0,",
                                                             "[[[[[[[[",
                                                             "{\"a\":{\"a\":",
                                                             "\"title\":\"x\",",
                                                             "/*",
                                                             "\n",
                                                             "\0"});

constexpr auto kLinkWords = std::to_array<std::string_view>({"&",
                                                             "=",
                                                             "?",
                                                             "#",
                                                             "%",
                                                             "%2",
                                                             "%zz",
                                                             "%00",
                                                             "%ff",
                                                             "%26",
                                                             "+",
                                                             "://",
                                                             "preset=",
                                                             "preset=moon",
                                                             "preset=mon",
                                                             "&&",
                                                             "waves.count=",
                                                             "wavs.count=3",
                                                             "panel=0",
                                                             "terrella=2",
                                                             "nan",
                                                             "1e999",
                                                             "-",
                                                             "true",
                                                             "%23ff8800",
                                                             "sun.color=",
                                                             "\xff"});

constexpr auto kPathWords = std::to_array<std::string_view>({"{",
                                                             "}",
                                                             "[",
                                                             "]",
                                                             ":",
                                                             ",",
                                                             "\"",
                                                             "{},",
                                                             "\"at\":0,",
                                                             "\"at\":1e9",
                                                             "-1",
                                                             "1e999",
                                                             "\"a\":1,",
                                                             "\"views\":[",
                                                             "latitude",
                                                             "\"fov\":1,",
                                                             "null",
                                                             "1e12",
                                                             "-90",
                                                             "180",
                                                             "\"at\":",
                                                             "\xff",
                                                             "NaN",
                                                             "\\u0000",
                                                             "\"terrella_path\":1,",
                                                             "[[[[",
                                                             "\"heading\":360,"});

std::vector<std::string> path_seeds() {
  return {
      R"({"terrella_path": 1, "views": [{}, {"latitude": 90, "altitude": 1e12}, {"altitude": 0, "at": 9}]})",
      R"({"terrella_path": 1, "views": [{"at": 0}, {"at": 1}, {"longitude": 180, "fov": 170}, {"pitch": 90}]})",
      R"({"terrella_path":1,"title":"x","views":[{"latitude":14,"heading":-360},{"latitude":-14,"longitude":180}]})"};
}

std::vector<std::string> json_seeds() {
  std::vector<std::string> seeds;
  for (const PresetText& file : preset_texts()) seeds.emplace_back(file.json);
  Random random(5);
  for (int i = 0; i < kScenes; ++i) seeds.push_back(to_json(random_document(random)));
  return seeds;
}

std::vector<std::string> link_seeds() {
  std::vector<std::string> seeds = {"https://example.org/index.html?preset=storm&waves.count=8&panel=0#top"};
  Random random(6);
  for (int i = 0; i < kScenes; ++i) seeds.push_back(to_link(random_document(random)));
  return seeds;
}

void run(char entry, const std::vector<std::string>& seeds, std::span<const std::string_view> words) {
  std::mt19937 random(2022);
  for (int i = 0; i < kTexts; ++i) {
    const std::string& seed = seeds[random() % seeds.size()];
    const std::string input = entry + mutated(seed, words, random);
    SCOPED_TRACE(i);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
  }
}

TEST(Fuzz, JsonIsLoadedOrAnswered) { run(0, json_seeds(), kJsonWords); }
TEST(Fuzz, LinksAreLoadedOrAnswered) { run(1, link_seeds(), kLinkWords); }
TEST(Fuzz, PathsAreFlownOrAnswered) { run(2, path_seeds(), kPathWords); }

}  // namespace
}  // namespace terrella
