#include "scene/morph.hpp"

#include <algorithm>
#include <cmath>

#include "scene/parameters.hpp"

namespace terrella {
namespace {

double between(double from, double to, double share, Scale scale) {
  const bool by_factors = scale == Scale::Logarithmic && from > 0.0 && to > 0.0;
  const double value = by_factors ? from * std::pow(to / from, share) : std::lerp(from, to, share);
  return std::clamp(value, std::min(from, to), std::max(from, to));  // rounding may lead beyond
}

class Morph {
 public:
  Morph(const Scene& from, const Scene& to, double share)
      : from_(from), to_(to), share_(share), scene_(share < 0.5 ? from : to) {
    scene_.planet.radius = between(from.planet.radius, to.planet.radius, share, Scale::Logarithmic);
  }

  void set(const Parameter& parameter) {
    const Field field = parameter.field(scene_);
    if (parameter.type == Type::Float) *std::get<double*>(field) = number(parameter);
    if (parameter.type == Type::Int && !parameter.is_seed()) *std::get<int*>(field) = whole(parameter);
    if (parameter.type == Type::Color) {
      *std::get<Color*>(field) =
          mixed(std::get<Color>(parameter.get(from_)), std::get<Color>(parameter.get(to_)), share_);
    }
  }

  const Scene& scene() const { return scene_; }

 private:
  double number(const Parameter& parameter) const {
    const double from = std::get<double>(parameter.get(from_)), to = std::get<double>(parameter.get(to_));
    const bool same_size = from_.planet.radius == to_.planet.radius;
    if (same_size || !parameter.grows_with_planet()) return between(from, to, share_, parameter.scale);
    const double part = between(from / from_.planet.radius, to / to_.planet.radius, share_, parameter.scale);
    return std::clamp(part * scene_.planet.radius, parameter.min, parameter.max);
  }

  int whole(const Parameter& parameter) const {
    const double value =
        between(std::get<int>(parameter.get(from_)), std::get<int>(parameter.get(to_)), share_, parameter.scale);
    return static_cast<int>(std::lround(value));
  }

  const Scene& from_;
  const Scene& to_;
  double share_;
  Scene scene_;
};

}  // namespace

Scene morph(const Scene& from, const Scene& to, double share) {
  if (!(share > 0.0)) return from;
  if (share >= 1.0) return to;
  Morph morph(from, to, share);
  for (const Parameter& parameter : parameters()) morph.set(parameter);
  return morph.scene();
}

}  // namespace terrella
