// The mean of the light of all samples that a pixel covers, in part or whole, where more are drawn than are shown.
uniform sampler2D image;
uniform vec2 samples;  // for a pixel, along each side; 1 or more

out vec4 fragment;

void main() {
  vec2 first = floor(gl_FragCoord.xy) * samples;
  vec2 last = min(first + samples, vec2(textureSize(image, 0)));
  vec4 sum = vec4(0.0);
  for (float y = floor(first.y); y < last.y; y += 1.0) {
    float rows = min(y + 1.0, last.y) - max(y, first.y);
    for (float x = floor(first.x); x < last.x; x += 1.0) {
      float columns = min(x + 1.0, last.x) - max(x, first.x);
      sum += rows * columns * texelFetch(image, ivec2(int(x), int(y)), 0);
    }
  }
  fragment = sum / ((last.x - first.x) * (last.y - first.y));
}
