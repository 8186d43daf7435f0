#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "effort.hpp"
#include "measure/ground_models.hpp"
#include "native/cmd_measure.hpp"
#include "run_command.hpp"

namespace terrella {
namespace {

using test::Outcome;

Outcome run(const std::string& line) { return test::run_command(add_measure_command, line); }

// An old report, or what somebody takes for one; gone with its owner.
class OldReport {
 public:
  explicit OldReport(const std::string& text) : path(testing::TempDir() + "terrella_old_report.json") {
    std::ofstream(path) << text;
  }
  ~OldReport() { std::filesystem::remove(path); }
  OldReport(const OldReport&) = delete;
  OldReport& operator=(const OldReport&) = delete;

  const std::string path;
};

TEST(MeasureCommand, SaysWhatIsWrongAndMakesNoFolder) {
  const std::string folder = testing::TempDir() + "terrella_not_measured";
  const std::pair<const char*, const char*> cases[] = {
      {"--preset strom", "preset: there is no preset \"strom\"; did you mean storm?\n"},
      {"--set quality.pixel_errors=1",
       "quality.pixel_errors: there is no such parameter; did you mean quality.pixel_error?\n"},
      {"--size 0x10", "--size: \"0x10\" is not a size; give WIDTHxHEIGHT, each 1 to 4096, as in 1280x720.\n"},
      {"--size 8192x64", "--size: \"8192x64\" is not a size; give WIDTHxHEIGHT, each 1 to 4096, as in 1280x720.\n"},
      {"--gl vulkan", "--gl: \"vulkan\" is not a kind of OpenGL; there are core and es.\n"}};
  for (const auto& [options, sentence] : cases) {
    const Outcome outcome = run(text_of("measure ", options, " --out ", folder));
    EXPECT_EQ(outcome.code, 2) << options;
    EXPECT_EQ(outcome.said, sentence) << options;
  }
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(MeasureCommand, SaysWhyAnOldReportIsNone) {
  EXPECT_EQ(run("measure --out unused --against /no/such/file").code, 2);
  const std::pair<const char*, const char*> cases[] = {
      {"", ": is not a report: it is no JSON object.\n"},
      {"\x01\xff garbage", ": is not a report: it is no JSON object.\n"},
      {"[1, 2]", ": is not a report: it is no JSON object.\n"},
      {"{\"renderer\": \"an extremes' report\"}", ": is not a report of the trade: it has no schema.\n"},
      {"{\"schema\": 999}", ": is of schema 999; this program reads 1.\n"},
      {"{\"schema\": 1}", ": is not a whole report: times or errors of its settings are missing.\n"}};
  for (const auto& [text, sentence] : cases) {
    const OldReport old(text);
    const Outcome outcome = run(text_of("measure --out unused --against ", old.path));
    EXPECT_EQ(outcome.code, 2) << text;
    EXPECT_EQ(outcome.said, old.path + sentence) << text;
  }
}

TEST(MeasureCommand, ExtremesHaveNoneOfTheTrade) {
  for (const char* option : {"--size 64x36", "--gl es", "--against unused"}) {
    const Outcome outcome = run(text_of("measure --extremes --out unused ", option));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.said, text_of(std::string(option).substr(0, std::string(option).find(' ')),
                                    ": is for the trade of speed for accuracy; --extremes has none of it.\n"));
  }
}

TEST(MeasureCommand, GroundsAreMeasuredByThemselves) {
  const std::pair<const char*, const char*> cases[] = {
      {"--ground --against unused", "--against: is for the trade of speed for accuracy; --ground has none of it.\n"},
      {"--ground --path", "--path: is for the trade of speed for accuracy; --ground has none of it.\n"},
      {"--ground --extremes", "--ground: is measured by itself; leave out --extremes.\n"},
      {"--ground --preset storm", "--ground: is for planets of real size; there are blue, highlands and giant.\n"},
      {"--ground --frames -1", "--frames: must be a whole number, 0 to 1000.\n"},
      {"--frames 3", "--frames: is for --ground.\n"},
      {"--extremes --frames 3", "--frames: is for --ground.\n"},
      {"--flight", "--flight: is for --ground.\n"},
      {"--extremes --flight", "--flight: is for --ground.\n"},
      {"--ground --flight --frames 3", "--flight: draws nothing; leave out --frames.\n"}};
  for (const auto& [options, sentence] : cases) {
    const Outcome outcome = run(text_of("measure --out unused ", options));
    EXPECT_EQ(outcome.code, 2) << options;
    EXPECT_EQ(outcome.said, sentence) << options;
  }
}

TEST(MeasureCommand, FliesToTheGround) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "terrella_flight";
  testing::internal::CaptureStdout();
  const Outcome outcome =
      run(text_of("measure --ground --flight --quick --size 64x36 --preset blue --set terrain.octaves=4 "
                  "--set water.model=none --set clouds.model=none --out ",
                  folder.string()));
  const std::string told = testing::internal::GetCapturedStdout();
  EXPECT_EQ(outcome.code, 0) << outcome.said;
  for (const char* const model : {"quadtree", "triangle_lod", "persistent_grid"})
    EXPECT_NE(told.find(model), std::string::npos) << told;
}

// From end to end: a planet so smooth that few triangles suffice.
TEST(MeasureCommand, MeasuresGroundsAndDrawsThem) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "terrella_ground";
  testing::internal::CaptureStdout();
  const Outcome outcome =
      run(text_of("measure --ground --quick --size 32x18 --frames 1 --preset blue --set terrain.height=1000 "
                  "--set terrain.octaves=4 --set water.model=none --set clouds.model=none --out ",
                  folder.string()));
  const std::string told = testing::internal::GetCapturedStdout();
  EXPECT_NE(told.find("| blue "), std::string::npos) << told;
  const auto report = nlohmann::json::parse(std::ifstream(folder / "report.json"));
  EXPECT_EQ(report["size"], (nlohmann::json{32, 18}));
  EXPECT_EQ(report["rows"].size(), 6 * ground_models().size());  // from three altitudes, for 1 and 2 pixels
  EXPECT_EQ(outcome.code, report["broken"].empty() ? 0 : 1) << outcome.said;
  for (const auto& row : report["rows"]) EXPECT_GT(row["frame_ms"]["median"], 0.0);
  EXPECT_TRUE(std::filesystem::exists(folder / "index.html"));
  std::filesystem::remove_all(folder);
}

TEST(MeasureCommand, DrawsItsOwnScenes) {
  const Outcome outcome = run("measure --extremes --set sun.size=1 --out unused");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.said,
            "--extremes: draws scenes of its own; leave out --preset, --scene, --link, --quality and --set.\n");
}

TEST(MeasureCommand, SaysWhichFolderCannotBeMadeBeforeItMeasures) {
  const Outcome outcome = run("measure --extremes --out /dev/null/folder");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.said, "/dev/null/folder: cannot be made: Not a directory.\n");
}

// From end to end: writes both files, and finds that an older report was better when it says so.
TEST(MeasureCommand, MeasuresTheTradeAndComparesIt) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "terrella_trade";
  const std::string line = text_of(
      "measure --quick --size 32x18 --set clouds.model=none --set water.model=none --set stars.model=none "
      "--set lights.density=0 --set terrain.octaves=4 --out ",
      folder.string());
  EXPECT_EQ(run(line).code, 0);
  auto report = nlohmann::json::parse(std::ifstream(folder / "report.json"));
  EXPECT_EQ(report["machine"]["size"], (nlohmann::json{32, 18}));
  EXPECT_TRUE(std::filesystem::exists(folder / "index.html"));
  for (auto& setting : report["settings"]) setting["psnr"] = 1.0 + setting["psnr"].get<double>();
  const OldReport better(report.dump());
  testing::internal::CaptureStdout();
  const Outcome outcome = run(line + " --against " + better.path);
  const std::string told = testing::internal::GetCapturedStdout();
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.said.find("became slower or less accurate than in " + better.path), std::string::npos);
  EXPECT_NE(told.find(" is less accurate: "), std::string::npos) << told;
  std::filesystem::remove_all(folder);
}

TEST(MeasureCommand, NeedsAFolder) {
  CLI::App program;
  int code = 0;
  add_measure_command(program, code);
  EXPECT_THROW(program.parse("measure --extremes"), CLI::RequiredError);
}

}  // namespace
}  // namespace terrella
