// The layers of the ground's noise, told from a place near the eye so that single precision suffices at any distance:
// C++ chooses the anchor and computes each layer's cell there in double precision (src/passes/layers.cpp).
layout(std140) uniform LayerBlock {
  vec4 layer_anchor;      // xyz: unit vector to the anchor; w: the first layer's part of the amplitude of all
  ivec4 layer_cell[32];   // xyz: the layer's cell at the anchor
  vec4 layer_place[32];   // xyz: place of the anchor in that cell; w: frequency, cells per radian
};
