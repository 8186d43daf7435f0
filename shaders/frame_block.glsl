// What changes with every frame. Lengths in planet radii; C++ fills it in src/passes/frame.cpp.
#include "lib/mirror.glsl"

layout(std140) uniform FrameBlock {
  mat4 clip_from_eye;      // of positions relative to the eye
  vec4 eye_high;           // the eye, rounded to single precision; w: its height over the unit sphere
  vec4 eye_low;            // what the rounding lost
  vec4 ray_forward;        // unit; w: angle of a pixel, rad
  vec4 ray_right;          // to the right edge of the picture at distance 1
  vec4 ray_up;             // to its upper edge; w: how much is shown of land in the water's mirror, 0..1
  vec4 sun_direction;      // unit; w: exposure, a factor
  vec4 sun_light;          // linear colour times intensity
  vec4 ground_map_scale;   // x: angle of a texel; y, z: first and end of the octaves computed per pixel; w: 1 if water hides the ground under it
  vec4 cloud_turn;         // x, y: cosine and sine of the drift; z: level of their map that pixels can show; w: 1 if there are clouds
  vec4 cloud_moments;      // xyz: weights of the moments that the map of the clouds holds
  vec4 sea;                // x: radius; y: amplitude of one wave that is as high as all together, radii; z: number of waves that run around the planet; w: depth at which they are whole
  vec4 ripple;             // x: steepness, 0 where there are none; y: edge of the sea's mesh, rad; z: variance of the slopes of waves that are not drawn as such
  vec4 ripple_turn;        // x, y: cosine and sine of the angle by which the first layer's gradients are turned; z: layers
  vec4 water_extinction;   // xyz: of light in water, per radius; w: height over the still water that waves keep wet, radii; 0: none
  vec4 water_depths;       // xyz: colour of deep water; w: length after which light takes its tint, radii
  vec4 levels;             // x: sine of the latitude from which snow lies at the water's edge, above 1: nowhere; y: lift of the water's mesh, radii, or of nodes parts of the distance; z: level of the map of the ground that pixels can show; w: most that the sea of nodes is lifted, radii
  vec4 slopes;             // x: unseen_slopes of the map of the ground and the pixels, y: of the ground's mesh; z: part of the sea that is foam by waves that are not drawn; w: rays along which a pixel of the water looks for land in its mirror
  vec4 sky_glow;           // xyz: light of the glow that a low sun spreads over the sky of the eye, 0 outside of the air
  vec4 fineness;           // x: footprint_of_pixel, pixels; y: of texels of the map of the ground from where pixels add layers, pixels; z: size of points of light for which one pixel is shown, pixels; w: part of their light that is left at this size
  vec4 depth;              // x: of the far plane, a part of w; y, z: factor of and distance at which logarithms of distances become depths, y 0: none do; w: sine of how steeply the mirrored eye looks up to land at the most
  vec4 lens;               // xyz: lens_above_water in src/planet/pose.hpp; w: depth of the eye under the still water, radii, >= 0
  mat4 mirror_from_eye;    // of positions relative to the eye, to the picture of the land that the water mirrors; z: nothing
  vec4 mirror;             // x: height of the eye over the still water, radii; 0: no land stands in it; y: angle of a pixel of that picture, rad; z: depth_of_climb in src/planet/mirror.hpp; w: that of clip space while that picture is drawn, else 0
  ivec4 channel;           // x: 0 colour, 1 distance, 2 normal, 3 height
};

// Angle (rad, seen from the planet's centre) between samples on a surface, of which a pixel is one or several. up: unit; offset: from the eye; the cosine
// between both is held above least_cosine.
float pixel_footprint(vec3 up, vec3 offset, float least_cosine) {
  float away = length(offset);
  return fineness.x * away * ray_forward.w / max(-dot(up, offset) / away, least_cosine);
}

// From the eye that is as far below the still water as the true one is above to a position from that.
vec3 from_mirrored_eye(vec3 offset) { return offset + 2.0 * mirror.x * normalize(eye_high.xyz); }

// The ray (unit) along which a position from the eye is seen in what is drawn.
vec3 ray_to(vec3 offset) { return normalize(mirror.w > 0.0 ? from_mirrored_eye(offset) : offset); }

// As a part of its distance, how far below the water land is shown in its mirror.
float foot_in_mirror() { return 3.0 * mirror.y; }

// Where a position relative to the eye is in the picture. Depths fall with distance, from near the eye down to 0 at infinity:
// floats tell apart there what they can't next to 1. Where the driver's depths run from -1 to 1 that is lost, and they may
// have to go by logarithms instead (depth_scheme in src/planet/pose.cpp), which are right at the corners of triangles only.
// In a mirror they fall with how steeply one looks up to a place over the water, so that what is under it is cut off, some pixels
// below: shores are finer than meshes.
vec4 clip_at(vec3 offset) {
  vec4 clip = clip_from_eye * vec4(offset, 1.0);
  float by_logarithm = clip.w * (1.0 - depth.y * log2(max(clip.w, 1.0e-30) / depth.z));
  float over_water = altitude_seen(sea.x, mirror.x, dot(normalize(eye_high.xyz), offset), dot(offset, offset));
  float by_climb = clip.w - mirror.w * (over_water + foot_in_mirror() * clip.w);
  return vec4(clip.xy, mirror.w > 0.0 ? by_climb : depth.y > 0.0 ? by_logarithm : clip.z, clip.w);
}

// The same at infinity along a ray: behind all that has a depth.
vec4 clip_along(vec3 ray) {
  vec4 clip = clip_from_eye * vec4(ray, 0.0);
  return vec4(clip.xy, depth.x * clip.w, clip.w);
}

// The eye in single precision: for what is not near it.
vec3 eye_position() { return eye_high.xyz; }

// A position relative to the eye, without the error of a large difference.
vec3 from_eye(vec3 position) { return (position - eye_high.xyz) - eye_low.xyz; }
