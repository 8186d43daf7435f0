// A sea whose waves are shown in part, and what the others do to it. Lengths in planet radii.
#include "lib/water.glsl"

// The part of a normal distribution below x standard deviations, within 2e-4.
float part_below(float x) {
  float c = clamp(x, -8.0, 8.0);
  return 1.0 / (1.0 + exp(-c * (1.5976 + 0.070566 * c * c)));
}

// Where a sea's crests break into foam.
struct Breaking {
  float fold;        // Jacobian of the surface below which water is foam
  float softness;    // by how much it differs from place to place, > 0
  float choppiness;  // Q: what a slope's deviation is to be multiplied by for that of the Jacobian
};

// Part of the water that is foam where the surface has a Jacobian, but for waves that are not shown, whose slopes have a
// variance.
float broken_part(float jacobian, float unseen, Breaking breaking) {
  float doubt = sqrt(breaking.softness * breaking.softness + breaking.choppiness * breaking.choppiness * unseen);
  return part_below((breaking.fold - jacobian) / doubt);
}

// A sea whose waves are shown in part. up: unit, of the still water; to_eye: unit; unseen: variance of the slopes of those that are not
// shown, which roughens the water and folds it by chance; whole_depth: at which waves are whole.
Water open_water(vec3 up, vec3 to_eye, float depth, WaveSum sum, Frame frame, float unseen, Breaking breaking, float whole_depth, WaterLook look) {
  vec3 n = wave_normal(sum);
  float broken = broken_part(n.z, unseen, breaking);
  float shore = 1.0 - smoothstep(0.05, 0.35, depth / whole_depth);
  float own = look.roughness * look.roughness;
  n = normalize(n);
  Water w;
  w.normal = normal_in_frame(n, frame, up);
  w.depth = depth;
  w.roughness = clamp(sqrt(sqrt(own * own + unseen)), 0.02, 1.0);
  w.foam = look.foam * clamp(broken + 0.8 * shore, 0.0, 1.0);
  return with_unseen_waves(w, unseen, to_eye);
}
