#include "window/window_fixture.hpp"

#include <unistd.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

#include "base/text.hpp"
#include "window/patience.hpp"

namespace terrella::test {
namespace {

constexpr const char* title = "Terrella";
// Of AddressSanitizer. What the driver leaks cannot be told from what the program does: GLFW has unloaded it by then.
// The tests of the session look for leaks of ours.
constexpr const char* no_search_for_leaks = "ASAN_OPTIONS=detect_leaks=0";
constexpr double another = 4.0, the_same = 1.0;  // of 255
constexpr int looks_at_rest = 4;
constexpr std::chrono::milliseconds between_looks{100}, least_work{2};

std::filesystem::path new_folder(const std::string& name) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / text_of("terrella_", name, '_', getpid());
  std::filesystem::remove_all(path);
  std::filesystem::create_directories(path);
  return path;
}

}  // namespace

WindowTest::WindowTest() : home(new_folder("home")), folder(new_folder("folder")) {}

WindowTest::~WindowTest() {
  program.reset();
  clipboard.reset();
  screen.reset();
  std::filesystem::remove_all(home);
  std::filesystem::remove_all(folder);
}

void WindowTest::SetUp() {
  auto opened = Screen::open();
  ASSERT_TRUE(opened) << opened.sentence();
  screen = std::move(*opened);
  hands.emplace(screen->connection());
  clipboard.emplace(screen->connection());
}

void WindowTest::TearDown() {
  if (!program) return;
  EXPECT_EQ(close_window(), 0);
}

void WindowTest::open_window() {
  hands->point(Screen::width - 1, Screen::height - 1);  // beside the window
  auto started = Child::start({{TERRELLA_PROGRAM, "view", "--preset", "moon", "--set", "quality.resolution_scale=0.25",
                                "--set", "time.speed=0"},
                               {"DISPLAY=" + screen->name(), "WAYLAND_DISPLAY", "HOME=" + home.string(),
                                "XDG_STATE_HOME=" + home.string(), no_search_for_leaks},
                               folder.string()});
  ASSERT_TRUE(started) << started.sentence();
  program.emplace(std::move(*started));
  see_window();
}

void WindowTest::see_window() {
  const bool shown = until([this] { return program->ended() || screen->place_of_window(title); });
  ASSERT_FALSE(program->ended()) << "The program has ended.";
  ASSERT_TRUE(shown) << "There is no window.";
  const auto all_there = [this] {
    const Picture seen = screen->picture();
    return brightness(seen, kPlanet) > 30.0 && brightness(seen, kTitle) > 30.0;
  };
  ASSERT_TRUE(until(all_there)) << "There is no planet with a panel.";
  settled();
}

std::optional<int> WindowTest::close_window() {
  if (!program->ended()) screen->ask_to_close(title);
  until([this] { return program->ended().has_value(); });
  const std::optional<int> code = program->ended();
  program.reset();
  return code;
}

// A program that refines its picture for long shows nothing of it meanwhile: it rests when it computes nothing, either.
Picture WindowTest::settled() {
  Picture last;
  std::chrono::nanoseconds work{0};
  int looks = 0;
  const bool rests = until([&] {
    std::this_thread::sleep_for(between_looks);
    Picture now = screen->picture();
    const auto more_work = program->work();
    looks = now == last && more_work - work < least_work ? looks + 1 : 0;
    last = std::move(now);
    work = more_work;
    return looks == looks_at_rest;
  });
  EXPECT_TRUE(rests) << "The screen never comes to rest.";
  return last;
}

bool WindowTest::changes(const Picture& before, const Box& box) {
  return until([&] { return difference(screen->picture(), before, box) > another; });
}

bool WindowTest::becomes(const Picture& before, const Box& box) {
  return until([&] { return difference(screen->picture(), before, box) < the_same; });
}

std::string WindowTest::copied_link() {
  clipboard->copy("nothing from the program");
  hands->click(69, 74);
  if (!until([this] { return !clipboard->is_own(); })) return "nothing is copied";
  return clipboard->paste().value_or("nothing can be pasted");
}

bool WindowTest::paste(const std::string& text) {
  clipboard->copy(text);
  hands->tap({"Control_L", "v"});
  return until([this] { return clipboard->is_own() && clipboard->times_given() > 0; });
}

std::string WindowTest::kept_habits() const { return text_of_file(home / "terrella" / "panel"); }

void UsersWindowTest::SetUp() {
  WindowTest::SetUp();
  if (HasFatalFailure()) return;
  std::filesystem::create_directories(home / "terrella");
  std::ofstream(home / "terrella" / "panel") << "\n";
  open_window();
}

std::string text_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace terrella::test
