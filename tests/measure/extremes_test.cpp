// The real renderer at the ends of what can be asked of it. `terrella measure --extremes` draws more.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "gl/caps.hpp"
#include "measure/examine.hpp"
#include "measure/extent.hpp"
#include "measure/studio.hpp"
#include "scene/link.hpp"
#include "scene/parameters.hpp"

namespace terrella {
namespace {

class Extremes : public testing::TestWithParam<Api> {};

TEST_P(Extremes, AreDrawnFiniteWholeAndWithinTheirCost) {
  test::Studio studio(GetParam());
  ASSERT_TRUE(gl::caps().full_float_targets);
  const std::vector<Case> cases = extreme_cases(test::extent);
  // Both kinds run the same shaders but for their first lines: each draws others.
  const auto step = static_cast<std::size_t>(test::by_effort(1, 3, 1));
  const std::size_t first = GetParam() == Api::core ? 0 : step / 2;
  std::int64_t looked_at = 0;
  int drawn = 0, compared = 0;
  for (std::size_t number = first; number < cases.size(); number += step) {
    const Case& entry = cases[number];
    const Findings found = examine(studio.renderer, entry, compared_with_reference(number));
    ++drawn;
    compared += found.reference ? 1 : 0;
    EXPECT_TRUE(found.clean()) << entry.group << ", " << entry.name << ": " << found.text() << '\n'
                               << to_link({entry.scene});
    looked_at += found.holes.looked_at;
  }
  EXPECT_GT(looked_at, 10'000);  // that no hole was found says something
  EXPECT_GT(compared, drawn / 20);
}

INSTANTIATE_TEST_SUITE_P(OnBothKinds, Extremes, testing::Values(Api::core, Api::es),
                         [](const auto& kind) { return kind.param == Api::core ? "core" : "es"; });

TEST(ExtremeCases, HaveNamesOfTheirOwnAndReachEveryEnd) {
  std::set<std::string> names;
  std::set<double> radii, fields, times;
  for (const Case& entry : extreme_cases(Extent::full)) {
    EXPECT_TRUE(names.insert(entry.group + '/' + entry.name).second) << entry.name;
    radii.insert(entry.scene.planet.radius);
    fields.insert(entry.scene.camera.fov);
    times.insert(entry.view.seconds);
  }
  for (const double radius : {1.0, 1e8}) EXPECT_TRUE(radii.contains(radius));
  for (const double field : {1.0, 170.0}) EXPECT_TRUE(fields.contains(field));
  for (const double time : {0.0, 1e9}) EXPECT_TRUE(times.contains(time));
  for (const Parameter& parameter : parameters()) {
    if (parameter.type != Type::Float) continue;
    for (const double end : {parameter.min, parameter.max}) {
      EXPECT_TRUE(names.contains("single/" + std::string(parameter.path) + " = " + to_text(Value(end))));
    }
  }
}

}  // namespace
}  // namespace terrella
