#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "probe/arguments.hpp"
#include "probe/probe.hpp"

namespace terrella::probe {
namespace {

std::vector<Json> answers_to(const std::vector<std::string>& lines) {
  Probe probe(nullptr);
  std::vector<Json> answers;
  for (const std::string& answer : probe.answer(lines)) {
    EXPECT_EQ(answer.find('\n'), std::string::npos);
    answers.push_back(Json::parse(answer));
  }
  EXPECT_EQ(answers.size(), lines.size());
  return answers;
}

Json answer_to(const std::string& line) { return answers_to({line}).at(0); }

std::string error_of(const std::string& line) { return answer_to(line).value("error", std::string("none")); }

TEST(Protocol, OneAnswerALineInTheSameOrderAndTheStreamGoesOn) {
  const auto answers =
      answers_to({R"({"id": 1, "fn": "wrap_diffuse", "args": {"cos": 0.5, "w": 1}})", "{broken", "", "[1, 2]",
                  "{\"id\": \"\xff\"}", R"({"id": "two", "fn": "nothing", "args": {}})",
                  R"({"id": [3], "fn": "wrap_diffuse", "args": {"cos": 1, "w": 0}, "precision": "f32"})",
                  R"({"fn": "wrap_diffuse", "args": {"cos": 1, "w": 0}})"});
  EXPECT_EQ(answers[0], Json::parse(R"({"id": 1, "value": {"I": 0.75}})"));
  for (const std::size_t bad : {1U, 2U, 3U, 4U}) {
    EXPECT_TRUE(answers[bad].contains("error"));
    EXPECT_TRUE(answers[bad]["id"].is_null());
  }
  EXPECT_EQ(answers[5]["id"], "two");
  EXPECT_TRUE(answers[5].contains("error"));
  EXPECT_EQ(answers[6], Json::parse(R"({"id": [3], "value": {"I": 1.0}})"));
  EXPECT_EQ(answers[7], Json::parse(R"({"id": null, "value": {"I": 1.0}})"));
}

TEST(Protocol, SaysWhatIsWrongAndWhatWasMeant) {
  EXPECT_EQ(error_of(R"({"fn": "horizn", "args": {}})"), "fn: there is no function \"horizn\"; did you mean horizon?");
  EXPECT_EQ(error_of(R"({"args": {}})"), "fn: the name of a function is missing; `terrella probe --list` prints them.");
  EXPECT_EQ(error_of(R"({"fn": 3, "args": {}})"), "fn: 3 is not the name of a function.");
  EXPECT_EQ(error_of(R"({"fn": "horizon"})"), "args: the arguments are missing; they are an object.");
  EXPECT_EQ(error_of(R"({"fn": "horizon", "args": 1})"), "args: 1 is not an object.");
  EXPECT_EQ(error_of(R"({"fn": "horizon", "args": {"r": 1, "alt": 1, "hmax": 1}})"),
            "horizon: there is no argument \"hmax\"; did you mean h_max?");
  EXPECT_EQ(error_of(R"({"fn": "horizon", "args": {"r": 1, "alt": 1}})"),
            "horizon: the argument h_max is missing; it is a number (m).");
  EXPECT_EQ(error_of(R"({"fn": "horizon", "args": {"r": "x", "alt": 1, "h_max": 1}})"),
            "r: \"x\" is not a number (m).");
  EXPECT_EQ(error_of(R"({"fn": "horizon", "args": {"r": 0, "alt": 1, "h_max": 1}})"),
            "r: 0 is out of range; allowed is more than 0.");
  EXPECT_EQ(error_of(R"({"fn": "arc_angle", "args": {"a": [1, 2], "b": [1, 2, 3]}})"),
            "a: [1,2] is not a list of three numbers.");
  EXPECT_EQ(error_of(R"({"fn": "phase", "args": {"kind": "gh", "mu": 1, "g": 0}})"),
            "kind: \"gh\" is not one of \"hg\", \"rayleigh\"; did you mean hg?");
  EXPECT_EQ(error_of(R"({"fn": "phase", "args": {"kind": "hg", "mu": 1, "g": 0}, "precision": "f46"})"),
            "precision: \"f46\" is none; there are f64, f32 and gpu; did you mean f64?");
  EXPECT_EQ(error_of(R"({"fn": "phase", "args": {"kind": "hg", "mu": 1, "g": 0}, "presicion": "f32"})"),
            "A request has no member \"presicion\"; did you mean precision?");
  EXPECT_EQ(error_of(R"({"fn": "march", "args": {"segments": [{"TA": 1, "IA": 1, "TC": 1}]}})"),
            "segments[0]: the argument IC is missing; it is a number.");
  EXPECT_EQ(error_of(R"({"fn": "transmittance", "args": {"alt": 0, "mu": 1, "atm": {"rayleih": 2}}})"),
            "atm: there is no argument \"rayleih\"; did you mean rayleigh?");
}

TEST(Protocol, DegenerateRequestsAreSentencesOrFinite) {
  for (
      const char* line :
      {R"({"fn": "grid_offset", "args": {"r": 1, "alt": 0, "h_max": 0}})",
       R"({"fn": "grid_world", "args": {"gx": 0, "gy": 0, "n": 4, "r": 1, "h_max": 0.1, "cam": [0, 0, 2], "b": [0, 0, 1]}})",
       R"({"fn": "grid_world", "args": {"gx": 0, "gy": 0, "n": 4, "r": 1, "h_max": 0.1, "cam": [0, 0, 0], "b": [0, 0, 1]}})",
       R"({"fn": "grid_point", "args": {"gx": 0, "gy": 0, "zs": 0, "n": 3}})",
       R"({"fn": "arc_angle", "args": {"a": [0, 0, 0], "b": [0, 0, 1]}})",
       R"({"fn": "ray_sphere", "args": {"o": [0, 0, 0], "d": [0, 0, 0], "r": 1}})",
       R"({"fn": "gerstner", "args": {"q": [0, 0, 0], "anchor": [1, 0, 0], "r": 1, "t": 0, "waves": [], "fade": [1, 1]}})",
       R"({"fn": "gerstner", "args": {"q": [0, 0, 0], "anchor": [0, 0, 0], "r": 1, "t": 0, "waves": []}})",
       R"({"fn": "cloud_signal", "args": {"alt": 0, "bottom": 1, "top": 1}})",
       R"({"fn": "schlick", "args": {"cos": 0, "n1": 1, "n2": -1}})",
       R"({"fn": "split_distance", "args": {"edge": 1, "max_px": 1, "fov_x": 3.2, "width": 1}})",
       R"({"fn": "phase", "args": {"kind": "hg", "mu": 1, "g": 1}})",
       R"({"fn": "phase", "args": {"kind": "hg", "mu": 1}})",
       R"({"fn": "transmittance", "args": {"alt": 0, "mu": 1, "atm": {"bottom": 10, "top": 5}}})",
       R"({"fn": "noise", "args": {"kind": "simplex"}})",
       R"({"fn": "noise", "args": {"kind": "simplex", "p": [1, 2, 3], "q": [1, 2, 3]}})"}) {
    const std::string error = error_of(line);
    EXPECT_NE(error, "none") << line;
    EXPECT_NE(error, "not finite") << line;
    EXPECT_TRUE(error.ends_with(".")) << error;
  }
  EXPECT_EQ(error_of(R"({"fn": "horizon", "args": {"r": 1e300, "alt": 1e300, "h_max": 0}})"), "not finite");
  EXPECT_EQ(error_of(R"({"fn": "horizon", "args": {"r": 1e300, "alt": 1, "h_max": 0}, "precision": "f32"})"),
            "not finite");
  EXPECT_EQ(error_of(R"({"fn": "grid_point", "args": {"gx": 0, "gy": 0, "zs": -1, "n": 2}})"), "not finite");
}

TEST(Protocol, WithoutAGpuSaysSo) {
  EXPECT_EQ(error_of(R"({"fn": "smooth_abs", "args": {"x": 1, "k": 1}, "precision": "gpu"})"), "no gpu");
}

TEST(Protocol, NumbersHaveAllTheirDigits) {
  Probe probe(nullptr);
  const std::string args = R"("fn": "schlick", "args": {"cos": 1, "n1": 1, "n2": 1.3})";
  const auto answers =
      probe.answer(std::vector<std::string>{"{" + args + "}", "{" + args + R"(, "precision": "f32"})"});
  const double r = (1.0 - 1.3) / (1.0 + 1.3);
  EXPECT_EQ(Json::parse(answers[0])["value"]["R"].get<double>(), r * r);
  const float single = (1.0F - 1.3F) / (1.0F + 1.3F);
  EXPECT_EQ(static_cast<float>(Json::parse(answers[1])["value"]["R"].get<double>()), single * single);
  EXPECT_LT(answers[1].size(), answers[0].size());
}

TEST(Protocol, RootsThatAreNotThereAreNull) {
  EXPECT_EQ(answer_to(R"({"fn": "ray_sphere", "args": {"o": [0, 0, 10], "d": [0, 0, 1], "r": 1}})")["value"],
            Json::parse(R"({"t": [-11.0, -9.0]})"));
  EXPECT_EQ(answer_to(R"({"fn": "ray_sphere", "args": {"o": [0, 5, 10], "d": [0, 0, 1], "r": 1}})")["value"],
            Json::parse(R"({"t": null})"));
  EXPECT_EQ(answer_to(R"({"fn": "ray_shell", "args": {"r": 1, "alt": 1, "mu": 0, "h": 0}})")["value"],
            Json::parse(R"({"t0": null, "t1": null})"));
}

TEST(Protocol, EveryFunctionTakesItsOwnRandomArgumentsInEveryPrecision) {
  Probe probe(nullptr);
  for (const Function& function : functions()) {
    Random random(3U);
    for (int i = 0; i < 3; ++i) {
      Json args = function.random(random);
      for (const char* precision : {"f64", "f32"}) {
        const Json request = {{"fn", function.name}, {"args", args}, {"precision", precision}};
        const Json answer = Json::parse(probe.answer(std::vector<std::string>{request.dump()}).at(0));
        EXPECT_TRUE(answer.contains("value")) << answer.dump() << " to " << request.dump();
      }
      // Without any of those that it needs, or with one more, it takes none.
      for (const Arg& arg : function.args) {
        Json fewer = args;
        fewer.erase(std::string(arg.name));
        if (!arg.optional) {
          EXPECT_FALSE(trouble_with(fewer, function.args, function.name).empty()) << arg.name;
        }
      }
      args["surplus"] = 1;
      EXPECT_FALSE(trouble_with(args, function.args, function.name).empty());
    }
  }
}

// What others have worked out (docs/numerics.md).
TEST(Reference, TransmittanceOfTheEarth) {
  const Json zenith = answer_to(R"({"fn": "transmittance", "args": {"alt": 0, "mu": 1, "atm": {}}})")["value"]["T"];
  const double expected[] = {0.94038, 0.86767, 0.76242};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(zenith[i].get<double>(), expected[i], 5e-6);
  const Json level = answer_to(R"({"fn": "transmittance", "args": {"alt": 0, "mu": 0}})")["value"]["T"];
  const double expected_level[] = {0.10645, 0.0095837, 5.2123e-5};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(level[i].get<double>() / expected_level[i], 1.0, 5e-5);
}

TEST(Reference, DoubleIsNotRoutedThroughSingle) {
  const Json answer = answer_to(R"({"fn": "horizon", "args": {"r": 6360000.1, "alt": 0.1, "h_max": 0}})");
  EXPECT_NEAR(answer["value"]["dist"].get<double>(), std::sqrt(0.1 * (2.0 * 6360000.1 + 0.1)), 1e-11);
}

TEST(Reference, NoiseFromACameraIsTheNoiseAtThatPlace) {
  for (const char* kind : {"simplex", "psrd", "fbm", "ridge", "flow", "worley"}) {
    const std::string head =
        std::string(R"({"fn": "noise", "args": {"kind": ")") + kind + R"(", "alpha": 0.4, "seed": 5, )";
    const Json there = answer_to(head + R"("p": [1001.25, -2000.5, 33.0]}})")["value"];
    const Json from_camera = answer_to(head + R"("cam": [1000, -2000, 30], "q": [1.25, -0.5, 3.0]}})")["value"];
    EXPECT_NEAR(there["n"].get<double>(), from_camera["n"].get<double>(), 1e-9) << kind;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(there["grad"][i].get<double>(), from_camera["grad"][i].get<double>(), 1e-6) << kind;
    }
  }
}

}  // namespace
}  // namespace terrella::probe
