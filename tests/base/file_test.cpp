#include "base/file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace terrella {
namespace {

namespace fs = std::filesystem;

// An empty folder for each test.
class FileTest : public testing::Test {
 protected:
  FileTest() {
    folder_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~FileTest() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  auto files() const { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()); }

  fs::path folder_;
};

TEST_F(FileTest, ReadsWhatWasWritten) {
  const std::string bytes("a\0b\n\xff", 5);
  ASSERT_TRUE(write_file_whole(path("a"), bytes));
  EXPECT_EQ(*read_file(path("a"), 5), bytes);
  EXPECT_EQ(files(), 1) << "a temporary file was left";
}

TEST_F(FileTest, ReadsNoMoreThanAllowed) {
  ASSERT_TRUE(write_file_whole(path("a"), std::string(100'000, 'x')));
  EXPECT_TRUE(read_file(path("a"), 100'000));
  const auto refused = read_file(path("a"), 99'999);
  EXPECT_FALSE(refused);
  EXPECT_NE(refused.sentence().find("longer than the 99999 bytes"), std::string::npos) << refused.sentence();
  EXPECT_FALSE(read_file("/dev/zero", 1'000'000)) << "has no end";
}

TEST_F(FileTest, SaysWhatCannotBeRead) {
  EXPECT_NE(read_file(path("none"), 10).sentence().find("No such file"), std::string::npos);
  EXPECT_NE(read_file(folder_.string(), 10).sentence().find("directory"), std::string::npos);
}

TEST_F(FileTest, ReplacesTheWholeFile) {
  ASSERT_TRUE(write_file_whole(path("a"), "a long first version"));
  ASSERT_TRUE(write_file_whole(path("a"), "short"));
  EXPECT_EQ(*read_file(path("a"), 100), "short");
}

TEST_F(FileTest, LeavesNothingWhereWritingFails) {
  fs::create_directories(folder_ / "taken" / "inside");
  const auto failed = write_file_whole(path("taken"), "bytes");
  EXPECT_FALSE(failed);
  EXPECT_NE(failed.sentence().find("cannot be written"), std::string::npos) << failed.sentence();
  EXPECT_EQ(files(), 1);
  EXPECT_FALSE(write_file_whole(path("no/such/folder"), "bytes"));
}

TEST_F(FileTest, WritesThroughALink) {
  ASSERT_TRUE(write_file_whole(path("target"), "old"));
  fs::create_symlink("target", path("link"));
  ASSERT_TRUE(write_file_whole(path("link"), "new"));
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(*read_file(path("target"), 10), "new");
}

TEST_F(FileTest, WritesToDevicesWithoutReplacingThem) {
  EXPECT_TRUE(write_file_whole("/dev/null", "bytes"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const auto full = write_file_whole("/dev/full", "bytes");
  EXPECT_NE(full.sentence().find("No space left"), std::string::npos) << full.sentence();
}

}  // namespace
}  // namespace terrella
