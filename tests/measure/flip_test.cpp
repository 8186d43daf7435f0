#include "measure/flip.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "measure/image_error.hpp"

namespace terrella {
namespace {

Image plain(float r, float g, float b, int side = 32) {
  Image image(side, side, 3);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    image.pixels[i] = r;
    image.pixels[i + 1] = g;
    image.pixels[i + 2] = b;
  }
  return image;
}

void set(Image& image, int x, int y, float value) {
  for (int c = 0; c < 3; ++c) image.at(x, y)[c] = value;
}

TEST(Flip, OfOnePictureIsNothing) {
  const Image image = plain(0.3F, 0.5F, 0.7F);
  EXPECT_EQ(quantile_of(flip(image, image), 1.0), 0.0);
}

TEST(Flip, IsTheSameBothWays) {
  const Image a = plain(0.3F, 0.5F, 0.7F), b = plain(0.35F, 0.45F, 0.7F);
  EXPECT_NEAR(mean_of(flip(a, b)), mean_of(flip(b, a)), 1e-6);
}

// The largest difference that the measure knows is between green and blue.
TEST(Flip, ReachesFromAlikeToOne) {
  EXPECT_NEAR(mean_of(flip(plain(0, 1, 0), plain(0, 0, 1))), 1.0, 1e-3);
  // 0.9678 by the definition: black and white are 100 apart in lightness.
  EXPECT_NEAR(mean_of(flip(plain(0, 0, 0), plain(1, 1, 1))), 0.9678, 2e-3);
  const double small = mean_of(flip(plain(0.5F, 0.5F, 0.5F), plain(0.51F, 0.51F, 0.51F)));
  EXPECT_GT(small, 0.005);
  EXPECT_LT(small, 0.1);
}

TEST(Flip, GrowsWithTheDifference) {
  double last = 0.0;
  for (const float step : {0.01F, 0.05F, 0.1F, 0.3F}) {
    const double error = mean_of(flip(plain(0.4F, 0.4F, 0.4F), plain(0.4F + step, 0.4F, 0.4F)));
    EXPECT_GT(error, last);
    last = error;
  }
}

TEST(Flip, SeesPointsAndEdgesWhereTheyAre) {
  const Image flat = plain(0.5F, 0.5F, 0.5F);
  Image point = flat, edge = flat;
  set(point, 16, 16, 1.0F);
  for (int y = 0; y < 32; ++y) {
    for (int x = 16; x < 32; ++x) set(edge, x, y, 0.55F);
  }
  EXPECT_GT(double{*flip(flat, point).at(16, 16)}, 0.3);
  EXPECT_LT(double{*flip(flat, point).at(2, 2)}, 1e-3);
  // Beside the edge both differ in colour by as much as elsewhere or less; the edge itself is what is seen.
  EXPECT_GT(double{*flip(flat, edge).at(16, 16)}, 1.05 * double{*flip(flat, edge).at(26, 16)} / 2.0);
  EXPECT_GT(double{*flip(flat, edge).at(15, 16)}, double{*flip(flat, edge).at(4, 16)});
}

TEST(GeometryError, TellsSilhouetteDistanceAndAngleApart) {
  Image distance(2, 2, 1), normal(2, 2, 3);
  for (int i = 0; i < 4; ++i) {
    distance.pixels[static_cast<std::size_t>(i)] = 10.0F;
    normal.pixels[static_cast<std::size_t>(3 * i)] = 1.0F;
  }
  EXPECT_EQ(geometry_error(distance, normal, distance, normal).distance_p99, 0.0);
  Image other = distance, turned = normal;
  other.pixels[0] = INFINITY;
  EXPECT_EQ(geometry_error(other, normal, distance, normal).silhouette, 0.25);
  other.pixels[0] = 11.0F;
  EXPECT_NEAR(geometry_error(other, normal, distance, normal).distance_p99, 0.1, 1e-6);
  EXPECT_EQ(geometry_error(other, normal, distance, normal).distance_median, 0.0);
  turned.pixels[0] = turned.pixels[1] = 1.0F;
  EXPECT_NEAR(geometry_error(distance, turned, distance, normal).normal_p99, 45.0, 1e-4);
}

TEST(Psnr, IsThatOfTheMeanSquare) {
  EXPECT_EQ(psnr(plain(0, 0, 0), plain(0, 0, 0)), 200.0);
  EXPECT_NEAR(psnr(plain(0, 0, 0), plain(0.1F, 0.1F, 0.1F)), 20.0, 1e-5);
}

}  // namespace
}  // namespace terrella
