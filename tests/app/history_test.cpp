#include "app/history.hpp"

#include <gtest/gtest.h>

#include "scene/presets.hpp"

namespace terrella {
namespace {

class HistoryTest : public testing::Test {
 protected:
  HistoryTest() { history.start(now); }

  void steepness(double value, double seconds) {
    now.document.scene.waves.steepness = value;
    history.note(now, seconds);
  }
  void longitude(double value, double seconds) {
    now.document.scene.camera.longitude = value;
    history.note(now, seconds);
  }
  double undone() { return (now = history.undo()).document.scene.waves.steepness; }
  double redone() { return (now = history.redo()).document.scene.waves.steepness; }
  int steps_back() {
    int count = 0;
    for (; history.can_undo(); ++count) now = history.undo();
    return count;
  }

  Snapshot now;
  History history;
  const double first = Scene{}.waves.steepness;
};

TEST_F(HistoryTest, AtFirstNothingLeadsAnywhere) {
  EXPECT_FALSE(history.can_undo());
  EXPECT_FALSE(history.can_redo());
  history.note(now, 1.0);
  EXPECT_FALSE(history.can_undo());
}

TEST_F(HistoryTest, ADragIsOneStepHoweverLongItTakes) {
  history.begin();
  for (int i = 1; i <= 9; ++i) steepness(0.1 * i, 10.0 * i);
  EXPECT_EQ(undone(), first);
  EXPECT_FALSE(history.can_undo());
  EXPECT_EQ(redone(), 0.1 * 9);
  EXPECT_FALSE(history.can_redo());
}

TEST_F(HistoryTest, EachPressIsAStepOfItsOwn) {
  for (int i = 1; i <= 3; ++i) {
    history.begin();
    steepness(0.1 * i, 0.1 * i);
  }
  EXPECT_EQ(undone(), 0.1 * 2);
  EXPECT_EQ(undone(), 0.1);
  EXPECT_EQ(undone(), first);
}

TEST_F(HistoryTest, NotchesOnOneParameterGoTogetherUntilTheyRest) {
  for (const double seconds : {1.0, 1.5, 2.0, 2.8}) {  // the last one comes after a rest
    history.go_on(History::Means::wheel, seconds);
    steepness(0.1 * seconds, seconds);
  }
  EXPECT_EQ(undone(), 0.1 * 2.0);
  EXPECT_EQ(undone(), first);
  EXPECT_FALSE(history.can_undo());
}

TEST_F(HistoryTest, NotchesOnAnotherParameterAreAnotherStep) {
  history.go_on(History::Means::wheel, 1.0);
  steepness(0.1, 1.0);
  history.go_on(History::Means::wheel, 1.1);
  now.document.scene.waves.spread = 0.1;
  history.note(now, 1.1);
  EXPECT_EQ(steps_back(), 2);
}

TEST_F(HistoryTest, NotchesThatChangeSeveralParametersGoTogetherToo) {
  for (int i = 1; i <= 3; ++i) {
    history.go_on(History::Means::wheel, 0.1 * i);
    now.document.scene.waves.spread = 0.1 * i;
    steepness(0.1 * i, 0.1 * i);
  }
  EXPECT_EQ(undone(), first);
  EXPECT_FALSE(history.can_undo());
}

TEST_F(HistoryTest, TheCameraIsOneThingAndAHeldKeyOneStep) {
  for (int i = 1; i < 100; ++i) {
    const double seconds = 0.03 * i;
    if (i % 2 == 1) history.go_on(History::Means::keys, seconds);  // as a held key repeats
    now.document.scene.camera.latitude += 0.1;
    if (i % 3 == 0) now.document.scene.camera.altitude *= 0.99;
    history.note(now, seconds);
  }
  EXPECT_EQ(steps_back(), 1);
}

TEST_F(HistoryTest, AnotherMeansIsAnotherStep) {
  history.go_on(History::Means::wheel, 1.0);
  longitude(10.0, 1.0);
  history.go_on(History::Means::keys, 1.1);
  longitude(20.0, 1.1);
  history.begin();
  longitude(30.0, 1.2);
  history.go_on(History::Means::wheel, 1.3);
  longitude(40.0, 1.3);
  EXPECT_EQ(steps_back(), 4);
}

TEST_F(HistoryTest, ThePlanetThatRunsOnAfterAThrowBelongsToTheThrow) {
  history.begin();
  for (int i = 1; i < 50; ++i) longitude(i, 0.1 * i);
  EXPECT_EQ(steps_back(), 1);
}

TEST_F(HistoryTest, ANewChangeForgetsWhatWasUndone) {
  history.begin();
  steepness(0.1, 1.0);
  undone();
  EXPECT_TRUE(history.can_redo());
  steepness(0.2, 1.1);
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(undone(), first);
}

TEST_F(HistoryTest, AHandThatComesBackLeavesNoStep) {
  history.begin();
  steepness(0.1, 1.0);
  steepness(first, 3.0);
  EXPECT_FALSE(history.can_undo());
  history.begin();
  steepness(0.2, 5.0);
  EXPECT_EQ(steps_back(), 1);
}

TEST_F(HistoryTest, ADoubleClickThatPutsBackWhatItsFirstClickDidLeavesNoStep) {
  history.begin();
  steepness(0.1, 1.0);
  history.begin();
  history.take_back();
  steepness(first, 9.0);  // where frames are slow
  EXPECT_FALSE(history.can_undo());
  history.go_on(History::Means::keys, 3.0);
  steepness(0.5, 3.0);  // what was typed
  EXPECT_EQ(steps_back(), 1);
}

TEST_F(HistoryTest, AValuePutBackIsAStep) {
  history.begin();
  steepness(0.1, 1.0);
  history.begin();
  steepness(first, 1.1);
  EXPECT_EQ(undone(), 0.1);
  EXPECT_EQ(undone(), first);
}

TEST_F(HistoryTest, TheSceneThatWasOpenedComesBackWithItsDocument) {
  const Preset& storm = *find_preset("storm");
  history.begin();
  now.document = now.opened = {storm.scene, storm.name};
  history.note(now, 1.0);
  const Snapshot before = history.undo();
  EXPECT_EQ(before, Snapshot{});
  EXPECT_EQ(history.redo().opened.preset, "storm");
}

TEST_F(HistoryTest, KeepsTheLastStepsOnly) {
  const int count = static_cast<int>(History::most_steps);
  for (int i = 1; i <= count + 50; ++i) {
    history.begin();
    longitude(0.1 * i, i);
  }
  EXPECT_EQ(steps_back(), count);
  EXPECT_EQ(now.document.scene.camera.longitude, 0.1 * 50);
}

}  // namespace
}  // namespace terrella
