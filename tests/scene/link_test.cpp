#include "scene/link.hpp"

#include <gtest/gtest.h>

#include "random_scene.hpp"

namespace terrella {
namespace {

using Sentences = std::vector<std::string>;

struct Followed {
  SceneDocument document;
  Sentences sentences;
};

Followed follow(std::string_view link) {
  Followed loaded;
  loaded.sentences = load_link(loaded.document, link).sentences();
  return loaded;
}

TEST(ToLink, HoldsOnlyWhatDiffersFromThePreset) {
  EXPECT_EQ(to_link({}), "");
  SceneDocument document{find_preset("storm")->scene, "storm"};
  EXPECT_EQ(to_link(document), "preset=storm");
  document.scene.waves.steepness = 0.9;
  document.scene.sun.color = {255, 136, 0};
  EXPECT_EQ(to_link(document), "preset=storm&sun.color=ff8800&waves.steepness=0.9");
}

TEST(Link, RoundTripsRandomScenes) {
  Random random(43);
  for (int i = 0; i < 1000; ++i) {
    const SceneDocument document = random_document(random);
    const std::string link = to_link(document);
    const Followed loaded = follow(link);
    ASSERT_EQ(loaded.sentences, Sentences{}) << link;
    ASSERT_EQ(loaded.document, document) << link;
    ASSERT_EQ(follow("https://example.org/a/index.html?" + link + "#there").document, document) << link;
  }
}

TEST(Link, EscapesTheNameOfAFile) {
  SceneDocument document;
  document.scene.terrain.map.name = "Große Erde #2 & 100%+.png";
  const std::string link = to_link(document);
  EXPECT_EQ(link, "terrain.map=Gro%C3%9Fe%20Erde%20%232%20%26%20100%25%2B.png");
  EXPECT_EQ(follow(link).document, document);
}

TEST(ToLink, NeedsNoEscapes) {
  Random random(44);
  for (int i = 0; i < 100; ++i) {
    const std::string link = to_link(random_document(random));
    // Names of files have theirs already.
    EXPECT_EQ(link.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.-=&%ABCDEF"), std::string::npos) << link;
  }
}

TEST(LoadLink, TakesAWholeLinkOrItsQuery) {
  SceneDocument expected;
  expected.scene.waves.count = 8;
  for (const char* link : {"waves.count=8", "?waves.count=8", "https://example.org/?waves.count=8",
                           "http://localhost:8000/index.html?panel=0&waves.count=8&pause=1#top", "&&waves.count=8&",
                           "waves%2Ecount=%38"}) {
    const Followed loaded = follow(link);
    EXPECT_EQ(loaded.sentences, Sentences{}) << link;
    EXPECT_EQ(loaded.document, expected) << link;
  }
  EXPECT_EQ(follow("https://example.org/index.html").document, SceneDocument{});
  EXPECT_EQ(follow("").sentences, Sentences{});
}

TEST(LoadLink, TakesAColorInEachSpelling) {
  for (const char* link :
       {"sun.color=ff8800", "sun.color=%23ff8800", "sun.color=#FF8800", "http://a/?sun.color=%23ff8800"}) {
    EXPECT_EQ(follow(link).document.scene.sun.color, (Color{255, 136, 0})) << link;
  }
}

TEST(LoadLink, SaysEachThingThatIsWrongAndAppliesTheRest) {
  const Followed loaded = follow(
      "preset=moom&wavs.count=3&waves.count=8&waves.steepness=2&terrain.ridged=maybe&water.model=still+water&sun.color="
      "%2"
      "&sun.latitude=%ff&waves.seed&waves.speed=1&waves.speed=2&terrella=9&ui=1");
  EXPECT_EQ(loaded.sentences, (Sentences{
                                  "\"sun.color=%2\" is not percent-encoded UTF-8 text.",
                                  "\"sun.latitude=%ff\" is not percent-encoded UTF-8 text.",
                                  "preset: there is no preset \"moom\"; did you mean moon?",
                                  "terrella: version 9 is not known; this program reads version 1.",
                                  "wavs.count: there is no such parameter; did you mean waves.count?",
                                  "waves.steepness: 2 is out of range; allowed are 0 to 1.",
                                  "terrain.ridged: \"maybe\" is neither true nor false; allowed are true or false.",
                                  "water.model: \"still water\" is not a choice; allowed are none, auto, calm, waves.",
                                  "waves.seed: \"\" is not a whole number; allowed are 0 to 999999.",
                                  "waves.speed: is given more than once; the last one counts.",
                                  "ui: there is no such parameter.",
                              }));
  SceneDocument expected;
  expected.scene.waves.count = 8;
  expected.scene.waves.speed = 2;
  EXPECT_EQ(loaded.document, expected);
}

TEST(LoadLink, RefusesWhatIsTooLong) {
  const Followed loaded = follow("waves.count=8&" + std::string(100'000, 'x'));
  EXPECT_EQ(loaded.sentences, Sentences{"The link is 100014 bytes long; at most 65536 are read."});
  EXPECT_EQ(loaded.document, SceneDocument{});
}

}  // namespace
}  // namespace terrella
