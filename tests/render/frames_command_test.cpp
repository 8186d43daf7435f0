// `terrella render --frames`: how long frames take.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/text.hpp"
#include "effort.hpp"
#include "native/cmd_render.hpp"
#include "run_command.hpp"

namespace terrella {
namespace {

double frame_ms(const char* api) {
  const std::string at = (std::filesystem::path(testing::TempDir()) / text_of("terrella_frames_", api)).string();
  const test::Outcome outcome =
      test::run_command(add_render_command, text_of("render --preset storm --size 480x270 --frames 5 --gl ", api,
                                                    " --out ", at, ".png --stats ", at, ".json"));
  if (outcome.code != 0) throw std::runtime_error(outcome.said);
  return nlohmann::json::parse(*read_file(at + ".json", 1'000'000))["frame_ms"]["median"];
}

// To read a picture of floats as bytes, as OpenGL allows and OpenGL ES does not, would not wait for it there: then
// frames seemed to take a seventh of their time (llvmpipe).
TEST(FramesCommand, WaitsForPicturesOfBothApis) {
  const double core = frame_ms("core"), es = frame_ms("es");
  if (test::prints()) std::printf("core %.1f ms, es %.1f ms\n", core, es);
  EXPECT_GT(es, core / 3.0);
}

}  // namespace
}  // namespace terrella
