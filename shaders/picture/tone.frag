// From light to an sRGB picture of 8 bits; alpha holds the brightness for the smoothing of edges.
#include "scene_block.glsl"
#include "lib/color.glsl"

uniform sampler2D image;

in vec2 place;
out vec4 fragment;

void main() {
  vec3 light = texelFetch(image, ivec2(gl_FragCoord.xy), 0).rgb;
  vec3 shown = srgb(tone_map(light, picture_tone)) + dither(floor(gl_FragCoord.xy)) / 255.0;
  fragment = vec4(shown, dot(shown, vec3(0.299, 0.587, 0.114)));
}
