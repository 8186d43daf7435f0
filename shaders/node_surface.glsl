// What pixels know of a ground of nodes: its slopes from the vertices, and the layers that those can't hold from themselves.
#include "fine_layers.glsl"

in vec4 node_slope;
in float node_height;
in vec2 node_held;
flat in vec2 node_layers;

// As much of a layer as the vertices hold.
float held_of_layer(float frequency) {
  return mix(layer_weight(frequency, node_held.x), layer_weight(frequency, 2.0 * node_held.x), node_held.y);
}

// The ground at the pixel as fine as it can show it. up: unit; footprint: rad.
GroundAt node_ground(vec3 up, vec3 from_anchor, float footprint) {
  GroundAt ground;
  ground.gradient = node_slope.xyz - dot(node_slope.xyz, up) * up;
  ground.openness = node_slope.w;
  ground.height = node_height;
  FineLayers fine = fine_layers(from_anchor, footprint, int(node_layers.x), node_layers.y);
  GroundAt seen = refined(ground, fine, up);
  seen.height += fine.value * height_power_slope_at(ground.height + sea.x - 1.0, terrain_height, terrain_power);
  return seen;
}
