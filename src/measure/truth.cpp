#include "measure/truth.hpp"

#include <algorithm>
#include <cmath>

#include "app/develop.hpp"
#include "measure/image_error.hpp"
#include "measure/moment.hpp"
#include "planet/pose.hpp"

namespace terrella {
namespace {

// Adds a picture of so many samples a pixel to a mean of others.
void add(Image& mean, int samples, const Image& light, int more) {
  const float share = static_cast<float>(more) / static_cast<float>(samples + more);
  for (std::size_t i = 0; i < mean.pixels.size(); ++i) mean.pixels[i] += share * (light.pixels[i] - mean.pixels[i]);
}

}  // namespace

Truth::Truth(const Scene& scene, int width, int height, const Goal& goal, const std::function<void(double)>& progress)
    : scene_(scene) {
  reference::Options how;
  how.width = width;
  how.height = height;
  how.seconds = judged_at(scene);
  Image mean;
  // Grids of 2x2, 3x3, 4x4 … samples have hardly a place in common.
  for (int n = 2; samples_ + n * n <= goal.most_samples && self_psnr_ < goal.psnr; ++n) {
    how.samples = n;
    how.progress = [&](double part) { progress((samples_ + part * n * n) / goal.most_samples); };
    const Image light = reference::light(scene, how);
    const Image before = std::move(picture_);
    if (samples_ == 0) {
      mean = light;
    } else {
      // Of independent samples, each off by a variance v: the two differ by v / samples_ + v / n^2.
      const double apart = mean_square_error(before, developed(light, scene.picture.tone));
      const double variance = apart / (1.0 / samples_ + 1.0 / (n * n));
      self_psnr_ = psnr_of(variance / (samples_ + n * n));
      add(mean, samples_, light, n * n);
    }
    samples_ += n * n;
    picture_ = developed(mean, scene.picture.tone);
  }
  flip_.emplace(picture_);
  progress(1.0);
}

double Truth::mean_square_error_of(const Image& picture) const {
  // The samples of the one know nothing of the other's: their errors add up. Only half of it is taken off where that is
  // most of it, as it is an estimate.
  const double all = mean_square_error(picture, picture_), own = std::pow(10.0, -0.1 * self_psnr_);
  return std::max(all - own, 0.5 * all);
}

const reference::Geometry& Truth::geometry(int width, int height) {
  const auto found = geometries_.find({width, height});
  if (found != geometries_.end()) return found->second;
  View view;
  view.width = width;
  view.height = height;
  const Pose pose = pose_of(scene_, view);
  const double pixel = pose.pixel_angle * pose.nearest;
  reference::Options how;
  how.width = width;
  how.height = height;
  how.seconds = judged_at(scene_);
  how.left_out = {pixel, pixel, pixel};
  return geometries_.emplace(std::pair(width, height), reference::geometry(scene_, how)).first->second;
}

}  // namespace terrella
