// The waves of the sea, longest first.
#include "lib/tangent.glsl"
#include "lib/waves.glsl"

layout(std140) uniform WaveBlock {
  vec4 wave_origin[100];  // xyz: unit vector; w: amplitude, radii
  vec4 wave_motion[100];  // x: wavenumber, rad per radian; y: phase; z: pinch
};

Frame frame_at(vec3 v) {
  Frame f;
  f.east = perpendicular(v);  // any tangent does; this one has no pole
  f.north = cross(v, f.east);
  return f;
}

// The sum of all waves at v that samples a footprint (rad) apart can show.
WaveSum waves_at(vec3 v, Frame f, float footprint) {
  WaveSum sum = no_waves();
  int count = int(sea.z);
  for (int i = 0; i < count; ++i) {
    Wave wave;
    wave.origin = wave_origin[i].xyz;
    wave.amplitude = wave_origin[i].w;
    wave.wavenumber = wave_motion[i].x;
    wave.phase = wave_motion[i].y;
    wave.pinch = wave_motion[i].z;
    float shown = 1.0 - smoothstep(0.25, 0.5, wave.wavenumber / 6.283185307179586 * footprint);
    add_wave(sum, v, f, wave, shown);
  }
  return sum;
}

// Water that grows shallow holds its waves back, down to none where land begins. map: of the ground at v.
WaveSum held_by_ground(WaveSum sum, vec4 map, Frame f) {
  float x = clamp(-map.w / sea.w, 0.0, 1.0);
  float factor = x * x * (3.0 - 2.0 * x);
  float slope = -6.0 * x * (1.0 - x) / sea.w;
  return attenuate(sum, factor, slope * vec2(dot(map.xyz, f.east), dot(map.xyz, f.north)));
}
