// Single precision on the CPU and on the driver, held to double precision over each function's whole domain.
#include <gtest/gtest.h>

#include "native/egl_context.hpp"
#include "probe/hostile.hpp"
#include "probe/probe.hpp"

namespace terrella::probe {
namespace {

// Each function so often; the sanitizers take ten times as long.
constexpr int tries = 1000;

void hold(Gpu* gpu, unsigned seed) {
  for (const Accuracy& a : fuzz(tries, seed, gpu)) {
    EXPECT_GT(a.tries, 0) << a.function;
    EXPECT_LE(a.f32, 1.0) << a.function << " at " << a.worst_f32;
    EXPECT_LE(a.gpu, 1.0) << a.function << " at " << a.worst_gpu;
    EXPECT_EQ(a.gpu < 0.0, gpu == nullptr) << a.function;
  }
}

TEST(Bounds, HoldInSinglePrecision) { hold(nullptr, 11U); }

class OnGpu : public testing::TestWithParam<Api> {
 protected:
  std::unique_ptr<EglContext> context;  // outlives the probe, whose objects live in it
  Probe probe{[this] {
    auto made = EglContext::make(GetParam());
    if (made) context = std::move(*made);
    return static_cast<bool>(made);
  }};
};

TEST_P(OnGpu, BoundsHold) {
  ASSERT_NE(probe.gpu(), nullptr);
  hold(probe.gpu(), 12U);
}

TEST_P(OnGpu, AnswersOfABatchStayInOrder) {
  std::vector<std::string> lines;
  for (int i = 0; i < 200; ++i) {
    const Json args = i % 3 == 0 ? Json{{"cos", 0.001 * i}, {"w", 0.5}} : Json{{"x", 0.01 * i}, {"k", 2}};
    lines.push_back(Json{{"id", i},
                         {"fn", i % 3 == 0 ? "wrap_diffuse" : "smooth_abs"},
                         {"args", args},
                         {"precision", i % 5 == 0 ? "f64" : "gpu"}}
                        .dump());
  }
  const auto answers = probe.answer(lines);
  for (int i = 0; i < 200; ++i) {
    const Json answer = Json::parse(answers[static_cast<std::size_t>(i)]);
    EXPECT_EQ(answer["id"], i);
    if (i % 3 == 0) {
      EXPECT_NEAR(answer["value"]["I"].get<double>(), (0.001 * i + 0.5) / 1.5, 1e-6);
    } else {
      EXPECT_NEAR(answer["value"]["y"].get<double>(), 0.01 * i * std::tanh(0.02 * i), 1e-5);
    }
  }
}

TEST_P(OnGpu, EachRequestReadsItsOwnMap) {
  const Function& function = *find_function("mapped_height");
  Random random(4U);
  Json args = function.random(random);
  args["octaves"] = 0;
  args["H"] = 1.0;
  std::vector<std::string> lines;
  for (int i = 0; i < 12; ++i) {
    const double height = 0.05 * (1 + i / 2);
    args["map"] = {{"width", 8 + i}, {"height", 8}, {"heights", std::vector<double>(8U * (8U + i), height)}};
    lines.push_back(Json{{"id", height}, {"fn", function.name}, {"args", args}, {"precision", "gpu"}}.dump());
  }
  for (const std::string& line : probe.answer(lines)) {
    const Json answer = Json::parse(line);
    ASSERT_TRUE(answer.contains("value")) << line;
    EXPECT_NEAR(answer["value"]["height"].get<double>(), answer["id"].get<double>(), 1e-6);
  }
}

// A software rasterizer gives up on loops that turn too often, and on those of the vertices beside it. Whoever asked
// for little is answered all the same, and who asked for too much is not answered wrongly.
TEST_P(OnGpu, NoAnswerDependsOnWhatIsAskedBesideIt) {
  const auto asked = [](const char* scale_height) {
    return std::string(
               R"({"fn": "single_scatter", "precision": "gpu", "args": {"alt": 2, "mu": 0, "mu_s": 0.5, "nu": 0.3,
        "dist": 5e5, "mie_scattering": 1e-6, "atm": {"rayleigh_H": )") +
           scale_height + "}}}";
  };
  const std::string small = asked("8000"), large = asked("1e-3");
  const std::vector<std::string> beside = probe.answer(std::vector<std::string>{large, small, large, small});
  const std::string alone = probe.answer(std::vector<std::string>{small}).at(0);
  EXPECT_NE(alone.find("value"), std::string::npos) << alone;
  EXPECT_EQ(beside[1], alone);
  EXPECT_EQ(beside[3], alone);
  EXPECT_EQ(beside[0], probe.answer(std::vector<std::string>{large}).at(0));
}

TEST_P(OnGpu, HostileRequestsAreAnswered) {
  const std::vector<std::string> lines = test::extreme_requests(50, "gpu", 9U);
  const std::vector<std::string> answers = probe.answer(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Json answer = Json::parse(answers[i]);
    EXPECT_EQ(answer["id"], i);
    EXPECT_TRUE(answer.contains("value") != answer.contains("error")) << lines[i];
  }
}

INSTANTIATE_TEST_SUITE_P(Contexts, OnGpu, testing::Values(Api::core, Api::es),
                         [](const auto& context) { return context.param == Api::core ? "Core" : "Es"; });

TEST(Accuracies, AreATableOfMarkdown) {
  const std::string table = accuracy_markdown(fuzz(2, 1U, nullptr));
  EXPECT_EQ(table.find("| function |"), 0U);
  EXPECT_NE(table.find("| `march` | 2 |"), std::string::npos);
  EXPECT_NE(table.find("no GPU"), std::string::npos);
}

}  // namespace
}  // namespace terrella::probe
