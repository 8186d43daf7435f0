#include "measure/moment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "measure/cases.hpp"
#include "measure/image_error.hpp"
#include "measure/studio.hpp"
#include "measure/subject.hpp"
#include "planet/needs.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

// Else a setting could be judged where its clouds are exact by chance.
TEST(Moment, LiesAThirdOfTheWayBetweenCloudsOfEverySetting) {
  for (const Preset& preset : presets()) {
    for (const double loss : {0.5, 0.2, 0.12, 0.03, 0.008, 0.001}) {
      Scene scene = preset.scene;
      scene.quality.cloud_loss = loss;
      const View view;
      const double interval = needs_of(scene, view, pose_of(scene, view)).cloud_interval;
      if (interval == 0.0) continue;
      const double steps = judged_at(scene) / interval, part = steps - std::floor(steps);
      EXPECT_NEAR(std::min(part, 1.0 - part), 1.0 / 3.0, 1e-9) << preset.name << ", " << loss;
    }
  }
}

TEST(Moment, IsTheBeginningWhereCloudsHardlyChange) {
  Scene scene;
  for (const double speed : {0.0, 1e-9}) {
    scene.clouds.speed = speed;
    EXPECT_EQ(judged_at(scene), 0.0);
  }
}

TEST(Moment, ShowsHowOftenCloudsAreRenewed) {
  const test::Studio studio;
  Scene scene = find_preset("temperate")->scene;
  make_cheap(scene);
  scene.quality.pixel_error = 0.75;
  scene.quality.cloud_texels = 256;
  Subject subject(96, 54);
  const auto picture = [&](double loss) {
    scene.quality.cloud_loss = loss;
    return subject.pose(scene);
  };
  const Image exact = picture(0.001);
  const double seldom = psnr(picture(0.5), exact), often = psnr(picture(0.03), exact);
  if (std::getenv("TERRELLA_PRINT") != nullptr) std::printf("clouds seldom %.1f dB, often %.1f dB\n", seldom, often);
  EXPECT_GT(often, seldom + 20.0);  // measured: 48.7 and 27.6
}

}  // namespace
}  // namespace terrella
