#include "probe/map_argument.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/text.hpp"
#include "probe/scene_arguments.hpp"

namespace terrella::probe {

Arg map_argument() {
  constexpr Range sides{1.0, HeightMap::largest_side};
  return of_host(
      {"map",
       Kind::object,
       "",
       any,
       false,
       {},
       {{"width", Kind::whole, "", sides}, {"height", Kind::whole, "", sides}, {"heights", Kind::numbers, "", parts}}});
}

Result<SharedHeightMap> map_of_argument(const Json& args) {
  const Json& map = args["map"];
  const int width = static_cast<int>(number(map, "width")), height = static_cast<int>(number(map, "height"));
  std::string trouble = trouble_with_size("map", width, height);
  if (!trouble.empty()) return Failure{std::move(trouble)};
  const Json& given = map["heights"];
  const auto needed = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (given.size() != needed) {
    return Failure{text_of("map.heights: there are ", given.size(), " numbers; a map of ", width, "x", height, " has ",
                           needed, needed > kLongestList ? text_of(", but a request holds at most ", kLongestList) : "",
                           ".")};
  }
  std::vector<float> heights;
  heights.reserve(needed);
  for (const Json& one : given) heights.push_back(static_cast<float>(one.get<double>()));
  return make_height_map("map", width, height, std::move(heights));
}

Json made_up_map(Random& random) {
  const std::size_t height = 8 + random.below(25), width = height + random.below(3 * height + 1);
  const double roughness = random.chance(0.5) ? 1.0 : random.log_between(1e-3, 1.0);
  const glm::dvec3 hills = random.log_between(1.0, 8.0) * random.on_sphere();
  Json heights = Json::array();
  for (std::size_t i = 0; i < width * height; ++i) {
    const double longitude = turn * (static_cast<double>(i % width) + 0.5) / static_cast<double>(width);
    const double from_pole = 0.5 * turn * (static_cast<double>(i / width) + 0.5) / static_cast<double>(height);
    const double level = std::sin(from_pole);
    const glm::dvec3 place(level * std::cos(longitude), level * std::sin(longitude), std::cos(from_pole));
    const double hill = 0.5 + 0.5 * std::sin(glm::dot(hills, place));
    heights.push_back(rounded(std::clamp(std::lerp(hill, random.between(0.0, 1.0), roughness), 0.0, 1.0)));
  }
  return {{"width", width}, {"height", height}, {"heights", std::move(heights)}};
}

}  // namespace terrella::probe
