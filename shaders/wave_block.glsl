// The waves of the sea, longest first.
#include "lib/waves.glsl"

layout(std140) uniform WaveBlock {
  vec4 wave_origin[100];  // xyz: unit vector; w: amplitude, radii
  vec4 wave_motion[100];  // x: wavenumber, rad per radian; y: phase; z: pinch
};

// Adds wave i, as far as samples a footprint (rad) apart can show it. unseen gains the variance of the slopes that they
// can't.
void add_long_wave(inout WaveSum sum, inout float unseen, vec3 v, Frame f, int i, float footprint) {
  Wave wave;
  wave.origin = wave_origin[i].xyz;
  wave.amplitude = wave_origin[i].w;
  wave.wavenumber = wave_motion[i].x;
  wave.phase = wave_motion[i].y;
  wave.pinch = wave_motion[i].z;
  float shown = wave_weight(wave.wavenumber, footprint), slope = wave.amplitude * wave.wavenumber;
  unseen += 0.5 * (1.0 - shown * shown) * slope * slope;
  add_wave(sum, v, f, wave, shown);
}

// The sum of all waves at v that samples a footprint (rad) apart can show, held by the ground. map: of the ground at v.
WaveSum waves_at(vec3 v, Frame f, float footprint, vec4 map) {
  WaveSum sum = no_waves();
  float unseen = 0.0;
  int count = int(sea.z);
  for (int i = 0; i < count; ++i) add_long_wave(sum, unseen, v, f, i, footprint);
  return held_in_frame(sum, f, -map.w, map.xyz, sea.w);
}
