// A picture over what is there, its colours weighted by their opacity. corner: its lower left, pixels of the screen.
uniform sampler2D image;
uniform vec2 corner;

out vec4 fragment;

void main() { fragment = texelFetch(image, ivec2(gl_FragCoord.xy - corner), 0); }
