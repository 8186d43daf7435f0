// A sea whose waves are shown in part, and what the others do to it. Lengths in planet radii.
#include "lib/shoaling.glsl"
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

// What of a sea is not shown.
struct Unseen {
  float slopes;   // variance of the slopes of waves
  float heights;  // the same of their heights
};

// Part of the water that is surf: crests that are high beside the depth of the still water, and what runs up the land.
float surf_part(float height, float depth, float unseen_heights, float whole_depth) {
  float softness = 0.04 * whole_depth;
  return part_below((height - 0.25 * depth) * inversesqrt(softness * softness + unseen_heights));
}

// A sea whose waves are shown in part. up: unit, of the still water; to_eye: unit; depth: of the still water; sum: held by the ground; whole_depth: at which waves are whole.
Water open_water(vec3 up, vec3 to_eye, float depth, WaveSum sum, Frame frame, Unseen unseen, Breaking breaking, float whole_depth, WaterLook look) {
  vec3 n = wave_normal(sum);
  float broken = broken_part(n.z, unseen.slopes, breaking) + surf_part(sum.height, depth, unseen.heights, whole_depth);
  float own = look.roughness * look.roughness;
  n = normalize(n);
  Water w;
  w.normal = normal_in_frame(n, frame, up);
  w.depth = depth + sum.height;
  w.roughness = clamp(sqrt(sqrt(own * own + unseen.slopes)), 0.02, 1.0);
  w.foam = look.foam * clamp(broken, 0.0, 1.0);
  return with_unseen_waves(w, unseen.slopes, to_eye);
}
