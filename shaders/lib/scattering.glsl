// Air that scatters light once: Rayleigh, Mie and an ozone layer around a sphere (Bruneton and Neyret 2008, Bruneton 2017).
// Heights are kept apart from the radius, so that single precision does for a planet of real size. Lengths of one unit.
#include "lib/rays.glsl"

// Phase functions, 1/sr: their integral over all directions is 1. mu: cosine of the angle between the directions before
// and after; forward is 1.
float rayleigh_phase(float mu) {
  return 0.05968310365946075 * (1.0 + mu * mu);  // 3 / (16 pi)
}

// Henyey and Greenstein 1941, the denominator as a sum: 1 + g^2 - 2 g mu loses all digits forward. g: -1..1, exclusive.
float henyey_greenstein_phase(float mu, float g) {
  float size = abs(g);
  float least = 1.0 - size;
  float away = max(g < 0.0 ? 1.0 + mu : 1.0 - mu, 0.0);
  float square = least * least + 2.0 * size * away;
  return 0.07957747154594767 * least * (1.0 + size) / (square * sqrt(square));  // 1 / (4 pi)
}

struct Atmosphere {
  float bottom;           // radius of the ground
  float thickness;        // from the ground to the top
  vec3 rayleigh;          // scattering at the ground, per length
  float rayleigh_height;  // scale height
  vec3 mie;               // extinction at the ground
  float mie_height;
  vec3 ozone;             // absorption where it is densest
  float ozone_center;     // altitude of that
  float ozone_half;       // half the thickness of the tent
};

// What an integral spends: panels of four points for each of the lower scale heights that a ray passes. In double
// precision they converge; in single precision to 1e-6 of an optical depth, and where depths are only to dim scattered
// light, to 1e-4. Some drivers stop a shader after 65536 turns of its loops.
#ifdef TERRELLA_DOUBLE
const float depth_panels = 2.0;
const float dimming_panels = 2.0;
#else
const float depth_panels = 0.5;
const float dimming_panels = 0.25;
#endif

// Gauss and Legendre's four points: x, place in -1..1; y, weight (they sum to 2).
vec2 gauss_point(int i) {
  float x = i == 0 || i == 3 ? 0.8611363115940526 : 0.3399810435848563;
  float weight = i == 0 || i == 3 ? 0.3478548451374538 : 0.6521451548625461;
  return vec2(i < 2 ? -x : x, weight);
}

// Distance from the centre a way along a ray. mu: of the ray, at its start.
float radius_along(float alt, float mu, float way, float bottom) {
  float r = bottom + alt;
  return sqrt(max(r * r + way * (2.0 * r * mu + way), 0.0));
}

// Altitude there, as what it gains on that of the start.
float altitude_along(float alt, float mu, float way, float bottom) {
  float r = bottom + alt;
  return alt + way * (2.0 * r * mu + way) / (radius_along(alt, mu, way, bottom) + r);
}

vec3 extinction_at(float altitude, Atmosphere a) {
  float tent = max(1.0 - abs(altitude - a.ozone_center) / a.ozone_half, 0.0);
  return a.rayleigh * exp(-altitude / a.rayleigh_height) + a.mie * exp(-altitude / a.mie_height) + a.ozone * tent;
}

// How many panels a piece of a ray asks for that gains a height.
int panels_for(float gain, Atmosphere a, float panels_a_height) {
  float heights = abs(gain) / min(a.rayleigh_height, a.mie_height);
  return int(clamp(ceil(panels_a_height * heights), 1.0, 512.0));
}

// Where a ray is cut for its integral, i = 0..8 in ascending order: its ends, its lowest place, and where it meets the
// edges of the ozone's tent, at which the integrand has kinks.
float kink_along(int i, float alt, float mu, float way, Atmosphere a) {
  if (i == 0) return 0.0;
  if (i == 8) return way;
  float lowest = -(a.bottom + alt) * mu;
  int shell = i < 4 ? 2 - i : i - 6;  // 1 for the tent's upper edge, 0, -1
  Roots roots = ray_shell(a.bottom, alt, mu, a.ozone_center + float(shell) * a.ozone_half);
  float kink = i == 4 || !roots.met ? lowest : i < 4 ? roots.t0 : roots.t1;
  return clamp(kink, 0.0, way);
}

// Optical depth of a way along a ray from an altitude, by so many panels. mu: cosine of ray and up. Below the ground the
// air goes on getting denser.
vec3 optical_depth_by(float alt, float mu, float way, Atmosphere a, float panels_a_height) {
  vec3 depth = vec3(0.0);
  float start = 0.0;
  float start_altitude = alt;
  for (int i = 1; i <= 8; ++i) {
    float end = kink_along(i, alt, mu, way, a);
    if (end <= start) continue;
    float end_altitude = altitude_along(alt, mu, end, a.bottom);
    int panels = panels_for(end_altitude - start_altitude, a, panels_a_height);
    float half_panel = 0.5 * (end - start) / float(panels);
    for (int j = 0; j < panels; ++j) {
      float middle = start + half_panel * float(2 * j + 1);
      vec2 inner = half_panel * gauss_point(2);
      vec2 outer = half_panel * gauss_point(3);
      depth += inner.y * (extinction_at(altitude_along(alt, mu, middle - inner.x, a.bottom), a) +
                          extinction_at(altitude_along(alt, mu, middle + inner.x, a.bottom), a));
      depth += outer.y * (extinction_at(altitude_along(alt, mu, middle - outer.x, a.bottom), a) +
                          extinction_at(altitude_along(alt, mu, middle + outer.x, a.bottom), a));
    }
    start = end;
    start_altitude = end_altitude;
  }
  return depth;
}

vec3 optical_depth(float alt, float mu, float way, Atmosphere a) {
  return optical_depth_by(alt, mu, way, a, depth_panels);
}

// The way from an altitude to the top of the air; 0 for a ray that does not come to it.
float way_to_top(float alt, float mu, Atmosphere a) {
  return max(ray_shell(a.bottom, alt, mu, a.thickness).t1, 0.0);
}

// Optical depth up to the top of the air, without regard for the ground.
vec3 optical_depth_to_top(float alt, float mu, Atmosphere a) {
  return optical_depth(alt, mu, way_to_top(alt, mu, a), a);
}

// Whether the ground hides what lies in a direction.
bool behind_ground(float alt, float mu, Atmosphere a) {
  float along = (a.bottom + alt) * mu;
  return mu < 0.0 && along * along > alt * (2.0 * a.bottom + alt);
}

// Light that is scattered once towards the eye, of a sun of irradiance 1, by air and by haze; both without their phase
// functions.
struct Scattered {
  vec3 rayleigh;
  vec3 mie;
};

// Along a way from an altitude. mu: cosine of ray and up; mu_sun: of sun and up; nu: of ray and sun; mie: scattering of
// the haze at the ground. The sun is a point: its ray is cut off where it meets the ground, and the integral is split
// there, at the edge of the planet's shadow.
Scattered single_scatter(float alt, float mu, float mu_sun, float nu, float way, vec3 mie, Atmosphere a) {
  float r = a.bottom + alt;
  // The shadow is a cylinder, in which the ray is between two roots. Above the ground it does not leave it at the front.
  float square = (1.0 - nu) * (1.0 + nu);
  float b = r * (mu - mu_sun * nu);
  float c = alt * (2.0 * a.bottom + alt) - r * mu_sun * (r * mu_sun);
  float quarter = b * b - square * c;
  float one = way;
  float other = way;
  if (quarter >= 0.0 && square > 1.0e-12) {
    float q = b < 0.0 ? sqrt(quarter) - b : -b - sqrt(quarter);
    one = q / square;
    other = q == 0.0 ? 0.0 : c / q;
  }
  // These and the lowest place, in ascending order.
  vec3 cuts = clamp(vec3(min(one, other), max(one, other), -r * mu), vec3(0.0), vec3(way));
  cuts = vec3(min(cuts.x, cuts.z), max(cuts.x, min(cuts.y, cuts.z)), max(cuts.y, cuts.z));

  Scattered light;
  light.rayleigh = vec3(0.0);
  light.mie = vec3(0.0);
  float start = 0.0;
  for (int i = 0; i <= 3; ++i) {
    float end = i == 0 ? cuts.x : i == 1 ? cuts.y : i == 2 ? cuts.z : way;
    if (end <= start) continue;
    float between = 0.5 * (start + end);
    float sun_between = (r * mu_sun + between * nu) / radius_along(alt, mu, between, a.bottom);
    if (!behind_ground(altitude_along(alt, mu, between, a.bottom), sun_between, a)) {
      float gain = altitude_along(alt, mu, end, a.bottom) - altitude_along(alt, mu, start, a.bottom);
      int panels = max(panels_for(gain, a, depth_panels), int(16.0 * depth_panels));
      float half_panel = 0.5 * (end - start) / float(panels);
      for (int j = 0; j < 4 * panels; ++j) {
        vec2 point = gauss_point(j & 3);
        float place = start + half_panel * (float(2 * (j >> 2) + 1) + point.x);
        float altitude = altitude_along(alt, mu, place, a.bottom);
        float sun = (r * mu_sun + place * nu) / radius_along(alt, mu, place, a.bottom);
        vec3 depth = optical_depth_by(alt, mu, place, a, dimming_panels) +
                     optical_depth_by(altitude, sun, way_to_top(altitude, sun, a), a, dimming_panels);
        vec3 left = half_panel * point.y * exp(-depth);
        light.rayleigh += exp(-altitude / a.rayleigh_height) * left;
        light.mie += exp(-altitude / a.mie_height) * left;
      }
    }
    start = end;
  }
  light.rayleigh = a.rayleigh * light.rayleigh;
  light.mie = mie * light.mie;
  return light;
}
