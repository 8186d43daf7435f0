// Smooths edges in a finished picture: where brightness jumps, it blends along the edge (after the idea of Lottes 2009,
// "FXAA"). strength 0 only scales the picture.
uniform sampler2D image;
uniform vec2 texel;      // 1 / size of the image
uniform float strength;  // 0 or 1

in vec2 place;
out vec4 fragment;

void main() {
  vec4 middle = texture(image, place);
  fragment = vec4(middle.rgb, 1.0);
  if (strength == 0.0) return;
  float nw = texture(image, place + vec2(-0.5, 0.5) * texel).a;
  float ne = texture(image, place + vec2(0.5, 0.5) * texel).a;
  float sw = texture(image, place + vec2(-0.5, -0.5) * texel).a;
  float se = texture(image, place + vec2(0.5, -0.5) * texel).a;
  float darkest = min(middle.a, min(min(nw, ne), min(sw, se)));
  float brightest = max(middle.a, max(max(nw, ne), max(sw, se)));
  if (brightest - darkest < max(0.03, 0.11 * brightest)) return;
  // Along the edge, at right angles to the change.
  vec2 along = vec2((sw + se) - (nw + ne), (nw + sw) - (ne + se));
  float gentle = max(0.25 * (nw + ne + sw + se) * 0.125, 1.0 / 128.0);
  along = clamp(along / (min(abs(along.x), abs(along.y)) + gentle), -8.0, 8.0) * texel;
  vec3 near = 0.5 * (texture(image, place - along / 6.0).rgb + texture(image, place + along / 6.0).rgb);
  vec3 wide = 0.5 * near + 0.25 * (texture(image, place - 0.5 * along).rgb + texture(image, place + 0.5 * along).rgb);
  float brightness = dot(wide, vec3(0.299, 0.587, 0.114));
  fragment.rgb = brightness < darkest || brightness > brightest ? near : wide;
}
