// The ground that waves feel: as the vertices hold it, which raise waves by that as well.
bool feels_ground() { return true; }
float felt_depth() { return -node_height.x; }
vec2 felt_slope(Frame axes) { return along_axes(node_slope.xyz, axes); }
