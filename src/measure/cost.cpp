#include "measure/cost.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "passes/node_meshes.hpp"
#include "planet/icosphere_groups.hpp"
#include "planet/mirror.hpp"
#include "planet/node_grids.hpp"

namespace terrella {
namespace {

// Points of light that the searches can find: places looked at by the one for the milky band (60000) and cells of the
// noise of the stars (27000); places looked at for towns.
constexpr std::int64_t most_stars = 90'000, most_lights = 160'000;
constexpr std::int64_t glow_squares = 6'000, glow_vertices = 6'321;
constexpr std::int64_t six_corners = 6;
constexpr std::int64_t blocks_bytes = 8'192;  // of uniforms

std::int64_t triangles_of(int level) { return std::int64_t{20} << (2 * level); }
std::int64_t vertices_of(int level) { return (std::int64_t{10} << (2 * level)) + 2; }
std::int64_t mesh_bytes(int level) { return 12 * (vertices_of(level) + triangles_of(level)); }

// With all of its mipmaps, which come to a third more.
std::int64_t cube_bytes(int side, int texel) { return std::int64_t{6} * side * side * texel * 4 / 3 + 64; }

class Sum {
 public:
  explicit Sum(Cost& cost) : cost_(cost) {}

  void program(std::string name) { cost_.programs.push_back(std::move(name)); }
  void draw(std::int64_t triangles, int times = 1) {
    cost_.draw_calls += times;
    cost_.triangles += triangles;
  }
  void mesh(int level) { cost_.gpu_bytes += mesh_bytes(level); }
  void cube(int side, int texel) {
    cost_.gpu_bytes += cube_bytes(side, texel);
    ++cost_.textures;
  }
  void texels(std::int64_t count, int texel) {
    bytes(count * texel);
    ++cost_.textures;
  }
  void bytes(std::int64_t count) { cost_.gpu_bytes += count; }
  void squares(std::int64_t count, std::int64_t vec4s) {
    draw(2 * count);
    cost_.gpu_bytes += count * six_corners * vec4s * 16;
  }

 private:
  Cost& cost_;
};

// As many as are kept could be drawn, each as ground, as sea and in its mirror: by one call for each list of triangles,
// and of deep sea with waves for each level of detail.
void add_nodes(Sum& sum, const Needs& needs) {
  for (const char* name : {"ground/nodes", "ground/nodes_in_water", "ground/nodes_in_waves"}) sum.program(name);
  const NodePatch patch = patch_of(needs.ground, needs.ground_cells);
  const std::int64_t vertices = std::ssize(patch.vertices), rim = std::ssize(patch.rim), lists = patch.lists();
  const std::int64_t triangles = std::ssize(patch.triangles) / 3 + 2 * rim;
  const std::int64_t room = node_room(static_cast<int>(vertices));
  // Beside a grid around the eye there is room for the next.
  const int kept = needs.ground == Ground::persistent_grid ? 2 : 1;
  const int layers = needs.mirrored_land > 0.0 ? 3 : needs.water != Water::none ? 2 : 1;
  const int of_deep_sea = needs.water == Water::none ? 0 : needs.water == Water::waves ? deepest_level + 1 : 1;
  sum.draw(layers * room * triangles, static_cast<int>(lists) * layers + of_deep_sea);
  for (int n = 0; n < kept; ++n) {
    // Two nodes a row, where there are so many; a last one may be alone.
    for (const gl::Format format : node_formats) sum.texels(vertices * (room + 1), gl::bytes_of(format));
    sum.bytes(layers * room * vec4s_a_node * std::int64_t{16} + lists * 6 * triangles + 8 * (vertices + rim));
  }
}

void add_ground(Sum& sum, const Needs& needs) {
  if (has_nodes(needs.ground)) return add_nodes(sum, needs);
  sum.program("ground/bake");
  for (const char* name : {"ground/icosphere", "ground/icosphere_near"}) {
    sum.program(name);
    sum.program(text_of(name, "_in_water"));
  }
  const int times = needs.mirrored_land > 0.0 ? 2 : 1;
  sum.draw(times * triangles_of(needs.ground_level), times);
  sum.mesh(needs.ground_level);
  sum.mesh(coarse_level);
  sum.cube(needs.ground_texels, 8);
  sum.cube(coarse_ground_texels, 8);
}

void add_water(Sum& sum, const Needs& needs) {
  sum.program("water/backdrop");
  if (needs.in_water) sum.draw(2, 2);
  if (has_nodes(needs.ground)) {
    for (const char* name : {"water/calm", "water/rippled", "water/waves"}) {
      for (const char* seen : {"_nodes", "_nodes_in_water", "_deep_nodes", "_deep_nodes_cloudy", "_deep_nodes_land"})
        sum.program(text_of(name, seen));
    }
    constexpr std::int64_t wave_list = 16'384;  // two of the short waves, one of a hundred long ones
    if (needs.water == Water::waves) sum.bytes(2 * wave_list + 3'200);
    return;
  }
  for (const char* name : {"water/calm", "water/rippled", "water/waves"}) {
    for (const char* seen : {"", "_near", "_in_water", "_near_in_water"}) sum.program(text_of(name, seen));
  }
  sum.draw(triangles_of(needs.water_level));
}

void add_clouds(Sum& sum, const Needs& needs) {
  for (const char* name : {"clouds/bake", "clouds/shell", "clouds/shell_near"}) sum.program(name);
  sum.draw(triangles_of(needs.cloud_level));
  sum.cube(needs.cloud_texels, 4);
  sum.cube(coarse_cloud_texels, 4);
}

void add_sky(Sum& sum, const Needs& needs) {
  if (needs.stars != Stars::none) {
    sum.program("stars/noise");
    sum.program("stars/glow");
    sum.squares(most_stars, 2);
    sum.draw(2 * glow_squares);
  }
  if (needs.sun != SunImage::none) {
    sum.program("sun/disc");
    sum.draw(4, 2);
  }
}

void add_shells(Sum& sum, const Needs& needs) {
  if (needs.air != Air::none) {
    sum.program("air/fresnel");
    sum.draw(192);
  }
  if (needs.night != NightSide::none) {
    sum.program("lights/night");
    sum.squares(most_lights, 1);
  }
  if (needs.rings != Rings::none) {
    sum.program("rings/plane");
    sum.program("rings/shadow");
    sum.draw(2 * 384 + triangles_of(group_level), 3);
  }
}

// The picture of land that the water mirrors, which there is whether or not it shows any.
void add_mirror(Sum& sum, const Needs& needs, const View& view) {
  const View mirror = needs.mirrored_land > 0.0 ? mirror_view(view) : View{1, 1};
  const std::int64_t pixels = std::int64_t{mirror.width} * mirror.height;
  sum.texels(pixels * 4 / 3 + 1, 8);
  sum.texels(pixels, 4);
}

// A grid around the eye gives way to the next in pictures for which all is drawn twice.
void add_fade(Cost& cost, std::int64_t target_bytes) {
  cost.programs.emplace_back("picture/overlay");
  cost.triangles *= 2;
  cost.draw_calls = 2 * cost.draw_calls + 1;
  cost.noise_evaluations *= 2;
  cost.gpu_bytes += target_bytes;
  cost.textures += 1;
}

}  // namespace

Cost promised_cost(const Needs& needs, const View& view, int bytes_a_pixel) {
  Cost cost;
  Sum sum(cost);
  sum.program("picture/tone");
  sum.program("picture/antialias");
  if (needs.ground != Ground::none) add_ground(sum, needs);
  if (needs.water != Water::none) add_water(sum, needs);
  if (needs.clouds != Clouds::none) add_clouds(sum, needs);
  add_sky(sum, needs);
  add_shells(sum, needs);
  if (needs.water != Water::none) add_mirror(sum, needs, view);
  // Spheres of directions are kept once made, whoever asked for them; the finest are of level 6.
  for (int level = group_level; level <= 6; ++level) sum.mesh(level);
  sum.cube(1, 8);
  sum.cube(1, 4);
  const std::int64_t pixels = std::int64_t{view.width} * view.height;
  constexpr int depth_bytes = 4;
  cost.gpu_bytes += pixels * (bytes_a_pixel + depth_bytes) + blocks_bytes + 16 * glow_vertices + 24 * glow_squares;
  cost.textures += 1;
  const int layers = needs.pixel_octaves_end - needs.pixel_octaves_first + needs.ripple_layers + needs.cloud_pixel_end -
                     needs.cloud_pixel_first;
  cost.noise_evaluations = pixels * layers;
  // A quarter as many pixels show ground in a mirror.
  if (needs.mirrored_land > 0.0)
    cost.noise_evaluations += pixels * (needs.pixel_octaves_end - needs.pixel_octaves_first) / 4;
  if (needs.ground == Ground::persistent_grid) add_fade(cost, pixels * (bytes_a_pixel + depth_bytes));
  return cost;
}

std::vector<std::string> beyond(const RenderStats& work, const Cost& promised) {
  std::vector<std::string> sentences;
  const auto hold = [&](const char* what, std::int64_t measured, std::int64_t most) {
    if (measured > most)
      sentences.push_back(text_of(what, ": ", measured, ", but the needs promise at most ", most, "."));
  };
  hold("triangles", work.triangles, promised.triangles);
  hold("draw calls", work.draw_calls, promised.draw_calls);
  hold("noise evaluations", work.noise_evaluations, promised.noise_evaluations);
  hold("bytes on the GPU", work.gpu_bytes, promised.gpu_bytes);
  hold("textures", work.textures, promised.textures);
  for (const std::string& name : work.programs) {
    if (std::find(promised.programs.begin(), promised.programs.end(), name) == promised.programs.end()) {
      sentences.push_back(text_of("program ", name, ": nothing in the needs calls for it."));
    }
  }
  return sentences;
}

}  // namespace terrella
