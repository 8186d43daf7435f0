// A vertex of a ground of nodes, as the distance to the eye has it. src/passes/node_meshes.cpp fills textures, instances and
// vertices; lengths in planet radii.
#include "frame_block.glsl"
#include "lib/finer_ground.glsl"
#include "scene_block.glsl"

// A texel a vertex, row after row of its node's along x (src/planet/node_mesh.hpp); nodes below one another, and those that are too many for
// that beside the first.
uniform sampler2D node_places;   // xyz: from the node's centre; w: height over the ground that pixels go on with
uniform sampler2D node_coarser;  // what is added to them where the level above takes over
uniform sampler2D node_slopes;   // xyz: gradient of the height, along the sphere; w: relief of Height
uniform sampler2D node_coarser_slopes;
uniform sampler2D node_shape_slopes;  // what of the gradient comes of the shape of Height
uniform sampler2D node_coarser_shape_slopes;
uniform sampler2D node_means;  // xy: mean and shape of Height, to which 8 is added where ice lies, 4 midway; zw: what is added to them
uniform vec4 node_morph;  // x, y: distances, edges of a node, from which to which one level passes to the next; z: square of the eye's lift; w: skirt, rad
uniform int node_vertices;  // of a node

layout(location = 0) in vec4 node_centre;  // xyz: from the eye; w: number among those in the textures
layout(location = 1) in vec4 node_middle;  // xyz: unit; w: base, a height
layout(location = 2) in vec4 node_along;   // xyz: middle less the eye's direction; w: edge, rad
layout(location = 3) in vec4 node_sea;     // xyz: the middle at the sea's level, from the eye; w: the base's height over it
layout(location = 4) in vec4 node_around;  // x: as DrawnNode's coarser; y, z: first layer of noise that the node's vertices don't tell whole, and its strength; w: how far apart they are, rad
layout(location = 5) in ivec2 node_corner;  // x: the texel; y: sides and corners that the vertex lies on (NodePatch), negative at the lower end of a skirt

out vec4 node_slope;        // xyz: gradient of the height along the sphere; w: relief of Height
out vec3 node_shape_slope;  // what of the gradient comes of the shape
out vec4 node_height;       // x: of ice over the water; y, z: Height's mean and shape; w: part that is ice
out vec3 node_held;         // x: how far apart the vertices are, rad; y: part that they tell as the level above does; z: over_at_vertex
out vec4 node_place;        // xyz: from the node's centre; w: its square
flat out vec2 node_layers;  // x: first that the vertices don't hold whole; y: its strength, of that of the first of all

struct NodeVertex {
  vec3 place;       // from the node's centre
  vec3 flat_place;  // from the middle on the unit sphere
  vec3 up;
  vec3 skirt;  // what a skirt adds for each unit of distance; 0 elsewhere
};

// How much higher a place is than the node's centre, from which it is told.
float rise_to(vec3 place) {
  float centre = 1.0 + node_middle.w;
  float square = 2.0 * centre * dot(node_middle.xyz, place) + dot(place, place);
  return square / (sqrt(centre * centre + square) + centre);
}

// The same place on the unit sphere, from the middle. rise: rise_to it.
vec3 flat_place_of(vec3 place, float rise) {
  return (place - rise * node_middle.xyz) / (1.0 + node_middle.w + rise);
}

// Where the vertex is; tells pixels what it knows of the ground.
NodeVertex node_vertex() {
  int rows = textureSize(node_places, 0).y;
  int slot = int(node_centre.w);
  ivec2 texel = ivec2(node_corner.x + slot / rows * node_vertices, slot % rows);
  vec4 own = texelFetch(node_places, texel, 0);
  // Of its own height, which all nodes agree on that share it.
  vec3 chord = flat_place_of(own.xyz, rise_to(own.xyz)) + node_along.xyz;
  float away = sqrt(node_morph.z + dot(chord, chord)) / node_along.w;
  float part = clamp((away - node_morph.x) / (node_morph.y - node_morph.x), 0.0, 1.0);
  // Whether it belongs to a node of the level above as well.
  if ((abs(node_corner.y) & int(node_around.x)) != 0) part = 1.0;
  own += part * texelFetch(node_coarser, texel, 0);
  float rise = rise_to(own.xyz);
  vec4 means = texelFetch(node_means, texel, 0);
  node_slope = texelFetch(node_slopes, texel, 0) + part * texelFetch(node_coarser_slopes, texel, 0);
  node_shape_slope = texelFetch(node_shape_slopes, texel, 0).xyz + part * texelFetch(node_coarser_shape_slopes, texel, 0).xyz;
  float iced = floor(0.25 * means.y + 0.01);
  float coarser_iced = floor(0.25 * (means.y + means.w) + 0.01);
  iced += part * (coarser_iced - iced);
  node_height = vec4(node_sea.w + rise, means.xy + part * means.zw - vec2(0.0, 4.0 * iced), 0.5 * iced);
  node_layers = node_around.yz;
  NodeVertex v;
  v.place = own.xyz;
  v.flat_place = flat_place_of(own.xyz, rise);
  v.up = normalize(node_middle.xyz + v.flat_place);
  node_held = vec3(node_around.w, part, over_at_vertex(own.w, node_slope.xyz, v.place));
  node_place = vec4(v.place, dot(v.place, v.place));
  // Down and out, so that it closes the finest gap from wherever one looks.
  v.skirt = node_corner.y < 0 ? node_morph.w * (normalize(v.flat_place) - v.up) : vec3(0.0);
  return v;
}
