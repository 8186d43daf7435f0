// From light to an sRGB picture of 8 bits; alpha holds the brightness for the smoothing of edges.
#include "scene_block.glsl"
#include "lib/color.glsl"

uniform sampler2D image;

in vec2 place;
out vec4 fragment;

void main() {
  vec4 light = texelFetch(image, ivec2(gl_FragCoord.xy), 0);
  if (light.a + light.r + light.g + light.b == 0.0) {
    fragment = vec4(0.0);  // empty sky, most of many pictures: nothing to do
    return;
  }
  vec3 shown = srgb(tone_map(light.rgb, picture_tone)) + dither(floor(gl_FragCoord.xy)) / 255.0;
  // Bare sky counts as dark: stars are no edges.
  fragment = vec4(shown, dot(shown, vec3(0.299, 0.587, 0.114)) * min(8.0 * light.a, 1.0));
}
