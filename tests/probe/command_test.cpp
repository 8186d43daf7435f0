// `terrella probe` as a program: its pipes and exit codes.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

namespace terrella {
namespace {

struct Ran {
  int code;
  std::string out;
};

// Runs a line of the shell in which PROGRAM stands for the program.
Ran run(std::string line) {
  line.replace(line.find("PROGRAM"), 7, TERRELLA_PROGRAM);
  std::FILE* pipe = popen(line.c_str(), "r");
  Ran ran{-1, {}};
  char piece[4096];
  while (const std::size_t got = std::fread(piece, 1, sizeof piece, pipe)) ran.out.append(piece, got);
  const int status = pclose(pipe);
  ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ran;
}

TEST(ProbeCommand, ListsItsFunctions) {
  const Ran ran = run("PROGRAM probe --list");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.out.rfind("grid_offset\ngrid_point\n", 0), 0U);
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 59);
}

TEST(ProbeCommand, EndsWell) {
  EXPECT_EQ(run("PROGRAM probe </dev/null").code, 0);
  EXPECT_EQ(run("PROGRAM probe </dev/null").out, "");
  // The last line needs no end.
  const Ran ran = run(R"(printf '{"id":1}\n{"id":2}' | PROGRAM probe)");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 2);
}

TEST(ProbeCommand, AnswersBeforeTheNextIsAsked) {
  const std::string answers = testing::TempDir() + "terrella_probe_answers.txt";
  std::FILE* pipe = popen((std::string(TERRELLA_PROGRAM) + " probe > " + answers).c_str(), "w");
  for (int asked = 1; asked <= 2; ++asked) {
    std::fputs("{\"fn\": \"wrap_diffuse\", \"args\": {\"cos\": 1, \"w\": 0}}\n", pipe);
    std::fflush(pipe);
    std::string text;
    for (int patience = 0; patience < 1000 && std::count(text.begin(), text.end(), '\n') < asked; ++patience) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      std::ostringstream read;
      read << std::ifstream(answers).rdbuf();
      text = read.str();
    }
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), asked);
  }
  EXPECT_EQ(pclose(pipe), 0);
}

TEST(ProbeCommand, TriesItselfAndPrintsATable) {
  const Ran ran = run("PROGRAM probe --fuzz 20 --markdown");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 61);
}

TEST(ProbeCommand, BadOptionsAreTheUsersMistake) {
  EXPECT_EQ(run("PROGRAM probe --markdown 2>&1").code, 2);
  EXPECT_EQ(run("PROGRAM probe --fuzz 0 2>&1").out, "--fuzz: must be a whole number, 1 to 10000000.\n");
  EXPECT_EQ(run("PROGRAM probe --fuzz x 2>&1").code, 2);
  EXPECT_EQ(run("PROGRAM probe --gl vulkan 2>&1").code, 2);
}

}  // namespace
}  // namespace terrella
