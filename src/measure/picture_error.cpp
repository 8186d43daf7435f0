#include "measure/picture_error.hpp"

#include "measure/image_error.hpp"

namespace terrella {

double PictureError::psnr() const { return psnr_of(mean_square); }

PictureError mean_of(const std::vector<PictureError>& errors) {
  PictureError mean;
  const double share = 1.0 / static_cast<double>(errors.size());
  for (const PictureError& e : errors) {
    mean.mean_square += share * e.mean_square;
    mean.flip += share * e.flip;
    mean.visible += share * e.visible;
    mean.silhouette += share * e.silhouette;
    mean.normal_median += share * e.normal_median;
    mean.normal_p99 += share * e.normal_p99;
  }
  return mean;
}

Judgement judge(const Image& picture, const DrawnGeometry& drawn, Truth& truth) {
  Judgement judgement;
  judgement.flip = truth.flip_of(picture);
  PictureError& error = judgement.error;
  error.mean_square = truth.mean_square_error_of(picture);
  error.flip = mean_of(judgement.flip);
  error.visible = visible_share(picture, truth.picture());
  const int width = drawn.distance.width, height = drawn.distance.height;
  const reference::Geometry& is = truth.geometry(width, height);
  const GeometryError geometry = geometry_error(drawn.distance, drawn.normal, is.distance, is.normal);
  error.normal_median = geometry.normal_median;
  error.normal_p99 = geometry.normal_p99;
  const double outline = outline_length(is.distance);
  const double shown_per_drawn = static_cast<double>(picture.width) / width;
  if (outline > 0.0) error.silhouette = geometry.silhouette * width * height / outline * shown_per_drawn;
  return judgement;
}

}  // namespace terrella
