#include "native/kept_habits.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace terrella {
namespace {

TEST(KeptHabits, LieWhereTheSystemKeepsStates) {
  EXPECT_EQ(habits_path("/state", "/home/a"), "/state/terrella/panel");
  EXPECT_EQ(habits_path("", "/home/a"), "/home/a/.local/state/terrella/panel");
  EXPECT_EQ(habits_path("not/absolute", "/home/a"), "/home/a/.local/state/terrella/panel");
  EXPECT_EQ(habits_path("", ""), "");
}

TEST(KeptHabits, ComeBackAndMakeTheirFolder) {
  const std::string folder = testing::TempDir() + "terrella_kept_habits";
  std::filesystem::remove_all(folder);
  const std::string path = habits_path(folder, "");
  EXPECT_EQ(kept_habits(path), "tour\n");
  EXPECT_EQ(kept_habits(path), "tour\n");  // until it is over
  keep_habits(path, "terrain waves");
  EXPECT_EQ(kept_habits(path), "terrain waves\n");
  keep_habits(path, "");
  EXPECT_EQ(kept_habits(path), "\n");
  std::filesystem::remove_all(folder);
}

TEST(KeptHabits, AreForgottenWithoutAComplaintWhereTheyCannotBeKept) {
  keep_habits("", "waves");
  EXPECT_EQ(kept_habits(""), "");
  const std::string file = testing::TempDir() + "terrella_no_folder";
  std::ofstream(file) << "a file, where a folder should be";
  keep_habits(file + "/terrella/panel", "waves");
  EXPECT_EQ(kept_habits(file + "/terrella/panel"), "");
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace terrella
