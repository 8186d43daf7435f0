// What goes out of the window and comes in: by the clipboard and by files.
#include <gtest/gtest.h>
#include <png.h>

#include <fstream>
#include <set>

#include <nlohmann/json.hpp>

#include "window/drop.hpp"
#include "window/patience.hpp"
#include "window/window_fixture.hpp"

namespace terrella::test {
namespace {

namespace fs = std::filesystem;

// Below the buttons, where notices come.
constexpr Box kNotices{18, 110, 320, 30};

std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

// "96 x 54"; empty if it is no PNG.
std::string size_of_png(const fs::path& path) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) return {};
  const std::string size = std::to_string(image.width) + " x " + std::to_string(image.height);
  png_image_free(&image);
  return size;
}

class ExchangeTest : public UsersWindowTest {
 protected:
  // By the size that is typed in the picture's menu.
  void save_picture(const std::string& width, const std::string& height) {
    const Picture closed = settled();
    hands->click(286, 74);
    constexpr Box menu{300, 85, 150, 165};
    ASSERT_TRUE(changes(closed, menu));
    settled();
    hands->click(315, 238);
    hands->tap({"Control_L", "a"});
    hands->type(width);
    hands->click(390, 238);
    hands->tap({"Control_L", "a"});
    hands->type(height);
    hands->click(436, 238);
  }

  bool comes(const std::string& file) {
    return until([&] { return fs::exists(folder / file); });
  }
};

TEST_F(ExchangeTest, CtrlVLoadsAScene) {
  ASSERT_TRUE(paste(R"({"preset":"moon","camera":{"longitude":90},"time":{"speed":0}})"));
  EXPECT_TRUE(until([this] { return copied_link() == "preset=moon&camera.longitude=90&time.speed=0"; }));
}

TEST_F(ExchangeTest, OfABrokenSceneOnlyANoticeComes) {
  const Picture before = settled();
  const std::string link = copied_link();
  ASSERT_TRUE(paste(R"({"planet":{"radius":)"));
  EXPECT_TRUE(changes(before, kNotices));
  EXPECT_EQ(copied_link(), link);
  EXPECT_LT(difference(settled(), before, kPlanet), 0.1);
}

TEST_F(ExchangeTest, AFileThatIsDraggedInIsLoaded) {
  const fs::path file = home / "dragged here.json";
  std::ofstream(file) << R"({"preset":"moon","camera":{"longitude":90},"time":{"speed":0}})";
  ASSERT_TRUE(drop_file(*screen, "Terrella", home / "dragged%20here.json"));
  EXPECT_TRUE(until([this] { return copied_link() == "preset=moon&camera.longitude=90&time.speed=0"; }));
}

TEST_F(ExchangeTest, FieldsPasteAndCopyToo) {
  const Picture before = settled();
  hands->tap({"slash"});  // the search
  ASSERT_TRUE(until([&] { return !(screen->picture() == before); }));
  settled();
  ASSERT_TRUE(paste("seed"));
  hands->tap({"Control_L", "a"});
  hands->tap({"Control_L", "c"});
  ASSERT_TRUE(until([this] { return !clipboard->is_own(); }));
  EXPECT_EQ(clipboard->paste(), "seed");
}

TEST_F(ExchangeTest, PicturesAreNewFilesOfTheSizeAskedFor) {
  save_picture("96", "54");
  ASSERT_TRUE(comes("planet.png"));
  EXPECT_EQ(size_of_png(folder / "planet.png"), "96 x 54");
  const std::string first = text_of_file(folder / "planet.png");
  save_picture("40", "60");
  ASSERT_TRUE(comes("planet-2.png"));
  EXPECT_EQ(size_of_png(folder / "planet-2.png"), "40 x 60");
  EXPECT_EQ(text_of_file(folder / "planet.png"), first);
  EXPECT_EQ(files_in(folder), (std::set<std::string>{"planet.png", "planet-2.png"}));
}

TEST_F(ExchangeTest, ScenesAreNewFilesToo) {
  hands->click(178, 97);
  ASSERT_TRUE(comes("planet.json"));
  const std::string first = text_of_file(folder / "planet.json");
  const auto scene = nlohmann::json::parse(first);
  EXPECT_EQ(scene.at("preset"), "moon");
  EXPECT_EQ(scene.at("quality").at("resolution_scale"), 0.25);
  ASSERT_TRUE(paste(R"({"preset":"moon","camera":{"longitude":90},"time":{"speed":0}})"));
  ASSERT_TRUE(until([this] { return copied_link() == "preset=moon&camera.longitude=90&time.speed=0"; }));
  hands->click(178, 97);
  ASSERT_TRUE(comes("planet-2.json"));
  EXPECT_EQ(nlohmann::json::parse(text_of_file(folder / "planet-2.json")).at("camera").at("longitude"), 90);
  EXPECT_EQ(text_of_file(folder / "planet.json"), first);
}

}  // namespace
}  // namespace terrella::test
