// The map of a planet as a texture, made a few rows at a time.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "gl/texture.hpp"
#include "planet/surface_map.hpp"

namespace terrella {

class MapPicture {
 public:
  MapPicture();

  // Makes further rows of a scene's map for some time (ms), one at least; where the planet has changed, those that are
  // there are replaced one by one. Returns whether there was anything to make. What the context binds is other than
  // before.
  bool advance(const Scene& scene, double time);

  // Its name, northernmost row first.
  [[nodiscard]] unsigned texture() const { return image_.name(); }

 private:
  // What a map depends on.
  struct Subject {
    decltype(Scene::planet) planet;
    decltype(Scene::terrain) terrain;
    decltype(Scene::water) water;
    bool operator==(const Subject&) const = default;
  };

  gl::Image image_;
  std::vector<glm::vec4> row_;
  std::optional<Subject> subject_;
  std::optional<SurfaceMap> map_;
  int next_ = 0, left_ = 0;  // rows
};

}  // namespace terrella
