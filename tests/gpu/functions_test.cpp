// The functions of the shader library as the driver computes them, against double precision. Bounds are those of single
// precision on the CPU, wider by what a driver may do to pow, exp and the trigonometric functions.
#include <gtest/gtest.h>

#include <functional>

#include "formulas/formulas.hpp"
#include "gl/height_texture.hpp"
#include "gpu/gpu_function.hpp"
#include "height_maps.hpp"
#include "laws/random_places.hpp"
#include "native/egl_context.hpp"

namespace terrella {
namespace {

constexpr double u = 5.9604644775390625e-8;

class OnGpu : public testing::TestWithParam<Api> {
 protected:
  void SetUp() override {
    auto made = EglContext::make(GetParam());
    ASSERT_TRUE(made) << made.sentence();
    context_ = std::move(*made);
  }
  std::unique_ptr<EglContext> context_;
};

std::vector<glm::vec4> inputs(const std::function<std::pair<glm::vec4, glm::vec4>(test::Places&)>& make,
                              int count = 20'000) {
  test::Places places(71U);
  std::vector<glm::vec4> all;
  for (int i = 0; i < count; ++i) {
    const auto [a, b] = make(places);
    all.push_back(a);
    all.push_back(b);
  }
  return all;
}

TEST_P(OnGpu, Noise) {
  const auto in = inputs([](test::Places& p) {
    return std::pair(glm::vec4(glm::vec3(p.in_cube(100.0)), p.between(-3.1, 3.1)), glm::vec4(0.0F));
  });
  const auto plain = test::run_on_gpu(
      {"noise"}, "Noise n = simplex_noise(ivec3(0), a.xyz, 7u); result = vec4(n.gradient, n.value);", in);
  const auto flow = test::run_on_gpu(
      {"noise"}, "Noise n = flow_noise(ivec3(0), a.xyz, a.w, 7u); result = vec4(n.gradient, n.value);", in);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const glm::dvec3 q(in[2 * i]);
    const f64::Noise expected = f64::simplex_noise(glm::ivec3(0), q, 7U);
    ASSERT_NEAR(plain[i].w, expected.value, 5e-4);
    ASSERT_LT(glm::distance(glm::dvec3(plain[i]), expected.gradient), 2e-3);
    // Directions that turn are of a length within a thousandth of 1 where a GPU takes medium precision at its word:
    // NVIDIA's was measured to be off by 5.4e-4 in OpenGL ES.
    ASSERT_NEAR(flow[i].w, f64::flow_noise(glm::ivec3(0), q, double{in[2 * i].w}, 7U).value, 1e-3);
  }
}

// The same terrain on every machine: the integers that noise begins with are the same to the last bit.
TEST_P(OnGpu, HashesAreTheSameIntegers) {
  const auto in = inputs([](test::Places& p) {
    return std::pair(glm::vec4(glm::floor(glm::vec3(p.in_cube(8e6))), std::floor(p.between(0.0, 1e6))),
                     glm::vec4(0.0F));
  });
  const auto halves = test::run_on_gpu(
      {"noise"},
      "uint h = hash_cell(ivec3(a.xyz), uint(a.w)); result = vec4(float(h & 0xffffu), float(h >> 16), 0.0, 0.0);", in);
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const glm::vec4& a = in[2 * i];
    const unsigned h = f64::hash_cell(glm::ivec3(a), static_cast<unsigned>(a.w));
    ASSERT_EQ(halves[i].x, static_cast<float>(h & 0xffffU));
    ASSERT_EQ(halves[i].y, static_cast<float>(h >> 16U));
  }
}

TEST_P(OnGpu, NoiseFromAFarCell) {
  const auto in = inputs([](test::Places& p) {
    return std::pair(glm::vec4(glm::vec3(p.in_cube(20.0)), 0.0F),
                     glm::vec4(glm::floor(glm::vec3(p.in_cube(8e6))), 0.0F));
  });
  const auto out =
      test::run_on_gpu({"noise"}, "Noise n = simplex_noise(ivec3(b.xyz), a.xyz, 7u); result = vec4(n.value);", in);
  for (std::size_t i = 0; i < out.size(); ++i) {
    ASSERT_NEAR(out[i].x, f64::simplex_noise(glm::ivec3(in[2 * i + 1]), glm::dvec3(in[2 * i]), 7U).value, 5e-4);
  }
}

TEST_P(OnGpu, HeightFunctions) {
  const auto in = inputs([](test::Places& p) {
    return std::pair(glm::vec4(p.between(-2.0, 2.0), std::pow(10.0, p.between(-2.0, 3.0)), p.between(-0.01, 1.01),
                               p.between(0.0, 16.0)),
                     glm::vec4(0.0F));
  });
  const auto out = test::run_on_gpu(
      {"heights"},
      "result = vec4(smooth_abs(a.x, a.y), height_power(a.z, 0.25, a.w), smooth_abs_slope(a.x, a.y), 0.0);", in);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const glm::dvec4 a(in[2 * i]);
    ASSERT_NEAR(out[i].x, f64::smooth_abs(a.x, a.y), 64.0 * u * std::fabs(a.x));
    const double expected = f64::height_power(a.z, 0.25, a.w);
    const double x = std::fmin(std::fmax(a.z, 1e-30), 1.0);
    const double bound = 4.0 * u * (8.0 + 4.0 * std::fabs(a.w * std::log2(x))) + a.w * std::ldexp(1.0, -20);
    ASSERT_NEAR(out[i].y, expected, bound * expected + 1e-30);
  }
}

TEST_P(OnGpu, TerrainHeight) {
  const auto in =
      inputs([](test::Places& p) { return std::pair(glm::vec4(glm::vec3(p.on_sphere()), 0.0F), glm::vec4(0.0F)); });
  const auto out = test::run_on_gpu(
      {"noise", "heights"},
      "Terrain t; t.height = 0.15; t.frequency = 1.3; t.octaves = 10; t.persistence = 0.5; "
      "t.lacunarity = 2.03; t.power = 2.1;"
      "t.ridged = false; t.sharpness = 14.0; t.ranges.part = 0.3; t.ranges.low = 0.1; t.ranges.first = 1; t.seed = 3u;"
      "t.craters.depth = 1.0; t.craters.frequency = 2.0; t.craters.sizes = 6; t.craters.seed = 3u;"
      "t.ice.sea = 0.3; t.ice.sine = 0.8; t.ice.thickness = 0.0012; t.ice.seed = 3u;"
      "Height h = terrain_height_at(a.xyz, t, 0.0001); result = vec4(h.gradient, h.value);",
      in);
  f64::Terrain t;
  t.height = double{0.15F};
  t.frequency = double{1.3F};
  t.octaves = 10;
  t.persistence = 0.5;
  t.lacunarity = double{2.03F};
  t.power = double{2.1F};
  t.ridged = false;
  t.sharpness = 14.0;
  t.ranges = {double{0.3F}, 1, double{0.1F}};
  t.seed = 3U;
  t.craters.depth = 1.0;
  t.craters.frequency = 2.0;
  t.craters.sizes = 6;
  t.craters.seed = 3U;
  t.ice = {0.3, 0.8, double{0.0012F}, 3U};
  for (std::size_t i = 0; i < out.size(); ++i) {
    const f64::Height expected = f64::terrain_height_at(glm::dvec3(in[2 * i]), t, double{0.0001F});
    ASSERT_NEAR(out[i].w, expected.value, 1.5e-6);
    ASSERT_LT(glm::distance(glm::dvec3(out[i]), expected.gradient),
              4e-3);  // measured 2.3e-3, at sharp crests of ranges
  }
}

TEST_P(OnGpu, Optics) {
  const auto in = inputs([](test::Places& p) {
    return std::pair(glm::vec4(p.between(-0.1, 1.1), p.between(0.0, 1.0), p.between(0.0, 32.0), p.between(-1.0, 1.0)),
                     glm::vec4(0.0F));
  });
  const auto out = test::run_on_gpu(
      {"air"}, "result = vec4(schlick(a.x, a.y), fresnel_alpha(a.x, a.z), wrap_diffuse(a.w, a.y), 0.0);", in);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const glm::dvec4 a(in[2 * i]);
    ASSERT_NEAR(out[i].x, f64::schlick(a.x, a.y), 8.0 * u);
    const double alpha = f64::fresnel_alpha(a.x, a.z);
    const double x = std::fmax(1.0 - std::fmin(std::fmax(a.x, 0.0), 1.0), 1e-30);
    const double bound = 4.0 * u * (8.0 + 4.0 * std::fabs(a.z * std::log2(x)) + 2.0 * a.z) + a.z * std::ldexp(1.0, -20);
    ASSERT_NEAR(out[i].y, alpha, bound * alpha + 1e-30);
    ASSERT_NEAR(out[i].z, f64::wrap_diffuse(a.w, a.y), 8.0 * u);
  }
}

TEST_P(OnGpu, Waves) {
  const auto in = inputs([](test::Places& p) {
    return std::pair(glm::vec4(glm::vec3(p.on_sphere()), p.between(10.0, 300.0)),
                     glm::vec4(glm::vec3(p.on_sphere()), p.between(-3.1, 3.1)));
  });
  const auto out = test::run_on_gpu(
      {"noise", "waves"},
      "vec3 v = normalize(a.xyz); Frame f; f.east = perpendicular(v); f.north = cross(v, f.east);"
      "Wave w; w.origin = normalize(b.xyz); w.amplitude = 0.01; w.wavenumber = a.w; w.phase = b.w; w.pinch = 0.002;"
      "WaveSum s = no_waves(); add_wave(s, v, f, w, 1.0); result = vec4(s.height, wave_normal(s));",
      in);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const glm::dvec3 v = glm::normalize(glm::dvec3(in[2 * i]));
    f64::Frame f;
    f.east = f64::perpendicular(v);
    f.north = glm::cross(v, f.east);
    f64::Wave w;
    w.origin = glm::normalize(glm::dvec3(in[2 * i + 1]));
    w.amplitude = 0.01;
    w.wavenumber = double{in[2 * i].w};
    w.phase = double{in[2 * i + 1].w};
    w.pinch = 0.002;
    f64::WaveSum s = f64::no_waves();
    f64::add_wave(s, v, f, w, 1.0);
    // A driver's atan may be off by 2.5e-4 of an angle's last turn; the wavenumber multiplies it.
    ASSERT_NEAR(out[i].x, s.height, (2.5e-4 + 64.0 * u * w.wavenumber) * w.amplitude);
  }
}

TEST_P(OnGpu, ShortWaves) {
  const auto in = inputs([](test::Places& p) {
    return std::pair(glm::vec4(p.between(-6.0, 6.0), p.between(-6.0, 6.0), p.between(0.0, 6.2), p.between(-3.1, 3.1)),
                     glm::vec4(p.between(-1.7, 1.7), p.between(0.0, 1.0), 0.0, 0.0));
  });
  const auto out = test::run_on_gpu(
      {"noise", "short_waves"},
      "ShortWave w; w.direction = vec2(cos(a.z), sin(a.z)); w.wavenumber = 1.0e6; w.phase = a.w; w.amplitude = 1.0e-8;"
      "w.pinch = 0.5e-8; w.bend = b.x; WaveSum s = no_waves(); w.begins = 0.0; add_short_wave(s, course_of(w, a.xy * "
      "1.0e-5), w, b.y);"
      "result = vec4(s.height * 1.0e8, s.slope * 100.0, s.stretch_en * 100.0);",
      in);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const glm::dvec4 a(in[2 * i]), b(in[2 * i + 1]);
    const f64::ShortWave w = {{std::cos(a.z), std::sin(a.z)}, 1e6, a.w, 1e-8, 0.5e-8, b.x, 0.0};
    f64::WaveSum s = f64::no_waves();
    f64::add_short_wave(s, f64::course_of(w, glm::dvec2(a) * 1e-5), w, b.y);
    // Of 85 rad at the most; a driver's cosine, which tells the direction, may be off by 2.5e-4.
    ASSERT_NEAR(out[i].x, s.height * 1e8, 0.03);
    ASSERT_LT(glm::distance(glm::dvec2(out[i].y, out[i].z), s.slope * 100.0), 0.04);
    ASSERT_NEAR(out[i].w, s.stretch_en * 100.0, 0.02);
  }
}

TEST_P(OnGpu, Shoaling) {
  const auto in = inputs([](test::Places& p) {
    return std::pair(glm::vec4(p.between(-0.5, 4.0), p.between(-1.0, 1.0), p.between(-1.0, 1.0), 0.0), glm::vec4(0.0));
  });
  const auto out = test::run_on_gpu(
      {"noise", "open_water"},
      "result = vec4(gained_phase(a.x), shortened(a.x), foam_left(a.y, a.z), left_ashore(a.x, 1.0));", in);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const glm::dvec4 a(in[2 * i]);
    ASSERT_NEAR(out[i].x, f64::gained_phase(a.x), 2e-3);
    ASSERT_NEAR(out[i].y, f64::shortened(a.x), 1e-3);
    ASSERT_NEAR(out[i].z, f64::foam_left(a.y, a.z), 2e-3);
    ASSERT_NEAR(out[i].w, f64::left_ashore(a.x, 1.0), 1e-5);
  }
  // Where there is no wave, as beyond the run-up.
  const auto calm = test::run_on_gpu({"noise", "open_water"}, "result = vec4(foam_left(a.x, a.y));",
                                     std::vector<glm::vec4>(2, glm::vec4(0.0F)));
  EXPECT_EQ(calm.front().x, 1.0F);
}

TEST_P(OnGpu, Caustics) {
  const auto in = inputs([](test::Places& p) {
    return std::pair(glm::vec4(p.between(-2.0, 2.0), p.between(-1.0, 1.0), p.between(-2.0, 2.0), p.between(0.0, 4.0)),
                     glm::vec4(p.between(0.0, 5.0), 0.0, 0.0, 0.0));
  });
  const auto out = test::run_on_gpu({"noise", "caustics"},
                                    "Lens lens; lens.power = a.xyz; lens.spread = a.w;"
                                    "result = vec4(gathered_light(lens, 0.5, b.x, 1.333));",
                                    in);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const glm::dvec4 a(in[2 * i]);
    ASSERT_NEAR(out[i].x, f64::gathered_light({glm::dvec3(a), a.w}, 0.5, in[2 * i + 1].x, 1.333), 1e-4);
  }
}

TEST_P(OnGpu, ToneAndSrgb) {
  const auto in = inputs([](test::Places& p) {
    return std::pair(glm::vec4(std::pow(10.0, p.between(-4.0, 4.0)), p.between(0.0, 1.0), 0.0, 0.0), glm::vec4(0.0F));
  });
  const auto out = test::run_on_gpu(
      {"color"}, "result = vec4(tone_map(vec3(a.x), 0).x, srgb_encode(a.y), tone_map(vec3(a.x), 1).x, 0.0);", in);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const glm::dvec4 a(in[2 * i]);
    ASSERT_NEAR(out[i].x, f64::filmic(a.x), 1e-5);
    ASSERT_NEAR(out[i].y, f64::srgb_encode(a.y), 1e-5);
    ASSERT_NEAR(out[i].z, f64::tone_map(glm::dvec3(a.x), 1).x, 1e-5);
  }
}

// Heights and slopes of a map, of all levels, as the CPU reads it in double precision.
TEST_P(OnGpu, MapOfHeights) {
  const SharedHeightMap map = test::smooth_map(256, 128);
  const gl::HeightTexture texture(*map);
  texture.bind(gl::unit_heights);
  glActiveTexture(GL_TEXTURE0);  // where others may be bound
  const auto in = inputs([](test::Places& p) {
    return std::pair(glm::vec4(glm::vec3(p.on_sphere()), std::pow(10.0, p.between(-3.0, 0.5))), glm::vec4(0.0F));
  });
  const char* const map_of = "MapHeight h = map_height_at(height_map, normalize(a.xyz), a.w); ";
  const char* const globals = "uniform highp sampler2D height_map;\n";
  const auto heights =
      test::run_on_gpu({"height_map"}, std::string(map_of) + "result = vec4(h.gradient, h.value);", in, globals);
  const auto reliefs =
      test::run_on_gpu({"height_map"}, std::string(map_of) + "result = vec4(h.relief, 0.0, 0.0, 0.0);", in, globals);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const glm::vec4& a = in[2 * i];
    const f64::MapHeight expected =
        f64::map_height_at({map.get(), map->serial()}, glm::normalize(glm::dvec3(a)), double{a.w});
    ASSERT_NEAR(heights[i].w, expected.value, 4e-6);
    ASSERT_LT(glm::distance(glm::dvec3(heights[i]), expected.gradient), 4e-4) << a.x << " " << a.y << " " << a.z;
    ASSERT_NEAR(reliefs[i].x, expected.relief, 4e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(Contexts, OnGpu, testing::Values(Api::core, Api::es),
                         [](const auto& context) { return context.param == Api::core ? "Core" : "Es"; });

}  // namespace
}  // namespace terrella
