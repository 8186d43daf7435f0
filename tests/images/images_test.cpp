// Pictures as the program draws them, small.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "app/still.hpp"
#include "base/numbers.hpp"
#include "effort.hpp"
#include "measure/image_error.hpp"
#include "native/egl_context.hpp"
#include "scene/choices.hpp"
#include "scene/parameters.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

StillOptions small(int width = 160, int height = 90) {
  StillOptions options;
  options.width = width;
  options.height = height;
  return options;
}

double mean(const Image& image) {
  double sum = 0.0;
  for (const float value : image.pixels) sum += double{value};
  return sum / static_cast<double>(image.pixels.size());
}

// A renderer with its own context, for one kind of OpenGL.
struct Studio {
  explicit Studio(Api api = Api::core) : context(std::move(*EglContext::make(api))) {}
  std::unique_ptr<EglContext> context;
  Renderer renderer;
};

TEST(Sun, ShowsItsDiscAndGlareBesideThePlanetAndNothingBehindIt) {
  Studio studio;
  Scene scene = find_preset("moon")->scene;
  scene.stars.density = 0.0;
  scene.camera.latitude = scene.camera.longitude = 0.0;
  scene.camera.altitude = 1.0;
  scene.camera.heading = -90.0;
  scene.camera.pitch = -60.0;
  scene.sun.latitude = 0.0;
  scene.sun.longitude = -144.0;  // six degrees off the limb
  const Image beside = take_picture(studio.renderer, scene, small());
  EXPECT_EQ(*std::max_element(beside.pixels.begin(), beside.pixels.end()), 1.0F);
  EXPECT_GT(mean(beside), 0.02);
  scene.sun.longitude = -170.0;
  EXPECT_LT(mean(take_picture(studio.renderer, scene, small())), 0.01);
}

TEST(Rings, AreSeenBesideThePlanetHiddenBehindItAndShadeIt) {
  Studio studio;
  Scene bare = find_preset("temperate")->scene;
  bare.stars.density = bare.lights.density = 0.0;
  bare.quality.antialias = false;  // the shadow's edges would be smoothed
  bare.sun.latitude = 20.0;
  bare.sun.longitude = 0.0;
  bare.camera.latitude = -10.0;
  bare.camera.altitude = 4.0;
  Scene ringed = bare;
  ringed.rings.density = 1.0;
  const Image with = take_picture(studio.renderer, ringed, small()),
              none = take_picture(studio.renderer, bare, small());
  const auto brightness = [](const Image& image, int x, int y) { return image.at(x, y)[0] + image.at(x, y)[1]; };
  // The planet is 21 pixels in radius, the rings end at 50; seen from below, their far side stands below the middle.
  EXPECT_EQ(brightness(none, 80 - 35, 45), 0.0F);
  EXPECT_GT(brightness(with, 80 - 35, 45), 0.05F);
  EXPECT_EQ(brightness(with, 80 - 75, 45), 0.0F);
  int darker = 0, brighter = 0;
  for (int y = 45; y < 45 + 18; ++y) {
    for (int x = 75; x <= 85; ++x) {
      darker += brightness(with, x, y) < 0.8F * brightness(none, x, y) ? 1 : 0;
      brighter += brightness(with, x, y) > brightness(none, x, y) + 0.01F ? 1 : 0;
    }
  }
  EXPECT_GT(darker, 40);
  EXPECT_EQ(brighter, 0);
}

TEST(Lights, ShowOnTheNightSideAndNotByDay) {
  Studio studio;
  Scene scene = find_preset("temperate")->scene;
  scene.clouds.coverage = 0.0;
  Scene dark = scene;
  dark.lights.density = 0.0;
  for (const bool night : {false, true}) {
    scene.camera.longitude = dark.camera.longitude = night ? 122.0 : -58.0;  // under the sun, and opposite
    scene.camera.latitude = dark.camera.latitude = night ? -16.0 : 16.0;
    const Image with = take_picture(studio.renderer, scene, small(320, 180));
    const std::size_t programs = studio.renderer.stats().programs.size();
    const Image without = take_picture(studio.renderer, dark, small(320, 180));
    EXPECT_EQ(studio.renderer.stats().programs.size() + 1, programs);  // what is not wanted is not held
    if (night) {
      EXPECT_GT(mean(with), 1.01 * mean(without));
      EXPECT_GT(largest_difference(with.pixels, without.pixels), 0.2);
    } else {
      EXPECT_EQ(largest_difference(with.pixels, without.pixels), 0.0);
    }
  }
}

TEST(Pictures, AreTheSameFromDesktopAndEmbeddedOpenGl) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  for (const char* name : {"temperate", "storm", "moon", "lava"}) {
    const Scene& scene = find_preset(name)->scene;
    Image core, es;
    {
      Studio studio(Api::core);
      core = take_picture(studio.renderer, scene, small());
    }
    {
      Studio studio(Api::es);
      es = take_picture(studio.renderer, scene, small());
    }
    EXPECT_LE(largest_difference(core.pixels, es.pixels), 2.0 / 255.0) << name;
  }
}

TEST(Pictures, OfEveryPresetShowAPlanetAndAreFinite) {
  Studio studio;
  const auto step = static_cast<std::size_t>(test::by_effort(1, 1, 5));
  for (std::size_t i = 0; i < presets().size(); i += step) {
    const Preset& preset = presets()[i];
    const Image light = take_measurement(studio.renderer, preset.scene, small(), Channel::color);
    EXPECT_TRUE(all_finite(light.pixels)) << preset.name;
    EXPECT_GT(mean(light), 0.01) << preset.name;
    const Image distance = take_measurement(studio.renderer, preset.scene, small(), Channel::distance);
    EXPECT_TRUE(std::isfinite(distance.at(80, preset.name == "dusk" ? 80 : 60)[0])) << preset.name;
  }
}

// What crawls or shimmers while the planet turns: by how much the error of a picture, taken as its difference from one
// of 16 samples a pixel, changes over a tenth of a degree, from nearer than half a radius over as much less, root of
// the mean square. Motion itself is in both and cancels out.
double crawling(Renderer& renderer, Scene scene) {
  StillOptions one = small(240, 135), many = one;
  many.samples = 4;
  const Image before = take_picture(renderer, scene, one), exact_before = take_picture(renderer, scene, many);
  const double turn = 0.1 * std::min(1.0, pose_of(scene, {}).nearest / 0.5);
  scene.camera.longitude += turn;
  scene.sun.longitude += turn;
  const Image after = take_picture(renderer, scene, one), exact_after = take_picture(renderer, scene, many);
  double squares = 0.0;
  for (std::size_t i = 0; i < before.pixels.size(); ++i) {
    const double change =
        (double{after.pixels[i]} - exact_after.pixels[i]) - (double{before.pixels[i]} - exact_before.pixels[i]);
    squares += change * change;
  }
  return std::sqrt(squares / static_cast<double>(before.pixels.size()));
}

TEST(Pictures, HardlyCrawlWhileThePlanetTurns) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  Studio studio;
  const auto step = static_cast<std::size_t>(test::by_effort(1, 3));
  for (std::size_t i = 0; i < presets().size(); i += step) {
    // Measured, in steps of 8 bits: dusk 1.1, temperate 2.8, lava 5.1, storm 5.6, alps 6.9; the others in between.
    EXPECT_LT(255.0 * crawling(studio.renderer, presets()[i].scene), 7.5) << presets()[i].name;
  }
}

TEST(Pictures, AreTheSameWhenDrawnAgainAndInAnyOrder) {
  Studio studio;
  const Scene& scene = find_preset("temperate")->scene;
  const Image first = take_picture(studio.renderer, scene, small());
  StillOptions later = small();
  later.seconds = 31.4;
  take_picture(studio.renderer, find_preset("storm")->scene, later);
  EXPECT_EQ(largest_difference(first.pixels, take_picture(studio.renderer, scene, small()).pixels), 0.0);
}

TEST(Pictures, SettleFromCoarseToTheCompleteOne) {
  const Scene& scene = find_preset("temperate")->scene;
  View view;
  view.width = 160;
  view.height = 90;
  Studio studio;
  const auto light = [&](Effort effort) {
    studio.renderer.draw(scene, view, {Channel::color, effort, true});
    return studio.renderer.read_light();
  };
  const std::vector<float> coarse = light(Effort::live);
  EXPECT_FALSE(studio.renderer.settled());
  int frames = 0;
  std::vector<float> settled = coarse;
  for (; frames < 200 && !studio.renderer.settled(); ++frames) settled = light(Effort::live);
  EXPECT_TRUE(studio.renderer.settled());
  EXPECT_GT(frames, 3);
  Studio other;
  other.renderer.draw(scene, view, {Channel::color, Effort::complete, true});
  EXPECT_EQ(settled, other.renderer.read_light());
  EXPECT_NE(settled, coarse);
}

TEST(Pictures, DrawnInPartsAreTheSameBitByBit) {
  struct Place {
    const char* preset;
    double altitude, pitch;  // 0: the preset's own
    glm::dvec2 shift;
  };
  Studio studio;
  Renderer& renderer = studio.renderer;
  for (const Place& place :
       {Place{"temperate", 0.0, 0.0, {20.0, 0.0}}, Place{"storm", 0.0, 0.0, {0.0, -15.0}}, Place{"night", 0.0, 0.0, {}},
        Place{"alps", 0.0, 0.0, {}}, Place{"rings", 0.0, 0.0, {}}, Place{"storm", 2e-3, -20.0, {}},
        Place{"ocean", 0.05, -35.0, {}}, Place{"alps", 0.02, -10.0, {0.0, 10.0}}, Place{"temperate", 0.0, 60.0, {}}}) {
    Scene scene = find_preset(place.preset)->scene;
    if (place.altitude > 0.0) scene.camera.altitude = place.altitude * scene.planet.radius;
    if (place.pitch != 0.0) scene.camera.pitch = place.pitch;
    View view;
    view.width = 320;
    view.height = 180;
    view.seconds = 3.0;
    view.shift = place.shift;
    renderer.draw(scene, view, {});
    const std::vector<float> light = renderer.read_light();
    for (int picture = 0; picture < 2; ++picture) {  // the second finds its geometry where the first has left it
      renderer.begin(scene, view, {});
      for (const Rows& rows : {Rows{0, 37}, Rows{90, 180}, Rows{37, 38}, Rows{38, 90}}) renderer.draw_rows(rows);
      EXPECT_EQ(light, renderer.read_light()) << place.preset << ' ' << place.altitude;
    }
  }
}

TEST(Pictures, SoonLackNothingAndCompleteOnesNever) {
  const Scene& scene = find_preset("temperate")->scene;
  View view;
  view.width = 160;
  view.height = 90;
  Studio studio, patient;
  const gl::Target target(view.width, view.height, gl::Format::rgba8, gl::Depth::none);
  const gl::Screen screen = {target.framebuffer(), view.width, view.height};
  const auto show = [&](Renderer& renderer, Effort effort) {
    renderer.draw(scene, view, {Channel::color, effort, false});
    renderer.show(screen, true);
    return target.read_bytes();
  };
  const std::vector<unsigned char> all = show(patient.renderer, Effort::complete);
  EXPECT_TRUE(patient.renderer.whole());
  EXPECT_NE(show(studio.renderer, Effort::live), all);
  EXPECT_FALSE(studio.renderer.whole());
  int frames = 1;
  for (; frames < 200 && !studio.renderer.whole(); ++frames) show(studio.renderer, Effort::live);
  EXPECT_TRUE(studio.renderer.whole());
  for (; frames < 200 && !studio.renderer.settled(); ++frames) show(studio.renderer, Effort::live);
  EXPECT_EQ(show(studio.renderer, Effort::live), all);
}

TEST(Pictures, DrawnSoonestAreOfTheAirAlone) {
  View view;
  view.width = 160;
  view.height = 90;
  const auto draws_ground = [](const Studio& studio) {
    const std::vector<std::string> programs = studio.renderer.stats().programs;
    return std::find(programs.begin(), programs.end(), "ground/icosphere") != programs.end();
  };
  Studio airy, airless;
  airy.renderer.draw(find_preset("temperate")->scene, view, {Channel::color, Effort::soonest, false});
  EXPECT_TRUE(airy.renderer.only_air());
  EXPECT_FALSE(airy.renderer.whole());
  EXPECT_FALSE(draws_ground(airy));
  const std::vector<float> light = airy.renderer.read_light();
  EXPECT_GT(*std::max_element(light.begin(), light.end()), 0.1F);
  airy.renderer.draw(find_preset("temperate")->scene, view, {Channel::color, Effort::live, false});
  EXPECT_FALSE(airy.renderer.only_air());
  EXPECT_TRUE(draws_ground(airy));

  airless.renderer.draw(find_preset("moon")->scene, view, {Channel::color, Effort::soonest, false});
  EXPECT_FALSE(airless.renderer.only_air());
  EXPECT_TRUE(draws_ground(airless));
}

TEST(Pictures, OfASettledPlanetComputeNoNoiseForTheGround) {
  Scene scene = find_preset("moon")->scene;
  View view;
  view.width = 160;
  view.height = 90;
  Studio studio;
  studio.renderer.draw(scene, view, {});
  EXPECT_GT(studio.renderer.stats().noise_evaluations, 1'000'000);
  for (int i = 0; i < 3; ++i) {
    scene.camera.longitude += 1.0;
    studio.renderer.draw(scene, view, {});
    EXPECT_EQ(studio.renderer.stats().noise_evaluations, 0);
  }
}

TEST(Pictures, DoNotChangeWhenAllLengthsAreScaled) {
  Studio studio;
  const Scene& scene = find_preset("temperate")->scene;
  const Image a = take_picture(studio.renderer, scene, small());
  const Image b = take_picture(studio.renderer, scaled(scene, 1048576.0), small());
  EXPECT_LE(largest_difference(a.pixels, b.pixels), 1.0 / 255.0);
}

TEST(Pictures, ConvergeAsTheMeshAndTheMapsGrowFiner) {
  Studio studio;
  Scene scene = find_preset("temperate")->scene;
  scene.clouds.model = choice("clouds.model", "none");
  const auto at = [&](double pixel_error, int texels) {
    scene.quality.pixel_error = pixel_error;
    scene.quality.ground_texels = texels;
    return take_measurement(studio.renderer, scene, small(), Channel::color);
  };
  const Image reference = at(0.1, 1024);
  const double coarse = psnr(at(16.0, 128), reference), middle = psnr(at(4.0, 256), reference);
  const double fine = psnr(at(0.5, 512), reference), finer = psnr(at(0.2, 512), reference);
  EXPECT_GT(middle, coarse);
  EXPECT_GT(fine, middle);
  EXPECT_GT(finer, fine);
  EXPECT_GT(fine, 23.5);  // measured: 24.1
  EXPECT_GT(finer, 30.0);
}

// How much neighbouring pixels differ within a rectangle of a picture.
double roughness(const Image& image, int left, int top, int right, int bottom) {
  double sum = 0.0;
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) sum += std::abs(double{image.at(x + 1, y)[0]} - double{image.at(x, y)[0]});
  }
  return sum / ((right - left) * (bottom - top));
}

// A beach from close by, of which the water's mesh draws the left part: it lies lower than that mesh. Measured: 0.45 of
// the roughness of the steeper ground beside it; 0.06 without the layers that are finer than the map.
TEST(Shore, OnTheWatersMeshShowsTheLayersOfTheGroundBesideIt) {
  Studio studio;
  Scene scene = find_preset("temperate")->scene;
  scene.camera.latitude = 0.5;
  scene.camera.longitude = 1.5;
  scene.camera.altitude = 0.06;
  scene.camera.pitch = -90.0;
  scene.clouds.coverage = 0.0;
  scene.air.density = 0.0;
  const Image image = take_picture(studio.renderer, scene, small(320, 180));
  const double on_water = roughness(image, 5, 5, 65, 90), on_ground = roughness(image, 120, 5, 180, 90);
  EXPECT_GT(on_ground, 0.005);
  EXPECT_GT(on_water, 0.4 * on_ground);
}

TEST(Clouds, FromCloseByAreThoseOfAFinerMap) {
  Studio studio;
  Scene scene;
  scene.terrain.model = scene.water.model = 0;
  scene.camera.altitude = 0.35;
  scene.clouds.warp = scene.clouds.swirl = scene.clouds.speed = 0.0;  // what pixels add is not stirred
  const auto with = [&](int texels, int octaves) {
    scene.quality.cloud_texels = texels;
    scene.clouds.octaves = octaves;
    return take_picture(studio.renderer, scene, small(320, 180));
  };
  const Image fine = with(1024, 10), coarse = with(128, 10);
  EXPECT_EQ(studio.renderer.needs().cloud_octaves, 4);
  EXPECT_EQ(studio.renderer.needs().cloud_pixel_first, 3);
  EXPECT_EQ(studio.renderer.needs().cloud_pixel_end, 8);
  // Measured: 29.0 dB; with the layers of the map alone 22.2 dB.
  EXPECT_GT(psnr(coarse, fine), 28.0);
  EXPECT_LT(psnr(with(128, 4), fine), 24.0);
}

TEST(Pictures, WithManySamplesAgreeWithOneSample) {
  Studio studio;
  Scene scene = find_preset("moon")->scene;
  StillOptions many = small();
  many.samples = 3;
  const Image one = take_picture(studio.renderer, scene, small()), nine = take_picture(studio.renderer, scene, many);
  EXPECT_GT(psnr(one, nine), 28.0);
  EXPECT_GT(largest_difference(one.pixels, nine.pixels), 0.0);
}

TEST(Pictures, DrawnInTilesAreThoseDrawnAtOnce) {
  Studio studio;
  for (const char* name : {"temperate", "storm", "rings", "fjords"}) {
    Scene scene = find_preset(name)->scene;
    for (const bool alone : {false, true}) {
      StillOptions whole = small(), tiled = small();
      whole.transparent = tiled.transparent = alone;
      tiled.largest_tile = 64;
      const Image at_once = take_picture(studio.renderer, scene, whole);
      const Image in_tiles = take_picture(studio.renderer, scene, tiled);
      // Dither begins anew in each tile; edges are smoothed a little differently. Measured: 50.8 dB and 0.14, of cut
      // out ones 55.7 dB and 0.0074, which is two steps of 8 bits.
      EXPECT_GT(psnr(at_once, in_tiles), 49.0) << name << alone;
      EXPECT_LT(largest_difference(at_once.pixels, in_tiles.pixels), alone ? 0.008 : 0.2) << name << alone;
    }
  }
}

TEST(Pictures, CanShowThePlanetAloneWithItsOpacity) {
  Studio studio;
  const Scene scene = find_preset("temperate")->scene;
  StillOptions alone = small(), fine = small();
  alone.transparent = true;
  fine.samples = 2;
  const Image cut = take_picture(studio.renderer, scene, alone), whole = take_picture(studio.renderer, scene, fine);
  ASSERT_EQ(cut.channels, 4);
  EXPECT_EQ(cut.at(0, 0)[3], 0.0F);
  EXPECT_EQ(cut.at(80, 45)[3], 1.0F);
  int partly = 0;
  double furthest = 0.0;
  for (int y = 0; y < cut.height; ++y) {
    for (int x = 0; x < cut.width; ++x) {
      const float opacity = cut.at(x, y)[3];
      if (opacity > 0.0F && opacity < 1.0F) ++partly;
      if (opacity < 1.0F) continue;
      for (int c = 0; c < 3; ++c) {
        furthest = std::fmax(furthest, std::abs(double{cut.at(x, y)[c]} - double{whole.at(x, y)[c]}));
      }
    }
  }
  EXPECT_GT(partly, 100);  // air and edges
  EXPECT_LT(furthest, 1e-6);
}

TEST(Distance, IsThatOfTheSphereWhereTheGroundIsFlat) {
  Studio studio;
  Scene scene;
  scene.terrain.height = 0.0;
  scene.water.model = choice("water.model", "none");
  scene.planet.radius = 2000.0;
  scene.quality.pixel_error = 0.05;
  scene.camera.altitude = 3000.0;
  const StillOptions options = small();
  const Image distance = take_measurement(studio.renderer, scene, options, Channel::distance);
  const Image height = take_measurement(studio.renderer, scene, options, Channel::height);
  const Image normal = take_measurement(studio.renderer, scene, options, Channel::normal);
  View view;
  view.width = options.width;
  view.height = options.height;
  const Pose pose = pose_of(scene, view);
  const double allowed = scene.quality.pixel_error * pixel_of_height(pose);
  int hits = 0;
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) {
      const glm::dvec3 ray = ray_through(pose, view, {x + 0.5, y + 0.5});
      const double along = -glm::dot(pose.eye, ray);
      const glm::dvec3 foot = pose.eye + along * ray;
      const double half2 = 1.0 - glm::dot(foot, foot);
      if (half2 < -0.01) {
        EXPECT_EQ(distance.at(x, y)[0], std::numeric_limits<float>::infinity());
        EXPECT_EQ(normal.at(x, y)[0], 0.0F);
      } else if (half2 > 0.05) {
        ++hits;
        const glm::dvec3 place = pose.eye + (along - std::sqrt(half2)) * ray;
        // The flat triangles dip by a bit more than their edges' middles; a grazing ray sees that the longer.
        EXPECT_NEAR(distance.at(x, y)[0] / 2000.0, along - std::sqrt(half2), 1.4 * allowed / std::sqrt(half2));
        EXPECT_NEAR(height.at(x, y)[0] / 2000.0, 0.0, 2e-3);
        const float* n = normal.at(x, y);
        EXPECT_LT(glm::distance(glm::dvec3(n[0], n[1], n[2]), place), 5e-3);
      }
    }
  }
  EXPECT_GT(hits, 500);
}

// What lies under water is left out, triangle by triangle: nowhere may one look through the planet for it.
TEST(Distance, IsThatOfTheNearSideWhateverWavesHide) {
  Studio studio;
  for (const char* name : {"temperate", "archipelago", "storm", "lava"}) {
    Scene scene = find_preset(name)->scene;
    StillOptions options = small(240, 135);
    for (const double amplitude : {0.0, 0.004, 0.02}) {
      scene.waves.count = amplitude > 0.0 ? 8 : 0;
      scene.waves.amplitude = amplitude;
      options.seconds += 3.7;
      const Image distance = take_measurement(studio.renderer, scene, options, Channel::distance);
      View view;
      view.width = options.width;
      view.height = options.height;
      view.seconds = options.seconds;
      const Pose pose = pose_of(scene, view);
      int hits = 0;
      for (int y = 0; y < options.height; ++y) {
        for (int x = 0; x < options.width; ++x) {
          const glm::dvec3 ray = ray_through(pose, view, {x + 0.5, y + 0.5});
          const double along = -glm::dot(pose.eye, ray);
          const glm::dvec3 foot = pose.eye + along * ray;
          if (glm::dot(foot, foot) > 0.98) continue;  // lower than that no flat triangle dips
          ++hits;
          EXPECT_LT(double{distance.at(x, y)[0]}, along) << name << ' ' << amplitude << " at " << x << ' ' << y;
        }
      }
      EXPECT_GT(hits, 2000) << name;
    }
  }
}

TEST(Memory, DoesNotGrow) {
  const Scene& scene = find_preset("temperate")->scene;
  Studio studio;
  View view;
  view.width = 32;
  view.height = 18;
  std::int64_t after_warming_up = 0;
  for (int i = 0; i < 400; ++i) {
    view.seconds = i * 0.1;
    studio.renderer.draw(scene, view, {Channel::color, Effort::live, false});
    if (i == 100) after_warming_up = studio.renderer.stats().gpu_bytes;
  }
  EXPECT_EQ(studio.renderer.stats().gpu_bytes, after_warming_up);
}

TEST(Memory, OfTheDefaultSceneIsWithinItsBudget) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  Studio studio;
  View view;  // 1280x720
  studio.renderer.draw(find_preset("temperate")->scene, view, {Channel::color, Effort::live, false});
  for (int i = 0; i < 40; ++i)
    studio.renderer.draw(find_preset("temperate")->scene, view, {Channel::color, Effort::live, false});
  EXPECT_LE(studio.renderer.stats().gpu_bytes, 48'000'000);
  EXPECT_LE(studio.renderer.stats().programs.size(), 12U);
}

}  // namespace
}  // namespace terrella
