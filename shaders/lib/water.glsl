// Water as it is seen: what it reflects, what one sees through it, and what floats on it. Lengths in planet radii.
#include "lib/ground.glsl"
#include "lib/heights.glsl"
#include "lib/marching.glsl"
#include "lib/waves.glsl"

// What a scene's water is like.
struct WaterLook {
  vec3 color;             // of deep water
  vec3 extinction;        // of light on its way through, per radius
  vec3 foam_color;
  float foam;             // 0..1
  float clarity;          // length after which light takes the water's tint
  float roughness;        // 0..1
  float refraction_index;
  float shininess;        // of Phong's highlight
  float glow;             // light that it sends by itself
  float crust;            // part of a calm surface that a crust covers, 0..1
  int shading;            // 0: Schlick, 1: Phong
};

// Its surface at a place.
struct Water {
  vec3 normal;      // unit
  vec3 facing;      // unit, the mean normal of what the eye sees of it
  float depth;      // of the still water; at most 0 where there is land
  float foam;       // 0..1
  float roughness;  // 0.02..1
  float variance;   // of the cosine at which the eye sees it
};

// Fourth power of the roughness that stands for slopes which are too small to be seen.
float unseen_rough(Water w, WaterLook look) {
  float all = w.roughness * w.roughness, own = look.roughness * look.roughness;
  return max(all * all - own * own, 0.0);
}

// Small waves of flow noise on a calm sea, summed from the coarsest layer on (Sandahl 2022, equations 12 and 13).
struct Ripples {
  vec3 gradient;    // of the water's height over the unit sphere
  float rough;      // fourth power of the roughness that stands for what is too small to be seen
  float wash;       // -1..1: where foam runs further up
  int layer;        // the next one
  float frequency;  // its cells per radian
  float strength;   // its part of the steepness of all
  vec2 turn;        // cosine and sine of the angle by which its gradients are turned
};

// Layers told in the roughness where they are too small to be seen.
const int told_ripples = 2;

// frequency: cells per radian of the first layer; turn: cosine and sine of the angle by which its gradients are turned.
Ripples no_ripples(float frequency, vec2 turn) {
  Ripples r;
  r.gradient = vec3(0.0);
  r.rough = 0.0;
  r.wash = 0.0;
  r.layer = 0;
  r.frequency = frequency;
  r.strength = 0.11;
  r.turn = turn;
  return r;
}

// Each layer is finer than the one before it, gentler, and turns twice as fast.
Ripples next_layer(Ripples r) {
  r.layer += 1;
  r.frequency *= 2.3;
  r.strength *= 0.7;
  r.turn = vec2(r.turn.x * r.turn.x - r.turn.y * r.turn.y, 2.0 * r.turn.x * r.turn.y);
  return r;
}

// Tells a layer of which a part is not shown in the roughness. steepness: of all layers; shown: 0..1.
Ripples roughened(Ripples r, float steepness, float shown) {
  float unseen = r.strength * steepness;
  r.rough += 3.0 * (1.0 - shown * shown) * unseen * unseen;
  return r;
}

// Adds the next layer at a direction (unit), without what samples a footprint (rad) apart can't show.
Ripples add_ripples(Ripples r, vec3 direction, float steepness, float footprint, uint seed) {
  float shown = layer_weight(r.frequency, footprint);
  vec3 place = direction * r.frequency + layer_offset(r.layer, seed);
  Noise n = turned_noise(ivec3(0), place, r.turn, layer_seed(r.layer, seed));
  r.gradient += shown * r.strength * steepness * n.gradient;
  if (r.layer < told_ripples) {
    r.wash += shown * n.value * 0.5;
    r = roughened(r, steepness, shown);
  }
  return next_layer(r);
}

// What tells the noise of ripples from all other noise of a planet.
uint ripple_seed(int seed) {
  return uint(seed) + 71u;
}

// How far a crust covers a place, 0..1, as far as samples can show where it is torn. shown: how much of the first layer of
// ripples they can show, 0..1.
float torn_crust(Ripples r, float shown, WaterLook look) {
  return mix(look.crust, crust_cover(r.wash, look.crust), shown);
}

// A calm sea at a place. up: unit; crust: 0..1, how far a crust covers it.
Water calm_water(vec3 up, float depth, Ripples r, float crust, WaterLook look) {
  float own = look.roughness * look.roughness;
  float line = look.clarity * 0.30;
  Water w;
  w.normal = surface_normal(up, 1.0, r.gradient);
  w.facing = w.normal;
  w.depth = depth;
  w.roughness = clamp(sqrt(sqrt(own * own + r.rough)), 0.02, 1.0);
  w.variance = 0.0;
  w.foam = max(look.foam * (1.0 - smoothstep(0.2, 1.0, depth / max(line, 1.0e-9) + 0.5 * r.wash)), crust);
  return w;
}

// A wave's normal in planet axes; where the surface has folded over, it looks up none the less. n: unit, in the frame's axes.
vec3 normal_in_frame(vec3 n, Frame frame, vec3 up) {
  return normalize(n.x * frame.east + n.y * frame.north + max(n.z, 0.05) * up);
}

// A sea of waves at a place. up: unit, of the still water; amplitude: of the sea, > 0; whole_depth: at which waves are whole.
Water wavy_water(vec3 up, float depth, WaveSum sum, Frame frame, float amplitude, float whole_depth, WaterLook look) {
  vec3 n = wave_normal(sum);
  float crest = 1.0 - smoothstep(0.25, 0.75, n.z);
  n = normalize(n);
  float rise = sum.height / amplitude;
  float shore = 1.0 - smoothstep(0.05, 0.35, depth / whole_depth - 0.05 * rise);
  Water w;
  w.normal = normal_in_frame(n, frame, up);
  w.facing = w.normal;
  w.depth = depth;
  w.roughness = look.roughness;
  w.variance = 0.0;
  w.foam = look.foam * clamp(crest * smoothstep(0.2, 1.6, rise) + 0.8 * shore, 0.0, 1.0);
  return w;
}

// Water some of whose waves are not shown: of their slopes those that face the eye are seen more, the flatter it looks the
// more so, and those differ less. unseen: variance of the slopes; to_eye: unit, mirrored by the surface if the eye is under it.
Water with_unseen_waves(Water w, float unseen, vec3 to_eye) {
  float along_each = 0.5 * unseen, climb = max(dot(w.normal, to_eye), 0.0);
  w.facing = normalize(w.normal - mean_seen_slope(along_each, w.normal, to_eye));
  w.variance = along_each * climb * climb / (climb * climb + 2.55 * along_each + 1.0e-12);
  return w;
}

// A ray as it goes on in the water. ray, normal: unit, from the air.
vec3 refracted_ray(vec3 ray, vec3 normal, WaterLook look) {
  return refract(ray, normal, 1.0 / look.refraction_index);
}

// How fast a refracted ray goes down: its cosine with the vertical, held to what a rough step may divide by. up: unit.
float dive_of(vec3 refracted, vec3 up) {
  return max(-dot(refracted, up), 0.25);
}

// Light of deep water itself. shade: part of the sunlight left by the clouds.
vec3 light_of_depths(LightAt at, float shade, WaterLook look, SceneLight scene) {
  float lit = wrap_diffuse(dot(at.up, scene.sun), 0.15) * shade;
  return look.color * (at.sun * lit + skylight(at, at.up, scene)) * 0.6;
}

// What is left in the water of light that falls in, down to a depth.
vec3 left_at_depth(float depth, LightAt at, WaterLook look, SceneLight scene) {
  return transmitted(look.extinction, depth / max(dot(at.up, scene.sun), 0.3));
}

// Light from the bottom and from the water itself, along the refracted ray. albedo, normal: of the bottom; depth: of the
// bottom; way: of the ray through the water; shade: part of the sunlight left by the clouds.
vec3 light_through(vec3 albedo, vec3 normal, float depth, float way, LightAt at, float shade, WaterLook look, SceneLight scene) {
  vec3 lit = ground_light(albedo, normal, at, shade, scene) * left_at_depth(depth, at, look, scene);
  return mix(light_of_depths(at, shade, look, scene), lit, transmitted(look.extinction, way));
}

// The part of it that is sunlight from the bottom.
vec3 sunlight_through(vec3 albedo, vec3 normal, float depth, float way, LightAt at, float shade, WaterLook look, SceneLight scene) {
  vec3 lit = ground_sunlight(albedo, normal, at, shade, scene) * left_at_depth(depth, at, look, scene);
  return lit * transmitted(look.extinction, way);
}

// How much is seen of a pattern that sunlight draws on the bottom, 0..1: faint light shows none. sunlight: sunlight_through.
float pattern_shown(vec3 sunlight) {
  return smoothstep(0.005, 0.01, max(sunlight.r, max(sunlight.g, sunlight.b)));
}

// Integral along a ray of what is left of light on its way down to a place and from there to the eye. before: optical depth of the way
// down to the eye; along: of the ray; rate: at which both grow together with that.
float gathered_along(float before, float along, float rate) {
  float x = rate * along;
  return along * exp(-max(before + min(x, 0.0), 0.0)) * mean_transmittance(abs(x));
}

// Light that goes through water to an eye in it, and what the water adds, which is lit the less, the deeper it is. depth: of the eye;
// climb: cosine of the ray with the vertical; way: through the water; at: over the eye; shade: part of the sunlight left by the
// clouds. Seen straight down from its surface deep water is light_of_depths.
vec3 through_water(vec3 light, float depth, float climb, float way, LightAt at, float shade, WaterLook look, SceneLight scene) {
  float steep = max(dot(at.up, scene.sun), 0.3);
  float rate = 1.0 - climb / steep;
  vec3 before = look.extinction * (depth / steep), along = look.extinction * way;
  vec3 gathered = vec3(gathered_along(before.r, along.r, rate), gathered_along(before.g, along.g, rate), gathered_along(before.b, along.b, rate));
  vec3 source = light_of_depths(at, shade, look, scene) * (1.0 + 1.0 / steep);
  return light * transmitted(look.extinction, way) + source * gathered;
}

// Light that foam gets, times its colour. shade: part of the sunlight left by the clouds.
vec3 light_on_foam(Water w, LightAt at, float shade, WaterLook look, SceneLight scene) {
  return look.foam_color * (at.sun * shade * wrap_diffuse(dot(w.normal, scene.sun), 0.1) + skylight(at, w.normal, scene));
}

// How bright water glows by itself through its foam.
float glow_through_foam(Water w, WaterLook look) {
  return look.glow * (1.0 - 0.95 * w.foam);
}

// How a ray in the water meets its surface.
struct FromBelow {
  float cosine;   // of ray and normal
  float outside;  // square of that of the ray above; below 0: all of it is thrown back
};

// facing: as of Water, but on the eye's side; ray: unit, from the eye.
FromBelow meets_from_below(vec3 ray, vec3 facing, float refraction_index) {
  FromBelow f;
  f.cosine = max(-dot(ray, facing), 0.0);
  f.outside = 1.0 - refraction_index * refraction_index * (1.0 - f.cosine * f.cosine);
  return f;
}

// What of the light that meets the surface from below is thrown back, all of it beyond the angle of total reflection. facing, ray: as
// for meets_from_below.
float mirrored_from_below(float variance, vec3 facing, vec3 ray, WaterLook look) {
  float n = look.refraction_index;
  FromBelow f = meets_from_below(ray, facing, n);
  float whole = 1.0 - part_below((f.cosine - sqrt(max(1.0 - 1.0 / (n * n), 0.0))) * inversesqrt(variance + 1.0e-6));
  return mix(schlick(sqrt(max(f.outside, 0.0)), reflectance_at_normal(1.0, n)), 1.0, whole);
}

// Where a ray goes on above the water, along the surface where it would not. facing, ray: as for meets_from_below.
vec3 ray_above(vec3 ray, vec3 facing, WaterLook look) {
  FromBelow f = meets_from_below(ray, facing, look.refraction_index);
  vec3 along = ray + f.cosine * facing;
  float held = f.outside > 0.0 ? look.refraction_index : inversesqrt(max(dot(along, along), 1.0e-12));
  return held * along - sqrt(max(f.outside, 0.0)) * facing;
}

// Light that the surface sends down to an eye in the water, before the water between. w: as for water_light, its facing on the eye's
// side; ray: unit, from the eye; above: what is seen through it; mirrored: what is seen in it.
vec3 water_light_below(Water w, LightAt at, vec3 ray, vec3 above, vec3 mirrored, float shade, WaterLook look, SceneLight scene) {
  vec3 sunlight = at.sun * shade;
  float thrown = mirrored_from_below(w.variance, w.facing, ray, look);
  float gleam = glitter_through(w.normal, scene.sun, -ray, look.refraction_index, w.roughness);
  vec3 light = mix(above + sunlight * min(gleam, 40.0), mirrored, thrown);
  // Foam lets half of the light through that it throws back above.
  vec3 foam = light_on_foam(w, at, shade, look, scene) * 0.28;
  return mix(light, foam, w.foam) + look.color * glow_through_foam(w, look);
}

// Light that the surface sends to the eye, before the air. ray: unit, from the eye; below: what comes from under it;
// mirrored: what is seen in it; shade: part of the sunlight left by the clouds. Where there is land (depth at most 0) the
// surface is not seen.
vec3 water_light(Water w, LightAt at, vec3 ray, vec3 below, vec3 mirrored, float shade, WaterLook look, SceneLight scene) {
  float wet = w.depth > 0.0 ? 1.0 : 0.0;
  vec3 sunlight = at.sun * shade;
  vec3 light = below;
  if (look.shading == 0) {
    float cosine = max(-dot(ray, w.facing), 0.0);
    float r0 = reflectance_at_normal(1.0, look.refraction_index);
    vec3 between = scene.sun - ray;
    between *= inversesqrt(max(dot(between, between), 1.0e-12));  // no direction where one looks into the sun
    float gleam = glitter(dot(w.normal, between), max(-dot(ray, w.normal), 0.0), dot(w.normal, scene.sun), w.roughness);
    float r_sun = schlick(max(dot(scene.sun, between), 0.0), r0);
    light = mix(light, mirrored, wet * varied_schlick(cosine, r0, w.variance)) + sunlight * (wet * min(gleam * r_sun, 40.0));
  } else {
    light += sunlight * (wet * phong(dot(reflect(ray, w.normal), scene.sun), look.shininess) * 0.08);
  }
  vec3 foam = light_on_foam(w, at, shade, look, scene) * 0.55;
  light = mix(light, foam, wet * w.foam);
  return light + look.color * (wet * glow_through_foam(w, look));
}
