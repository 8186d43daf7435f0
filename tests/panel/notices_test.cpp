#include "panel/notices.hpp"

#include "hand.hpp"

namespace terrella {
namespace {

TEST(NoticeOf, AParameterIsTakenFromTheBeginning) {
  Scene scene;
  const std::string text = assign_text(scene, "waves.steepness", "7")->text();
  const Notice notice = notice_of(text);
  EXPECT_EQ(notice.about, find_parameter("waves.steepness"));
  EXPECT_EQ(notice.suggested, nullptr);
  EXPECT_EQ("waves.steepness: " + notice.sentence, text);
}

TEST(NoticeOf, ASuggestionStaysInTheSentence) {
  const std::string text = no_such_parameter("wavs.count").text();
  const Notice notice = notice_of(text);
  EXPECT_EQ(notice.about, nullptr);
  EXPECT_EQ(notice.suggested, find_parameter("waves.count"));
  EXPECT_EQ(notice.sentence, text);
}

TEST(NoticeOf, OtherSentencesAreAboutNothing) {
  for (const std::string text : {"", ": ", "preset: there is no preset \"strom\"; did you mean storm?",
                                 "did you mean ?", "did you mean", "Saved as waves.steepness: it is.", "and 3 more."}) {
    const Notice notice = notice_of(text);
    EXPECT_EQ(notice.about, nullptr) << text;
    EXPECT_EQ(notice.suggested, nullptr) << text;
    EXPECT_EQ(notice.sentence, text);
  }
}

TEST_F(PanelTest, AClickOnANoticesParameterShowsIt) {
  facts.notices = {"waves.steepness: 7 is out of range; allowed are 0 to 1.",
                   "skool.count: there is no such parameter; did you mean waves.count?"};
  frames(2);
  EXPECT_EQ(click("notice/waves.steepness"), PanelWishes{});
  EXPECT_EQ(count_of("waves.steepness"), 1);
  EXPECT_EQ(count_of("waves.count"), 0);
  click("notice/waves.count");
  EXPECT_EQ(count_of("waves.steepness"), 0);
  EXPECT_EQ(count_of("waves.count"), 1);
  EXPECT_EQ(document, SceneDocument{});
}

TEST_F(PanelTest, NoticesAreShownUntilDismissed) {
  EXPECT_EQ(count_of("dismiss"), 0);
  facts.notices = {"waves.steepness: 7 is out of range; allowed are 0 to 1.", "%s%n, as it was given\u2026"};
  frames(2);
  EXPECT_TRUE(click("dismiss").dismiss_notices);
}

TEST_F(PanelTest, WhatLiesBeyondTheRangeIsShownForAsLongAsItDoes) {
  facts.beyond = {"terrain.frequency: 100 cells in a radius are more than the mesh of the ground can raise."};
  frames(2);
  EXPECT_EQ(count_of("notice/terrain.frequency"), 1);
  EXPECT_EQ(count_of("dismiss"), 0);  // it is the scene that must change
  EXPECT_EQ(click("notice/terrain.frequency"), PanelWishes{});
  EXPECT_EQ(count_of("terrain.frequency"), 1);
  facts.beyond.clear();
  frames(2);
  EXPECT_EQ(count_of("notice/terrain.frequency"), 0);
}

TEST_F(PanelTest, ASentenceWhoseNumbersChangeUnderTheHandStaysALink) {
  facts.beyond = {"camera.altitude: 0.001 m over the surface ripples swim."};
  frames(2);
  point_at("notice/camera.altitude");
  press();
  facts.beyond = {"camera.altitude: 0.002 m over the surface ripples swim."};
  release();
  frames(2);
  EXPECT_EQ(count_of("camera.altitude"), 1);
}

}  // namespace
}  // namespace terrella
