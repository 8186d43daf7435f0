// A sea whose waves are shown in part, and what the others do to it. Lengths in planet radii.
#include "lib/shoaling.glsl"
#include "lib/water.glsl"

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

// How much of the foam of a crest is left a quarter and half of its period later.
const float left_after_quarter = 0.5;
const float left_after_half = 0.25;

// Foam where the surface has a Jacobian, and what is left of where it was below the fold before; as for broken_part.
float whitecaps_at(float jacobian, float quarter_before, float unseen, Breaking breaking) {
  float half_before = 2.0 - jacobian;
  return min(broken_part(jacobian, unseen, breaking) + left_after_quarter * broken_part(quarter_before, unseen, breaking) +
             left_after_half * broken_part(half_before, unseen, breaking), 1.0);
}

// What of a sea is not shown.
struct Unseen {
  float slopes;   // variance of the slopes of waves
  float heights;  // the same of their heights
};

// What tears foam into lace as it ages: between cells of noise it stays the longest.
struct FoamLace {
  float noise;  // -1..1
  float shown;  // how much of it pixels can show, 0..1
};

FoamLace no_lace() {
  FoamLace lace;
  lace.noise = 0.0;
  lace.shown = 0.0;
  return lace;
}

// Of two layers of noise, the finer one as far as it is shown.
float lace_of(float coarse, float fine, float fine_shown) {
  float part = 0.8 * fine_shown;
  return (coarse + part * fine) / (1.0 + part);
}

// How much of a crest's foam is left on average until the next one.
const float mean_foam_left = 0.2292;

// How much foam is left of a crest that broke, 0..1, after the angle by which its wave has run on. height: of the water; before: a
// quarter of the period earlier.
float foam_left(float height, float before) {
  const float front = 0.5, lasting = 1.2;
  float since = atan(before, height + 1.0e-30);  // 0 where there is no wave
  float age = since < -front ? since + 6.283185307179586 : since;
  return age < 0.0 ? 1.0 - smoothstep(0.0, front, -age) : exp(-age / lasting);
}

// Part of the water that is surf: foam of waves whose crests are high beside the depth of the still water. sum: held by the ground;
// unseen_heights: variance of the heights of waves that are not shown.
float surf_part(WaveSum sum, float depth, float unseen_heights, float whole_depth) {
  float softness = 0.04 * whole_depth;
  float crest = sum.height * sum.height + sum.before * sum.before;
  float breaks = part_below((sqrt(crest) - 0.45 * depth) * inversesqrt(softness * softness + unseen_heights));
  float known = crest / (crest + 2.0 * unseen_heights + 1.0e-30);
  return breaks * mix(mean_foam_left, foam_left(sum.height, sum.before), known);
}

// Foam as it lies: torn where there is less of it.
float laced(float foam, FoamLace lace) {
  float width = 0.02 + 1.2 * foam;
  float torn = min(2.0 * foam, 1.0) * (1.0 - smoothstep(0.2 * width, width, abs(lace.noise)));
  return mix(foam, torn, lace.shown);
}

// A sea whose waves are shown in part. up: unit, of the still water; to_eye: unit; below: whether the eye is under the surface; depth: of the still water; sum: held by the ground; whole_depth: at which waves are whole.
Water open_water(vec3 up, vec3 to_eye, bool below, float depth, WaveSum sum, Frame frame, Unseen unseen, Breaking breaking, FoamLace lace, float whole_depth, WaterLook look) {
  vec3 n = wave_normal(sum);
  float surf = laced(surf_part(sum, depth, unseen.heights, whole_depth), lace);
  float broken = whitecaps_at(n.z, 1.0 + sum.stretch_before, unseen.slopes, breaking) + surf;
  float own = look.roughness * look.roughness;
  n = normalize(n);
  Water w;
  w.normal = normal_in_frame(n, frame, up);
  w.depth = depth + sum.height;
  w.roughness = clamp(sqrt(sqrt(own * own + unseen.slopes)), 0.02, 1.0);
  w.foam = look.foam * clamp(broken, 0.0, 1.0);
  return with_unseen_waves(w, unseen.slopes, below ? reflect(to_eye, w.normal) : to_eye);
}
