// What a camera truly sees: pictures by the reference, of as many samples as it takes to judge others by them.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "base/image.hpp"
#include "measure/flip.hpp"
#include "reference/picture.hpp"
#include "scene/scene.hpp"

namespace terrella {

class Truth {
 public:
  // When to stop adding samples. psnr: dB that the picture is to be within of one of endlessly many samples;
  // most_samples: a pixel, whatever has been reached.
  struct Goal {
    double psnr;
    int most_samples;
  };

  // At the moment of judged_at. width, height: pixels, >= 1. progress: is told now and then which part is done, 0..1.
  Truth(const Scene& scene, int width, int height, const Goal& goal, const std::function<void(double)>& progress);

  // sRGB, 3 channels, 0..1, as take_picture gives it.
  [[nodiscard]] const Image& picture() const { return picture_; }
  // How far it is likely to be from a picture of endlessly many samples, dB: told by how far its parts, which share no
  // samples, are from each other. Errors that near say nothing.
  [[nodiscard]] double self_psnr() const { return self_psnr_; }
  [[nodiscard]] int samples() const { return samples_; }
  // Of a picture beside one of endlessly many samples: what this one is off itself does not count against it, as far as
  // that is known. Of values 0..1.
  [[nodiscard]] double mean_square_error_of(const Image& picture) const;
  // How a picture beside this one looks, as flip has it.
  [[nodiscard]] Image flip_of(const Image& picture) const { return flip_->against(picture); }

  // What is seen in the middle of each pixel of a picture of that size, without the layers that no pixel can show.
  // Made when it is first asked for.
  const reference::Geometry& geometry(int width, int height);

 private:
  Scene scene_;
  Image picture_;
  std::optional<Flip> flip_;
  double self_psnr_ = 0.0;
  int samples_ = 0;
  std::map<std::pair<int, int>, reference::Geometry> geometries_;
};

}  // namespace terrella
