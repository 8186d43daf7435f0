// What a pixel gets of the vertices around it (node_vertex.glsl).
in vec4 node_slope;
in vec3 node_shape_slope;
in vec4 node_height;
in vec3 node_held;
in vec4 node_place;
flat in vec2 node_layers;
