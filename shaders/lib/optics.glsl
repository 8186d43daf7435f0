// Light at surfaces and through water.

// Reflectance at right incidence between two refractive indices (Sandahl 17).
float reflectance_at_normal(float n1, float n2) {
  float r = (n1 - n2) / (n1 + n2);
  return r * r;
}

// Reflectance of a smooth dielectric (Schlick 1994; Sandahl 17, with the view direction that the print calls light).
// cosine: of normal and view, held to 0..1. r0: reflectance at 1.
float schlick(float cosine, float r0) {
  float c = clamp(cosine, 0.0, 1.0);
  float m = 1.0 - c;
  float lost = (1.0 - m) - c;  // by rounding: five times as much of m^5
  float m2 = m * m;
  return r0 + (1.0 - r0) * m2 * m2 * (m + 5.0 * lost);
}

// The same on average over a surface whose cosine has that mean and varies around it: what the second derivative adds.
// variance: of the cosine.
float varied_schlick(float cosine, float r0, float variance) {
  float m = 1.0 - clamp(cosine, 0.0, 1.0);
  return min(schlick(cosine, r0) + 10.0 * (1.0 - r0) * variance * m * m * m, 1.0);
}

// Diffuse light that reaches round the edge (Green 2004; Sandahl 19). wrap: 0..1; 0 is Lambert's law.
float wrap_diffuse(float cosine, float wrap) {
  return max(0.0, (cosine + wrap) / (1.0 + wrap));
}

// Part of the light that is left after a path through an absorber. path >= 0 in the unit of 1/extinction. For colours: what
// the rounding of a depth loses, which left_after keeps, is far below what a screen shows.
vec3 transmitted(vec3 extinction, float path) {
  return exp(-extinction * max(path, 0.0));
}

// The extinction for which white light takes the colour tint after one unit of length. tint: linear, held above 1e-4.
vec3 extinction_of(vec3 tint) {
  return -log(clamp(tint, vec3(1.0e-4), vec3(1.0)));
}

// The part of a normal distribution below x standard deviations, within 2e-4.
float part_below(float x) {
  float c = clamp(x, -8.0, 8.0);
  return 1.0 / (1.0 + exp(-c * (1.5976 + 0.070566 * c * c)));
}

// How far a liquid's crust covers a place, 0..1, from noise there (-1..1): it is torn along the lines where noise is 0.
// crust: part of the liquid that it covers, 0..1.
float crust_cover(float noise, float crust) {
  float torn = 0.5 * (1.0 - crust);
  return crust <= 0.0 ? 0.0 : crust >= 1.0 ? 1.0 : smoothstep(torn, torn + 0.5 * crust * torn, abs(noise));
}

// How many of the normals of a rough surface lie around a direction: the GGX lobe (Walter et al. 2007). cosine: of the direction and the
// mean normal, 0..1; a2: fourth power of the roughness.
float ggx_lobe(float cosine, float a2) {
  float d = (cosine * a2 - cosine) * cosine + 1.0;
  return a2 / (3.141592653589793 * d * d);
}

// Glitter of a light on a rough surface: the GGX lobe (Walter et al. 2007) with the visibility of Hammon 2017, without
// its Fresnel factor. All cosines held to 0..1; roughness 0.02..1. Includes the cosine of the light.
float glitter(float normal_half, float normal_view, float normal_light, float roughness) {
  float a = roughness * roughness;
  float a2 = a * a;
  float nh = clamp(normal_half, 0.0, 1.0);
  float nv = max(normal_view, 1.0e-3);
  float nl = max(normal_light, 0.0);
  float visibility = 0.5 / mix(2.0 * nl * nv, nl + nv, a);
  return nl > 0.0 ? ggx_lobe(nh, a2) * visibility * nl : 0.0;
}

// The same seen through the surface, from where it is refracted to (Walter et al. 2007, equation 21, without its Fresnel factor,
// shadowing and the square of the index by which a refracted beam is narrowed). normal: to the side of the light; light, to_eye: unit;
// index: of refraction on the side of the eye, that of the light's being 1.
float glitter_through(vec3 normal, vec3 light, vec3 to_eye, float index, float roughness) {
  vec3 between = -(light + index * to_eye);
  between *= inversesqrt(max(dot(between, between), 1.0e-12));
  float a = roughness * roughness;
  float a2 = a * a;
  float nh = clamp(dot(normal, between), 0.0, 1.0);
  float lh = dot(light, between), eh = dot(to_eye, between);
  float narrowed = lh + index * eh;
  float seen = lh > 0.0 && eh < 0.0 ? lh * -eh / max(narrowed * narrowed, 1.0e-6) : 0.0;
  return ggx_lobe(nh, a2) * seen / max(-dot(normal, to_eye), 0.05);
}

// Phong's highlight, normalised so that a sharper one is brighter. exponent 1..1000.
float phong(float reflected_light, float exponent) {
  float c = clamp(reflected_light, 0.0, 1.0);
  return c > 0.0 ? pow(c, exponent) * (exponent + 2.0) / 6.283185307179586 : 0.0;
}
