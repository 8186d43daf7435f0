#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "probe/arguments.hpp"
#include "probe/hostile.hpp"
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

TEST(Protocol, NothingThatIsSentStopsTheStream) {
  const std::string deep(1'000'000, '[');
  EXPECT_EQ(error_of("{\"id\": " + deep), "The line is nested deeper than 64 lists and objects.");
  EXPECT_EQ(answer_to(R"({"id": "[[{{\"[[", "fn": "wrap_diffuse", "args": {"cos": 1, "w": 0}})")["value"]["I"], 1.0);
  EXPECT_NE(error_of(std::string(20'000'000, 'x')), "none");
  EXPECT_NE(error_of(R"({"id": 1, "fn": "horizon", "args": {"r": 1e999, "alt": 1, "h_max": 1}})"), "none");
  EXPECT_NE(error_of(R"({"id": 1, "fn": "horizon", "args": {"r": NaN, "alt": 1, "h_max": 1}})"), "none");
  // Arguments of any size, where nothing may be computed that is not defined.
  for (const Function& function : functions()) {
    Random random(5U);
    Json args = function.random(random);
    for (const double huge : {1e300, -1e300, 1e38, 1e10, -1e10, 0.0, -0.0, 1e-300, 0.5}) {
      for (auto& [name, value] : args.items()) {
        Json tried = args;
        if (value.is_number()) tried[name] = huge;
        if (value.is_array() && !value.empty() && value[0].is_number()) tried[name][0] = huge;
        for (const char* precision : {"f64", "f32"}) {
          const Json answer = answer_to(Json{{"fn", function.name}, {"args", tried}, {"precision", precision}}.dump());
          EXPECT_TRUE(answer.contains("value") != answer.contains("error")) << tried.dump();
        }
      }
    }
  }
}

// One answer a line, and JSON, whatever was asked.
TEST(Protocol, HostileLinesAreAnswered) {
  for (const char* precision : {"f64", "f32"}) {
    const std::vector<std::string> lines = test::extreme_requests(100, precision, 7U);
    const std::vector<Json> answers = answers_to(lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      EXPECT_EQ(answers[i]["id"], i);
      EXPECT_TRUE(answers[i].contains("value") != answers[i].contains("error")) << lines[i];
    }
    for (const Json& answer : answers_to(test::garbled(lines, 8U))) {
      EXPECT_TRUE(answer.contains("value") != answer.contains("error")) << answer;
    }
  }
}

// An error of a line that is no JSON says what is wrong, and whose it is where that can be made out.
TEST(Protocol, BrokenLinesKeepTheirId) {
  const auto expect = [](const std::string& line, const Json& id, const std::string& error) {
    const Json answer = answer_to(line);
    EXPECT_EQ(answer["id"], id) << line;
    EXPECT_EQ(answer["error"], error) << line;
  };
  const std::string no_word = " is no value of JSON; numbers are finite and words stand in quotes.";
  expect(R"({"id": 7, "fn": "horizon", "args": {"r": NaN}})", 7, "\"NaN\"" + no_word);
  expect(R"({"fn": "horizon", "args": {"r": [-Infinity]}, "id": "x,}"})", "x,}", "\"-Infinity\"" + no_word);
  expect(R"({"id": {"a": [1, 2]}, "fn": "horizon", "args": {"r": 1e400}})", Json::parse(R"({"a": [1, 2]})"),
         "1e400 is too large; numbers are at most 1.797e308.");
  expect("{\"id\": 7, \"fn\": \"\xff\"}", 7, "The line is not UTF-8.");
  const std::string no_object = "The line is not a JSON object, {\"fn\": …, \"args\": {…}, \"precision\": …}.";
  expect(R"({"id": 7, "fn": "horizon", "args": {"r": )", 7, no_object);
  expect(R"({"id": 7, "fn": "horizon",, "args": {}})", 7, no_object);
  expect(R"({"args": {"id": 1}, "fn": "id", "id" :8,})", 8, no_object);
  // What may be only the beginning of one is none.
  expect(R"({"fn": "horizon", "id": 12)", nullptr, no_object);
  expect(R"({"fn": "horizon", "id": "12)", nullptr, no_object);
  expect(R"({"id": NaN, "fn": "horizon"})", nullptr, "\"NaN\"" + no_word);
  expect(R"(["id", "id": 7])", nullptr, no_object);
  expect("{\"id\": 7, \"fn\": " + std::string(100, '[') + "}", 7,
         "The line is nested deeper than 64 lists and objects.");
  expect("{\"id\": 7, \"fn\": \"" + std::string(kLongestLine, 'x') + "\"}", 7,
         "The line is longer than 10000000 bytes; no more are read.");
}

TEST(Protocol, SaysWhatPrecisionsThereAre) {
  const auto of = [](const char* precision) {
    return error_of(R"({"fn": "smooth_abs", "args": {"x": 1, "k": 1}, "precision": )" + std::string(precision) + "}");
  };
  EXPECT_EQ(of("null"), "precision: null is none; there are f64, f32 and gpu.");
  EXPECT_EQ(of("32"), "precision: 32 is none; there are f64, f32 and gpu.");
  EXPECT_EQ(of(R"(["f32"])"), "precision: [\"f32\"] is none; there are f64, f32 and gpu.");
  EXPECT_EQ(of(R"("")"), "precision: \"\" is none; there are f64, f32 and gpu.");
}

// What is right in double and not in single precision has a sentence there, instead of an infinity.
TEST(Protocol, SaysWhatSinglePrecisionCannotHold) {
  const auto expect = [](const std::string& request, const std::string& error) {
    EXPECT_TRUE(answer_to("{" + request + "}").contains("value")) << request;
    EXPECT_EQ(error_of("{" + request + R"(, "precision": "f32"})"), "In single precision: " + error);
  };
  expect(R"("fn": "cloud_signal", "args": {"alt": 1000, "bottom": 1000, "top": 1000.000001})",
         "cloud_signal: top is 1000 and bottom is 1000; the top lies above the bottom.");
  expect(R"("fn": "gerstner", "args": {"q": [0, 0, 0], "anchor": [1, 0, 0], "r": 1, "t": 0,
            "waves": [{"o": [0, 1, 0], "A": 0.1, "w": 5, "phi": 1, "Q": 0.5}], "fade": [0.5, 0.50000000001]})",
         "fade: [0.5, 0.5] does not rise; its first number is less than its second.");
  expect(R"("fn": "phase", "args": {"kind": "hg", "mu": 1, "g": 0.99999999999})",
         "g: 1.0 is out of range; allowed is more than -1 and less than 1.");
  expect(R"("fn": "ray_sphere", "args": {"o": [0, 0, 0], "d": [1e-50, 0, 0], "r": 1})",
         "ray_sphere: d is 0 and so has no direction.");
  expect(R"("fn": "horizon", "args": {"r": 1e-50, "alt": 0, "h_max": 0})",
         "r: 0.0 is out of range; allowed is more than 0.");
  expect(R"("fn": "horizon", "args": {"r": 1e30, "alt": 1, "h_max": 0})",
         "r: 1.0000000150474662e+30 is out of range; allowed is 0 or a size of 1e-18 to 1e18.");
  expect(R"("fn": "ray_sphere", "args": {"o": [0, 2305843009213693952, 0], "d": [0, 1, 0], "r": 1})",
         "o: [0.0,2.305843009213694e+18,0.0] is out of range; allowed is 0 or a size of 1e-18 to 1e18.");
}

TEST(Protocol, DirectionsThatCannotBeAreSentences) {
  const auto scatter = [](const char* angles) {
    return answer_to(R"({"fn": "single_scatter", "args": {"alt": 10, "dist": 100, "mie_scattering": 1e-6, )" +
                     std::string(angles) + "}}");
  };
  EXPECT_EQ(scatter(R"("mu": 0.6, "mu_s": 0.6, "nu": -0.5)")["error"],
            "single_scatter: nu is -0.5, but between a ray of mu 0.6 and a sun of mu_s 0.6 it is "
            "-0.28 to 1.");
  for (const char* angles : {R"("mu": 1, "mu_s": 0.3, "nu": 0.35)", R"("mu": 0, "mu_s": 1, "nu": -0.01)",
                             R"("mu": -0.6, "mu_s": 0.6, "nu": 0.29)"}) {
    EXPECT_TRUE(scatter(angles).contains("error")) << angles;
  }
  // The ends themselves, rounded to single precision too.
  for (const char* angles :
       {R"("mu": 1, "mu_s": 0.3, "nu": 0.3)", R"("mu": 0.6, "mu_s": 0.6, "nu": -0.28)",
        R"("mu": 0.60000002384, "mu_s": 0.60000002384, "nu": 1)", R"("mu": 1, "mu_s": 0.3, "nu": 0.3001)"}) {
    EXPECT_TRUE(scatter(angles).contains("value")) << angles;
  }
  EXPECT_EQ(
      error_of(R"({"fn": "transmittance", "args": {"alt": 100, "mu": -1}})"),
      "transmittance: with mu -1 the ray from alt 100 meets the ground, 6360000 under it at its lowest; it has to "
      "pass.");
  EXPECT_TRUE(answer_to(R"({"fn": "transmittance", "args": {"alt": 0, "mu": -1e-4}})").contains("value"));
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

// As near to where floats end as they come: nothing overflows on the way to an answer that a float holds.
TEST(Reference, SinglePrecisionHoldsToTheEndsOfItsDomain) {
  const auto value = [](const std::string& request) {
    const Json answer = answer_to("{" + request + R"(, "precision": "f32"})");
    EXPECT_TRUE(answer.contains("value")) << answer.dump() << " to " << request;
    return answer["value"];
  };
  for (const auto& [sigma, dist] : std::vector<std::pair<double, double>>{{1e35, 1.0},
                                                                          {1.0, 1e35},
                                                                          {3.4e38, 1.0},
                                                                          {3.4e38, 1e-38},
                                                                          {1e-38, 3.4e38},
                                                                          {3e34, 3e-35},
                                                                          {2e37, 3e-36},
                                                                          {3.4e38, 3.4e38}}) {
    const auto single = [](double x) { return static_cast<double>(static_cast<float>(x)); };
    const double x = single(sigma) * single(dist);
    const Json answer = value(R"("fn": "beer_lambert", "args": )" + Json{{"sigma", sigma}, {"dist", dist}}.dump());
    EXPECT_NEAR(answer["T"].get<double>(), std::exp(-x), 5e-7 * std::exp(-x));
    EXPECT_NEAR(answer["absorbed"].get<double>(), -std::expm1(-x), 5e-7);
    EXPECT_NEAR(answer["mean"].get<double>(), -std::expm1(-x) / x, 5e-7 / std::max(1.0, x) + 1e-38);
  }
  EXPECT_EQ(answer_to(R"({"fn": "beer_lambert", "args": {"sigma": 1, "dist": 5e-324}})")["value"]["mean"], 1.0);
  // Angles know no unit.
  for (const char* size : {"1e-40", "1e-300", "1e30", "1e300"}) {
    const std::string s = size;
    const Json answer =
        value(R"("fn": "arc_angle", "args": {"a": [)" + s + ", 0, 0], \"b\": [" + s + ", " + s + ", 0]}");
    EXPECT_NEAR(answer["angle"].get<double>(), 0.25 * std::numbers::pi, 1e-7) << size;
  }
  const Json apart = value(R"("fn": "arc_angle", "args": {"a": [1e-30, 0, 0], "b": [1e30, 1e30, 0]})");
  EXPECT_NEAR(apart["angle"].get<double>(), 0.25 * std::numbers::pi, 3e-7);
  // A step through a cloud so thick that its depth is an infinity still shines by what it scatters against what it
  // dims.
  const Json thick = value(
      R"("fn": "cloud_march", "args": {"density": [1e10], "step": 1e10, "E": 1e20, "S": 1e19, "phase": 0.5, "I_sun": 3})");
  EXPECT_EQ(thick["T"], 0.0);
  EXPECT_NEAR(thick["I"].get<double>(), 0.15, 1e-6);
}

// Each function with arguments that are all different, against its definition written out: an argument that took
// another's place would be the same mistake in every precision.
TEST(Reference, EveryArgumentHasItsPlace) {
  const auto value = [](const char* function, const char* args, const char* member) {
    const Json answer = answer_to(std::string(R"({"fn": ")") + function + R"(", "args": )" + args + "}");
    EXPECT_TRUE(answer.contains("value")) << answer.dump();
    const Json& found = answer["value"][member];
    return found.is_array() ? found.get<std::vector<double>>() : std::vector<double>{found.get<double>()};
  };
  const auto expect = [&](const char* function, const char* args, const char* member, std::vector<double> expected) {
    const std::vector<double> found = value(function, args, member);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i], expected[i], 1e-13 * (1.0 + std::fabs(expected[i]))) << function << " " << member;
    }
  };
  const double h = std::sqrt(3.0 * 23.0), s = std::sqrt(2.0 * 22.0);
  const char* const offset = R"({"r": 10, "alt": 3, "h_max": 2})";
  expect("grid_offset", offset, "h", {h});
  expect("grid_offset", offset, "s", {s});
  expect("grid_offset", offset, "zs", {(100.0 - h * s) / (10.0 * (h + s))});
  expect("grid_offset", offset, "phi", {std::atan2(h, 10.0) + std::atan2(s, 10.0)});
  expect("horizon", offset, "dist", {h});
  expect("horizon", offset, "angle", {std::acos(10.0 / 13.0)});
  expect("horizon", offset, "cull_angle", {std::acos(10.0 / 13.0) + std::acos(10.0 / 12.0)});

  const double rise = (1.0 - std::pow(0.3, 6)) * (1.0 - std::pow(0.7, 6)), up = rise + 0.4;
  const double size = std::sqrt(0.09 + 0.49 + up * up);
  const char* const point = R"({"gx": 0.3, "gy": -0.7, "zs": 0.4, "n": 6})";
  expect("grid_point", point, "gz", {rise});
  expect("grid_point", point, "dir", {0.3 / size, -0.7 / size, up / size});

  // The eye over the x axis: w = x, v = w x b = -y for b = z, u = v x w = z.
  const double zs = (100.0 - h * s) / (10.0 * (h + s)), high = rise + zs;
  const double length = std::sqrt(0.09 + 0.49 + high * high);
  expect("grid_world", R"({"gx": 0.3, "gy": -0.7, "n": 6, "r": 10, "h_max": 2, "cam": [13, 0, 0], "b": [0, 0, 5]})",
         "rel", {10.0 * high / length - 13.0, 7.0 / length, 3.0 / length});

  expect("arc_angle", R"({"a": [1, 0, 0], "b": [0.6, 0, -0.8]})", "angle", {std::atan2(0.8, 0.6)});
  expect("ray_sphere", R"({"o": [0, 3, -9], "d": [0, 0, 2], "r": 5})", "t", {2.5, 6.5});
  const double root = std::sqrt(13.0 * 13.0 * 0.64 - 3.0 * 23.0 + 2.0 * 22.0);
  expect("ray_shell", R"({"r": 10, "alt": 3, "mu": -0.8, "h": 2})", "t0", {13.0 * 0.8 - root});
  expect("ray_shell", R"({"r": 10, "alt": 3, "mu": -0.8, "h": 2})", "t1", {13.0 * 0.8 + root});
  expect("split_distance", R"({"edge": 7, "max_px": 3, "fov_x": 1.1, "width": 640})", "dist",
         {7.0 * 640.0 / (2.0 * 3.0 * std::tan(0.55))});

  const double sum = 1.0 + 0.3 + 0.09;
  expect("octave_sum", R"({"values": [0.5, -0.2, 0.8], "persistence": 0.3, "mode": "fbm"})", "h",
         {(0.75 + 0.3 * 0.4 + 0.09 * 0.9) / sum});
  expect("octave_sum", R"({"values": [0.5, -0.2, 0.8], "persistence": 0.3, "mode": "ridge"})", "h",
         {(0.5 + 0.3 * 0.8 + 0.09 * 0.2) / sum});
  expect("octave_sum", R"({"values": [0.5, -0.2, 0.8], "persistence": 0.3, "mode": "ridge", "k": 4})", "h",
         {1.0 - (0.5 * std::tanh(2.0) + 0.06 * std::tanh(0.8) + 0.072 * std::tanh(3.2)) / sum});
  expect("octave_sum", R"({"values": [], "persistence": 0.3, "mode": "ridge"})", "h", {0.0});
  expect("smooth_abs", R"({"x": -0.7, "k": 3})", "y", {0.7 * std::tanh(2.1)});
  expect("height_power", R"({"h": 0.4, "H": 900, "p": 1.7})", "y", {900.0 * std::pow(0.4, 1.7)});
  expect("height_power", R"({"h": 0, "H": 900, "p": 0})", "y", {900.0});
  expect("height_power", R"({"h": -0.1, "H": 900, "p": 2})", "y", {0.0});
  const double r0 = std::pow((1.0 - 1.5) / 2.5, 2);
  expect("schlick", R"({"cos": 0.3, "n1": 1, "n2": 1.5})", "R", {r0 + (1.0 - r0) * std::pow(0.7, 5)});
  expect("fresnel_alpha", R"({"cos": 0.3, "a": 2.5})", "alpha", {std::pow(0.7, 2.5)});
  expect("fresnel_alpha", R"({"cos": 1, "a": 0})", "alpha", {1.0});
  expect("wrap_diffuse", R"({"cos": -0.1, "w": 0.4})", "I", {0.3 / 1.4});
  expect("phase", R"({"kind": "rayleigh", "mu": 0.5})", "p", {3.0 / (16.0 * std::numbers::pi) * 1.25});
  expect("phase", R"({"kind": "hg", "mu": 0.5, "g": 0.7})", "p",
         {0.51 / (4.0 * std::numbers::pi * std::pow(0.79, 1.5))});
  expect("beer_lambert", R"({"sigma": 0.3, "dist": 5})", "T", {std::exp(-1.5)});
  expect("beer_lambert", R"({"sigma": 0.3, "dist": 5})", "absorbed", {1.0 - std::exp(-1.5)});
  expect("beer_lambert", R"({"sigma": 0.3, "dist": 5})", "mean", {(1.0 - std::exp(-1.5)) / 1.5});
  expect("cloud_signal", R"({"alt": 1500, "bottom": 1000, "top": 3000})", "h", {0.75});
  const char* const cloud = R"({"density": [0.5, -2, 1.5], "step": 3, "E": 0.2, "S": 0.1, "phase": 0.6, "I_sun": 7})";
  expect("cloud_march", cloud, "T", {std::exp(-1.2)});
  expect("cloud_march", cloud, "I", {0.1 / 0.2 * 0.6 * 7.0 * (1.0 - std::exp(-1.2))});
  const char* const segments = R"({"segments": [{"TA": 0.9, "IA": 0.1, "TC": 0.5, "IC": 0.3},
                                                {"TA": 0.8, "IA": 0.2, "TC": 0.7, "IC": 0.4}]})";
  expect("march", segments, "T", {0.45 * 0.56});
  expect("march", segments, "I", {0.35 + 0.45 * 0.54});

  // A layer of air so thin that nothing dims: what is scattered is what is there.
  const char* const thin = R"({"alt": 0, "mu": 1, "mu_s": 0.5, "nu": 0.5, "dist": 100, "mie_scattering": 3e-9,
      "atm": {"rayleigh": [1e-9, 2e-9, 4e-9], "rayleigh_H": 50, "mie": 0, "mie_H": 20, "ozone": 0}})";
  const double air = 50.0 * (1.0 - std::exp(-2.0)), haze = 20.0 * (1.0 - std::exp(-5.0));
  const auto scattered = value("single_scatter", thin, "R"), mist = value("single_scatter", thin, "M");
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(scattered[i] / ((i == 0 ? 1e-9 : i == 1 ? 2e-9 : 4e-9) * air), 1.0, 1e-6);
    EXPECT_NEAR(mist[i] / (3e-9 * haze), 1.0, 1e-6);
  }
  // Each field of an air, straight up from 40 m: only one part is there at a time.
  expect("transmittance", R"({"alt": 40, "mu": 1, "atm": {"bottom": 1000, "top": 1200, "rayleigh": [1e-3, 2e-3, 3e-3],
      "rayleigh_H": 50, "mie": 0, "mie_H": 70, "ozone": 0}})",
         "tau",
         {0.05 * (std::exp(-0.8) - std::exp(-4.0)), 0.1 * (std::exp(-0.8) - std::exp(-4.0)),
          0.15 * (std::exp(-0.8) - std::exp(-4.0))});
  expect("transmittance", R"({"alt": 40, "mu": 1, "atm": {"bottom": 1000, "top": 1200, "rayleigh": 0,
      "rayleigh_H": 50, "mie": [1e-3, 2e-3, 3e-3], "mie_H": 80, "ozone": 0}})",
         "tau",
         {0.08 * (std::exp(-0.5) - std::exp(-2.5)), 0.16 * (std::exp(-0.5) - std::exp(-2.5)),
          0.24 * (std::exp(-0.5) - std::exp(-2.5))});
  expect("transmittance", R"({"alt": 40, "mu": 1, "atm": {"bottom": 1000, "top": 1200, "rayleigh": 0, "mie": 0,
      "ozone": [1e-3, 2e-3, 3e-3], "ozone_center": 100, "ozone_half": 30}})",
         "tau", {0.03, 0.06, 0.09});
}

}  // namespace
}  // namespace terrella::probe
