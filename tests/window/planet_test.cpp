// What is seen of the planet, and what hands do with it.
#include <gtest/gtest.h>

#include "window/patience.hpp"
#include "window/window_fixture.hpp"

namespace terrella::test {
namespace {

constexpr const char* link_at_first = "preset=moon&time.speed=0&quality.resolution_scale=0.25";

TEST_F(UsersWindowTest, ShowsAPlanetBeforeADarkSkyAndAPanel) {
  const Picture seen = screen->picture();
  EXPECT_GT(brightness(seen, kPlanet), 60.0);
  EXPECT_LT(brightness(seen, kSky), 15.0);
  EXPECT_EQ(copied_link(), link_at_first);
}

TEST_F(UsersWindowTest, ADragTurnsThePlanet) {
  const Picture before = settled();
  hands->point(640, 340);
  hands->press();
  hands->point(700, 350);
  hands->point(780, 360);
  EXPECT_TRUE(changes(before, kPlanet));
  settled();  // held still, so that it is no throw
  hands->release();
  const std::string link = copied_link();
  EXPECT_NE(link.find("&camera.longitude="), std::string::npos) << link;
}

TEST_F(UsersWindowTest, AMovementWithoutAPressTurnsNothing) {
  const Picture before = settled();
  hands->point(640, 340);
  hands->point(780, 360);
  EXPECT_LT(difference(settled(), before, kPlanet), 0.1);
  EXPECT_EQ(copied_link(), link_at_first);
}

TEST_F(UsersWindowTest, InFlightEAndQRollTheCamera) {
  const Picture before = settled();
  hands->tap({"2"});
  hands->tap({"e"});
  EXPECT_TRUE(changes(before, kPlanet));
  settled();
  const std::string link = copied_link();
  EXPECT_NE(link.find("&camera.roll="), std::string::npos) << link;
  EXPECT_EQ(link.find("&camera.heading="), std::string::npos) << link;
}

TEST_F(UsersWindowTest, NBringsANewPlanetAndCtrlZTakesItBack) {
  const Picture before = settled();
  hands->tap({"n"});
  ASSERT_TRUE(changes(before, kPlanet));
  hands->tap({"Control_L", "z"});
  EXPECT_TRUE(becomes(before, kPlanet));
  EXPECT_EQ(copied_link(), link_at_first);
}

}  // namespace
}  // namespace terrella::test
