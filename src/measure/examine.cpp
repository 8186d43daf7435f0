#include "measure/examine.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>

#include "base/milliseconds.hpp"
#include "base/text.hpp"
#include "gl/api.hpp"
#include "measure/cost.hpp"
#include "passes/frame.hpp"
#include "planet/validity.hpp"

namespace terrella {
namespace {

constexpr int bytes_a_pixel = 16;

// The last of the errors since it was last asked; 0 where there were none.
unsigned take_gl_error() {
  unsigned last = 0;
  for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError()) last = error;
  return last;
}

std::vector<float> draw(Renderer& renderer, const Case& entry, Channel channel) {
  renderer.draw(entry.scene, entry.view, {channel, Effort::complete, true});
  return renderer.read_light();
}

std::int64_t lying_normals(Pixels normals) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i + 3 < normals.size(); i += 4) {
    const double x = normals[i], y = normals[i + 1], z = normals[i + 2];
    const double length = std::sqrt(x * x + y * y + z * z);
    const bool sky = length == 0.0;
    if (!sky && !(std::abs(length - 1.0) < 1e-4)) ++count;
  }
  return count;
}

std::optional<BesideReference> compared(Renderer& renderer, Case entry) {
  constexpr int fewest_pixels = 16;
  if (std::min(entry.view.width, entry.view.height) < fewest_pixels) return std::nullopt;
  make_comparable(entry.scene);
  const std::vector<float> light = draw(renderer, entry, Channel::color);
  if (!beyond_validity(entry.scene, entry.view, renderer.pose(), renderer.needs()).empty()) return std::nullopt;
  return beside_reference(entry.scene, entry.view, light, draw(renderer, entry, Channel::distance));
}

}  // namespace

bool Findings::clean() const { return text().empty(); }

std::string Findings::text() const {
  std::string text;
  const auto say = [&](const std::string& sentence) { text += (text.empty() ? "" : " ") + sentence; };
  if (nonfinite > 0) say(text_of(nonfinite, " pixels of light are not finite."));
  if (holes.open > 0) say(text_of(holes.open, " of ", holes.looked_at, " pixels show a hole in the planet."));
  if (lying > 0) say(text_of(lying, " normals are not of unit length."));
  if (!repeats) say("Drawn again, the picture is another one.");
  if (gl_error != 0) say(text_of("OpenGL tells of error ", gl_error, "."));
  for (const std::string& sentence : over_cost) say(sentence);
  if (reference && !reference->same_light())
    say(text_of("Light is off the reference's by ", reference->light, " in the mean."));
  if (reference && !reference->same_silhouette())
    say(text_of("Only one of picture and reference shows the planet in ", 100.0 * reference->silhouette,
                " % of places."));
  return text;
}

Findings examine(Renderer& renderer, const Case& entry, bool beside) {
  const auto start = std::chrono::steady_clock::now();
  take_gl_error();
  Findings found;
  const std::vector<float> light = draw(renderer, entry, Channel::color);
  found.nonfinite = nonfinite_pixels(light);
  const std::vector<float> distance = draw(renderer, entry, Channel::distance);
  // In water what lies too far to be seen is not drawn.
  if (!renderer.needs().in_water)
    found.holes = find_holes(distance, renderer.pose(), entry.view, solid_radius(renderer.needs()));
  found.lying = lying_normals(draw(renderer, entry, Channel::normal));
  const std::vector<float> again = draw(renderer, entry, Channel::color);
  found.repeats = found.nonfinite > 0 || again == light;
  found.over_cost = beyond(renderer.stats(), promised_cost(renderer.needs(), entry.view, bytes_a_pixel));
  if (beside) found.reference = compared(renderer, entry);
  found.gl_error = take_gl_error();
  found.milliseconds = milliseconds_since(start);
  return found;
}

}  // namespace terrella
