// Smooths edges in a finished picture: where brightness jumps, it blends along the edge (after the idea of Lottes 2009,
// "FXAA").
uniform sampler2D image;
uniform vec2 texel;  // 1 / size of the image

in vec2 place;
out vec4 fragment;

// Blends along the edge, at right angles to the change over the three by three texels around.
vec3 blended(float darkest, float brightest) {
  float nw = texture(image, place + vec2(-0.5, 0.5) * texel).a;
  float ne = texture(image, place + vec2(0.5, 0.5) * texel).a;
  float sw = texture(image, place + vec2(-0.5, -0.5) * texel).a;
  float se = texture(image, place + vec2(0.5, -0.5) * texel).a;
  vec2 along = vec2((sw + se) - (nw + ne), (ne + se) - (nw + sw));
  float gentle = max(0.25 * (nw + ne + sw + se) * 0.125, 1.0 / 128.0);
  along = clamp(along / (min(abs(along.x), abs(along.y)) + gentle), -8.0, 8.0) * texel;
  vec3 near = 0.5 * (texture(image, place - along / 6.0).rgb + texture(image, place + along / 6.0).rgb);
  vec3 wide = 0.5 * near + 0.25 * (texture(image, place - 0.5 * along).rgb + texture(image, place + 0.5 * along).rgb);
  float brightness = dot(wide, vec3(0.299, 0.587, 0.114));
  return brightness < darkest || brightness > brightest ? near : wide;
}

void main() {
  vec4 middle = texture(image, place);
  fragment = vec4(middle.rgb, 1.0);
  // Whole texels next to this one: cheaper to fetch than blends of them.
  ivec2 at = ivec2(place / texel);
  ivec2 last = textureSize(image, 0) - 1;
  float north = texelFetch(image, min(at + ivec2(0, 1), last), 0).a;
  float south = texelFetch(image, max(at - ivec2(0, 1), ivec2(0)), 0).a;
  float east = texelFetch(image, min(at + ivec2(1, 0), last), 0).a;
  float west = texelFetch(image, max(at - ivec2(1, 0), ivec2(0)), 0).a;
  float darkest = min(middle.a, min(min(north, south), min(east, west)));
  float brightest = max(middle.a, max(max(north, south), max(east, west)));
  bool edge = brightest - darkest >= max(0.03, 0.11 * brightest);
  // A loop, because software rasterizers run an if for all pixels, but leave a loop once no pixel of a group is in it.
  for (; edge; edge = false) fragment.rgb = blended(darkest, brightest);
}
