// A map of heights over the whole sphere (src/base/height_map.hpp), as a smooth function of the direction: cubic splines
// through its texels (uniform B-splines), so that height and slope have no edges, and nothing passes the texels around.
// Texels are fetched one by one: 32 bit floats need not be filterable. A texture holds all levels one below another, the
// finest first, under a row whose first texel tells that one's height: where neighbouring pixels read different mipmaps, some
// drivers take the level of one of them for all.
#include "lib/angles.glsl"

struct MapHeight {
  float value;    // 0..1
  vec3 gradient;  // of value over the unit sphere, along the sphere, per rad
  float relief;   // as the sum of layers has it: heights of hills, each divided by the width of their cells
};

// Columns and rows of a level, where it begins, and one of its texels.
#ifdef TERRELLA_HOST
ivec2 map_size(sampler2D map, int level) {
  const HeightMap::Level& of = map.map->levels()[static_cast<std::size_t>(level)];
  return ivec2(of.width, of.height);
}

int map_place(sampler2D, int level) { return level; }

float map_texel_at(sampler2D map, int place, int column, int row) {
  return float(map.map->at(place, column, row));
}
#else
ivec2 map_size(highp sampler2D map, int level) {
  return ivec2(textureSize(map, 0).x >> level, int(texelFetch(map, ivec2(0), 0).x) >> level);
}

int map_place(highp sampler2D map, int level) {
  int height = int(texelFetch(map, ivec2(0), 0).x);
  int place = 1;
  for (int i = 0; i < level; ++i) place += height >> i;
  return place;
}

float map_texel_at(highp sampler2D map, int place, int column, int row) {
  return texelFetch(map, ivec2(column, place + row), 0).x;
}
#endif

// What samples a texel apart each add to a spline at t, 0..1 between the middle two of four. Sum 1.
vec4 spline_weights(float t) {
  float s = 1.0 - t;
  return vec4(s * s * s, (3.0 * t - 6.0) * t * t + 4.0, (3.0 * s - 6.0) * s * s + 4.0, t * t * t) / 6.0;
}

// What each of the three differences between them adds to its derivative by t. Sum 1.
vec3 spline_steps(float t) {
  float s = 1.0 - t;
  return vec3(0.5 * s * s, 0.5 + t * s, 0.5 * t * t);
}

float spline_slope(vec3 steps, vec4 texels) {
  return dot(steps, vec3(texels.y - texels.x, texels.z - texels.y, texels.w - texels.z));
}

// Four texels of a row, from a column on. column: from -width on; row: from -height to twice that less one. Beyond a pole
// rows come back, each on the other side: as the two next to a pole are of one height, none needs to be turned.
vec4 map_row(highp sampler2D map, int place, ivec2 size, int column, int row) {
  int y = row < 0 ? -1 - row : row >= size.y ? 2 * size.y - 1 - row : row;
  int x = column + size.x;
  return vec4(map_texel_at(map, place, x % size.x, y), map_texel_at(map, place, (x + 1) % size.x, y),
              map_texel_at(map, place, (x + 2) % size.x, y), map_texel_at(map, place, (x + 3) % size.x, y));
}

// x: height of one level; y, z: its derivatives by the place. place: parts of the way around from longitude -180 degrees,
// and from the north pole to the south pole.
vec3 map_level_at(highp sampler2D map, int level, vec2 place) {
  ivec2 size = map_size(map, level);
  int begin = map_place(map, level);
  vec2 at = place * vec2(size) - 0.5;
  vec2 first = floor(at);
  vec2 part = at - first;
  int column = int(first.x) - 1;
  int row = int(first.y) - 1;
  vec4 a = map_row(map, begin, size, column, row);
  vec4 b = map_row(map, begin, size, column, row + 1);
  vec4 c = map_row(map, begin, size, column, row + 2);
  vec4 d = map_row(map, begin, size, column, row + 3);
  vec4 across = spline_weights(part.x);
  vec4 down = spline_weights(part.y);
  vec3 along = spline_steps(part.x);
  vec4 heights = vec4(dot(across, a), dot(across, b), dot(across, c), dot(across, d));
  vec4 slopes = vec4(spline_slope(along, a), spline_slope(along, b), spline_slope(along, c), spline_slope(along, d));
  return vec3(dot(down, heights), float(size.x) * dot(down, slopes),
              float(size.y) * spline_slope(spline_steps(part.y), heights));
}

// The coarsest level of a map whose finest has so many rows: two rows are left beside each pole.
int coarsest_map_level(int rows) {
  int level = 0;
  while ((rows >> (level + 1)) >= 4) ++level;
  return level;
}

// Distance of neighbouring texels of the finest level, rad.
float map_texel(highp sampler2D map) {
  ivec2 size = map_size(map, 0);
  return max(6.283185307179586 / float(size.x), 3.141592653589793 / float(size.y));
}

// The map at a direction (unit), without what samples a footprint (rad, above 0) apart can't show.
MapHeight map_height_at(highp sampler2D map, vec3 direction, float footprint) {
  float from_axis = length(vec2(direction.x, direction.y));
  float scale = 1.0 / max(from_axis, 1.0e-12);
  float longitude = arc(scale * abs(direction.y), scale * direction.x);
  vec2 place = vec2(0.5 + (direction.y < 0.0 ? -longitude : longitude) * 0.15915494309189535,
                    arc(from_axis, direction.z) * 0.3183098861837907);
  int coarsest = coarsest_map_level(map_size(map, 0).y);
  float texel = map_texel(map);
  float level = clamp(log2(footprint / texel), 0.0, float(coarsest));
  int first = int(level);
  float part = level - float(first);
  vec3 fine = map_level_at(map, first, place);
  vec3 coarse = map_level_at(map, min(first + 1, coarsest), place);
  vec3 at = mix(fine, coarse, part);
  // Of the finest hills that are shown and those that are twice and four times as wide.
  vec3 broad = map_level_at(map, min(first + 2, coarsest), place);
  vec3 broadest = map_level_at(map, min(first + 3, coarsest), place);
  float relief = (1.0 - part) * (fine.x - coarse.x) + 0.5 * (coarse.x - broad.x) + 0.25 * part * (broad.x - broadest.x);
  MapHeight h;
  h.value = at.x;
  // By longitude: along east, and a turn is so much shorter; by the angle from the pole: along south.
  float east = at.y * 0.15915494309189535 * scale * scale;
  float south = at.z * 0.3183098861837907 * scale;
  h.gradient = vec3(south * direction.x * direction.z - east * direction.y,
                    south * direction.y * direction.z + east * direction.x, -south * from_axis * from_axis);
  h.relief = relief / (3.0 * texel * exp2(float(first)));
  return h;
}
