// What a pixel gets of the vertices around it (node_vertex.glsl).
in vec4 node_slope;
in vec3 node_height;
in vec2 node_held;
flat in vec2 node_layers;
