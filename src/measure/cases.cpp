#include "measure/cases.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <variant>

#include "base/text.hpp"
#include "measure/covering.hpp"
#include "scene/choices.hpp"
#include "scene/parameters.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

constexpr unsigned pairs_seed = 20260101U, random_seed = 81U;

struct Size {
  int width, height;
};

View view_of(Size size, double seconds = 0.0) {
  View view;
  view.width = size.width;
  view.height = size.height;
  view.seconds = seconds;
  return view;
}

constexpr Size small = {64, 36};

// The values of a parameter that count as its ends.
std::vector<Value> ends_of(const Parameter& parameter) {
  switch (parameter.type) {
    case Type::Float: return {parameter.min, parameter.max};
    case Type::Int: return {static_cast<int>(parameter.min), static_cast<int>(parameter.max)};
    case Type::Bool: return {false, true};
    case Type::Color: return {Color::from_hex(0x000000), Color::from_hex(0xffffff)};
    case Type::File: return {};
    case Type::Choice: break;
  }
  std::vector<Value> names;
  for (const std::string_view name : parameter.choices) names.emplace_back(std::string(name));
  return names;
}

// What costs seconds at its ends and shows nothing new in small pictures.
bool is_about_cost(const Parameter& parameter) {
  return parameter.path == "quality.ground_texels" || parameter.path == "quality.cloud_texels" ||
         parameter.path == "quality.pixel_error";
}

// Nor are there files to vary among.
bool is_left_out(const Parameter& parameter) { return is_about_cost(parameter) || parameter.type == Type::File; }

Scene cheap_scene(const char* preset = "temperate") {
  Scene scene = find_preset(preset)->scene;
  make_cheap(scene);
  return scene;
}

void add_singles(std::vector<Case>& cases, Extent extent) {
  for (const Parameter& parameter : parameters()) {
    if (is_about_cost(parameter) && extent != Extent::full) continue;
    for (const Value& value : ends_of(parameter)) {
      Scene scene = cheap_scene();
      assign(scene, parameter, value);
      cases.push_back({"single", text_of(parameter.path, " = ", to_text(value)), scene, view_of(small)});
    }
  }
}

// Beside the parameters, what a view is made of.
constexpr Size pair_sizes[] = {small, {1, 1}, {1, 64}, {64, 1}};
constexpr double pair_times[] = {0.0, 1.0, 1e9};

void add_pairs(std::vector<Case>& cases) {
  std::vector<const Parameter*> varied;
  std::vector<std::vector<Value>> values;
  std::vector<int> levels;
  const Scene start = cheap_scene();
  for (const Parameter& parameter : parameters()) {
    if (is_left_out(parameter)) continue;
    varied.push_back(&parameter);
    values.push_back(ends_of(parameter));
    if (parameter.type == Type::Float || parameter.type == Type::Int) values.back().push_back(parameter.get(start));
    levels.push_back(static_cast<int>(values.back().size()));
  }
  levels.push_back(static_cast<int>(std::size(pair_sizes)));
  levels.push_back(static_cast<int>(std::size(pair_times)));
  for (const std::vector<int>& row : covering_pairs(levels, pairs_seed)) {
    Scene scene = start;
    for (std::size_t f = 0; f < varied.size(); ++f) {
      assign(scene, *varied[f], values[f][static_cast<std::size_t>(row[f])]);
    }
    const View view = view_of(pair_sizes[row[varied.size()]], pair_times[row[varied.size() + 1]]);
    cases.push_back(
        {"pair",
         text_of("row ", std::count_if(cases.begin(), cases.end(), [](const Case& c) { return c.group == "pair"; })),
         scene, view});
  }
}

// Uniform in 0..1, the same on every machine.
double uniform(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.0; }

Value random_value(const Parameter& parameter, std::mt19937& random) {
  const std::vector<Value> ends = ends_of(parameter);
  const bool number = parameter.type == Type::Float || parameter.type == Type::Int;
  if (!number || random() % 2U == 0U) return ends[random() % ends.size()];
  const bool over_decades = parameter.min > 0.0 && parameter.scale == Scale::Logarithmic;
  const double part = uniform(random);
  const double value = over_decades ? parameter.min * std::pow(parameter.max / parameter.min, part)
                                    : std::lerp(parameter.min, parameter.max, part);
  if (parameter.type == Type::Int) return static_cast<int>(value);
  return std::clamp(value, parameter.min, parameter.max);
}

void add_random(std::vector<Case>& cases, int count) {
  std::mt19937 random(random_seed);
  for (int i = 0; i < count; ++i) {
    Scene scene = cheap_scene();
    for (const Parameter& parameter : parameters()) {
      if (is_left_out(parameter) || random() % 3U != 0U) continue;
      assign(scene, parameter, random_value(parameter, random));
    }
    const double seconds = std::pow(10.0, 9.0 * uniform(random));
    cases.push_back({"random", text_of("number ", i), scene, view_of(small, i % 3 == 0 ? 0.0 : seconds)});
  }
}

struct Place {
  const char* name;
  double latitude, longitude, heading, pitch;
};

constexpr Place places[] = {
    {"equator, down", 0.0, 0.0, 0.0, -90.0},        {"north pole, down", 90.0, 0.0, 0.0, -90.0},
    {"south pole, level", -90.0, 0.0, 45.0, 0.0},   {"date line, level", 0.0, 180.0, 90.0, 0.0},
    {"antipode, up", -14.0, 180.0, 0.0, 60.0},      {"near the pole, level", 89.9999, 10.0, 180.0, -5.0},
    {"40 north, horizon", 40.0, 33.0, 200.0, -12.0}};

struct Height {
  const char* name;
  double radii;   // of the planet
  double metres;  // and beside them
};

constexpr Height heights[] = {{"inside the ground or under water", 0.0, 0.0},
                              {"0.1 mm a metre of radius", 1e-4, 0.0},
                              {"a thousandth", 1e-3, 0.0},
                              {"a tenth", 0.1, 0.0},
                              {"two radii", 2.0, 0.0},
                              {"1e10 m", 0.0, 1e10}};

constexpr double radii[] = {1.0, 6.371e6, 1e8};

void add_places(std::vector<Case>& cases, Extent extent) {
  int number = 0;
  for (const double radius : radii) {
    for (const Height& height : heights) {
      for (const Place& place : places) {
        for (const char* preset : {"temperate", "storm"}) {
          // A third of them shows every radius with every height, every height with every place.
          if (extent != Extent::full && number++ % 3 != 0) continue;
          Scene scene = find_preset(preset)->scene;
          scene = scaled(scene, radius / scene.planet.radius);
          make_cheap(scene);
          scene.camera.altitude = height.radii * radius + height.metres;
          scene.camera.latitude = place.latitude;
          scene.camera.longitude = place.longitude;
          scene.camera.heading = place.heading;
          scene.camera.pitch = place.pitch;
          cases.push_back({"place", text_of(preset, ", radius ", radius, " m, ", height.name, ", ", place.name), scene,
                           view_of(small)});
        }
      }
    }
  }
}

void add_times(std::vector<Case>& cases) {
  for (const char* preset : {"temperate", "storm"}) {
    for (const double seconds : {1.0, 1e3, 1e6, 1e9}) {
      cases.push_back(
          {"time", text_of(preset, " after ", seconds, " s"), cheap_scene(preset), view_of(small, seconds)});
    }
  }
}

void add_fields(std::vector<Case>& cases) {
  for (const double fov : {1.0, 5.0, 90.0, 150.0, 170.0}) {
    for (const double altitude : {0.01, 0.1, 2.25, 100.0}) {
      for (const double pitch : {-90.0, -40.0, 0.0}) {
        Scene scene = cheap_scene();
        scene.camera.fov = fov;
        scene.camera.altitude = scene.water.level + altitude;
        scene.camera.pitch = pitch;
        const std::string name = text_of(fov, " degrees from ", altitude, " radii, pitch ", pitch);
        cases.push_back({"field", name, scene, view_of(small)});
      }
    }
  }
}

void add_sizes(std::vector<Case>& cases, Extent extent) {
  std::vector<Size> sizes = {{1, 1}, {2, 1}, {1, 2}, {3, 3}, {1, 256}, {256, 1}, {255, 255}};
  if (extent == Extent::full) sizes.insert(sizes.end(), {{8192, 1}, {1, 8192}, {4096, 4096}});
  for (const Size size : sizes) {
    cases.push_back({"size", text_of(size.width, "x", size.height), cheap_scene(), view_of(size)});
  }
}

void add_presets(std::vector<Case>& cases, Extent extent) {
  for (const Preset& preset : presets()) {
    Scene scene = preset.scene;
    if (extent != Extent::full) make_cheap(scene);
    cases.push_back({"preset", preset.name, scene, view_of(small)});
  }
}

// Every so many, so that each group keeps some.
std::vector<Case> thinned(const std::vector<Case>& all, std::size_t step) {
  std::vector<Case> kept;
  for (std::size_t i = 0; i < all.size(); i += step) kept.push_back(all[i]);
  return kept;
}

}  // namespace

std::vector<Case> extreme_cases(Extent extent) {
  std::vector<Case> cases;
  add_presets(cases, extent);
  add_sizes(cases, extent);
  add_fields(cases);
  add_times(cases);
  add_places(cases, extent);
  add_singles(cases, extent);
  add_pairs(cases);
  add_random(cases, extent == Extent::full ? 200 : 30);
  return extent == Extent::sample ? thinned(cases, 16) : cases;
}

void make_cheap(Scene& scene) {
  scene.quality.ground_texels = 64;
  scene.quality.cloud_texels = 32;
  scene.quality.pixel_error = 16.0;
}

}  // namespace terrella
