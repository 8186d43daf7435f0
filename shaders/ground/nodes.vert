#include "node_vertex.glsl"

out vec3 surface_from_eye;
out vec4 node_slope;   // xyz: gradient of the height along the sphere; w: openness
out vec3 node_height;   // x: over the water; y, z: Height's rise and ridges
out vec2 node_held;     // x: distance of the level's vertices, rad; y: part of the level above
flat out vec2 node_layers;  // x: first that the vertices don't hold whole; y: its strength, of that of the first of all

void main() {
  NodeVertex v = node_vertex();
  surface_from_eye = node_centre.xyz + v.place;
  surface_from_eye += length(surface_from_eye) * v.skirt;
  node_slope = node_slope_at(v.part);
  node_height = vec3(node_sea.w + v.height, node_rise_at(v.part));
  node_layers = node_around.yz;
  node_held = vec2(node_along.w / float(node_cells), v.part);
  gl_Position = clip_at(surface_from_eye);
}
