// No ground that waves feel.
bool feels_ground() { return false; }
float felt_depth() { return 1.0; }
vec2 felt_slope(Frame axes) { return vec2(0.0); }
