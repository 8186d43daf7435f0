#include "app/preset_pictures.hpp"

#include <algorithm>

#include "planet/needs.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

constexpr int width = 128, height = 72;  // pixels
constexpr int oversampling = 2;          // along each side; the copy takes the mean of so many

// Maps no finer than such a picture shows.
Scene at_small_size(Scene scene) {
  scene.quality.ground_texels = 128;
  scene.quality.cloud_texels = 96;
  return scene;
}

// As the default planet is seen: of one of real size a program for miniatures shows the whole as well, but no ground
// nearby.
Scene from_afar(Scene scene) {
  const Scene usual;
  const double altitude = usual.camera.altitude / usual.planet.radius * scene.planet.radius;
  scene.camera.altitude = std::max(scene.camera.altitude, altitude);
  scene.camera.pitch = usual.camera.pitch;
  return scene;
}

}  // namespace

void PresetPictures::advance() {
  if (complete()) return;
  if (!renderer_) renderer_ = std::make_unique<Renderer>();
  Scene scene = at_small_size(presets()[pictures_.size()].scene);
  if (lacks_real_size(scene)) scene = from_afar(scene);
  View view;
  view.width = oversampling * width;
  view.height = oversampling * height;
  if (renderer_->prepare(scene, view, Effort::live) < 1.0) return;
  renderer_->draw(scene, view, {});
  pictures_.push_back(std::make_unique<gl::Target>(width, height, gl::Format::rgba8, gl::Depth::none));
  renderer_->show({pictures_.back()->framebuffer(), width, height}, false);
  gl::make_opaque(*pictures_.back());
  if (complete()) renderer_.reset();
}

bool PresetPictures::complete() const { return pictures_.size() == presets().size(); }

std::vector<unsigned> PresetPictures::textures() const {
  std::vector<unsigned> names;
  for (const auto& picture : pictures_) names.push_back(picture->image().name());
  return names;
}

}  // namespace terrella
