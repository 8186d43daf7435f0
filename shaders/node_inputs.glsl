// What a pixel gets of the vertices around it (node_vertex.glsl).
uniform float node_sea_level;  // over the sphere; 0 without water
in vec4 node_slope;
in vec4 node_height;
in vec2 node_held;
flat in vec2 node_layers;
