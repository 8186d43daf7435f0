#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "native/cmd_measure.hpp"

namespace terrella {
namespace {

struct Outcome {
  int code;
  std::string said;
};

Outcome run(const std::string& line) {
  CLI::App program;
  Outcome outcome{0, {}};
  add_measure_command(program, outcome.code);
  testing::internal::CaptureStderr();
  program.parse(line);
  outcome.said = testing::internal::GetCapturedStderr();
  return outcome;
}

TEST(MeasureCommand, SaysThatOnlyTheExtremesAreThereSoFar) {
  const std::string folder = testing::TempDir() + "terrella_measured";
  const Outcome outcome = run("measure --preset storm --out " + folder);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.said, "measure: only the extremes can be measured so far; give --extremes.\n");
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(MeasureCommand, DrawsItsOwnScenes) {
  const Outcome outcome = run("measure --extremes --set sun.size=1 --out unused");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.said, "--extremes: draws scenes of its own; leave out --preset, --scene, --link and --set.\n");
}

TEST(MeasureCommand, SaysWhichFolderCannotBeMadeBeforeItMeasures) {
  const Outcome outcome = run("measure --extremes --out /dev/null/folder");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.said, "/dev/null/folder: cannot be made: Not a directory.\n");
}

TEST(MeasureCommand, NeedsAFolder) {
  CLI::App program;
  int code = 0;
  add_measure_command(program, code);
  EXPECT_THROW(program.parse("measure --extremes"), CLI::RequiredError);
}

}  // namespace
}  // namespace terrella
