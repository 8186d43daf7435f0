// What the program says of its range is what is measured.
#include "measure/limits.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "measure/extent.hpp"
#include "measure/studio.hpp"

namespace terrella {
namespace {

TEST(Limits, AreWhereTheProgramSaysThatTheyAre) {
  test::Studio studio;
  std::set<std::string> ends;
  for (const Limit& limit : measure_limits(studio.renderer, test::extent)) {
    const std::string name = limit.technique + ", " + limit.path + ", " + limit.unit;
    EXPECT_TRUE(limit.keeps_its_word()) << name << ": " << limit.worst_within() << " > " << limit.demand;
    EXPECT_GE(limit.points.size(), 5U) << name;
    bool warned = false;
    for (const LimitPoint& point : limit.points) warned = warned || point.warned;
    EXPECT_EQ(limit.ends(), warned) << name << ": it warns where nothing is wrong";
    if (limit.ends()) ends.insert(limit.technique + ' ' + limit.path);
  }
  // Of each range that is told of, what lies beyond was seen to be wrong.
  std::set<std::string> expected = {"ground terrain.frequency", "waves waves.length", "waves waves.speed"};
  if (test::extent != Extent::sample) {
    expected.insert({"clouds clouds.frequency", "ground terrain.height", "ripples camera.altitude", "sea water.level",
                     "waves camera.altitude"});
  }
  EXPECT_EQ(ends, expected);
}

}  // namespace
}  // namespace terrella
