#include "scene/uniforms.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "scene/parameters.hpp"

namespace terrella {
namespace {

// What std140 asks for: a vec4 stands at a multiple of 16 bytes, a float or int at a multiple of 4.
constexpr std::size_t kVec4Bytes = 16, kScalarBytes = 4;

// The block is sorted by kind; vec4 first, so that nothing needs padding.
enum class Kind { Vec4, Float, Int };

Kind kind_of(const Parameter& parameter) {
  if (parameter.type == Type::Color) return Kind::Vec4;
  return parameter.type == Type::Float ? Kind::Float : Kind::Int;
}

bool is_in_block(const Parameter& parameter) {
  constexpr std::array<std::string_view, 3> kForTheCpuOnly = {"camera", "quality", "time"};
  if (parameter.type == Type::File) return false;
  return std::find(kForTheCpuOnly.begin(), kForTheCpuOnly.end(), parameter.group) == kForTheCpuOnly.end();
}

struct Layout {
  std::vector<const Parameter*> parameters;
  std::vector<BlockMember> members;
  std::size_t bytes = 0;
};

Layout make_layout() {
  Layout layout;
  for (const Kind kind : {Kind::Vec4, Kind::Float, Kind::Int}) {
    for (const Parameter& parameter : parameters()) {
      if (!is_in_block(parameter) || kind_of(parameter) != kind) continue;
      layout.parameters.push_back(&parameter);
      layout.members.push_back({std::string(parameter.group) + "_" + std::string(parameter.name), layout.bytes});
      layout.bytes += kind == Kind::Vec4 ? kVec4Bytes : kScalarBytes;
    }
  }
  layout.bytes = (layout.bytes + kVec4Bytes - 1) / kVec4Bytes * kVec4Bytes;
  return layout;
}

const Layout& layout() {
  static const Layout made = make_layout();
  return made;
}

template <class T>
void put(std::byte* place, T value) {
  std::memcpy(place, &value, sizeof value);
}

void put_color(std::byte* place, Color color) {
  const std::uint8_t channels[] = {color.r, color.g, color.b};
  for (const std::uint8_t channel : channels) {
    put(place, static_cast<float>(linear_light(channel)));
    place += kScalarBytes;
  }
  put(place, 1.0f);
}

void put_parameter(std::byte* place, const Parameter& parameter, Scene& scene) {
  const Field field = parameter.field(scene);
  switch (kind_of(parameter)) {
    case Kind::Vec4: put_color(place, *std::get<Color*>(field)); break;
    case Kind::Float: {
      const bool in_radii = parameter.unit == "m" || parameter.unit == "m/s";
      const double unit = in_radii ? scene.planet.radius : 1.0;
      put(place, static_cast<float>(*std::get<double*>(field) / unit));
      break;
    }
    case Kind::Int:
      const bool* flag = std::holds_alternative<bool*>(field) ? std::get<bool*>(field) : nullptr;
      put(place, flag != nullptr ? std::int32_t{*flag} : std::int32_t{*std::get<int*>(field)});
      break;
  }
}

}  // namespace

std::span<const BlockMember> block_members() { return layout().members; }

std::vector<std::byte> pack_scene(const Scene& scene) {
  Scene copy = scene;  // the table's fields point into a scene that can be changed
  std::vector<std::byte> block(layout().bytes);
  for (std::size_t i = 0; i < layout().members.size(); ++i) {
    put_parameter(block.data() + layout().members[i].offset, *layout().parameters[i], copy);
  }
  return block;
}

}  // namespace terrella
