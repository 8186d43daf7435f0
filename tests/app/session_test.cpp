// A session on a real context, with hands on its planet and its keys.
#include "app/session.hpp"

#include <gtest/gtest.h>
#include <imgui.h>

#include <chrono>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

#include "effort.hpp"
#include "native/egl_context.hpp"
#include "scene/parameters.hpp"
#include "scene/presets.hpp"
#include "scene/quality_path.hpp"

namespace terrella {
namespace {

constexpr int width = 96, height = 54;  // pixels

void rest() { std::this_thread::sleep_for(std::chrono::duration<double>(History::rest + 0.1)); }

class SessionTest : public testing::Test {
 protected:
  SessionTest() : context_(std::move(*EglContext::make(Api::core))), session(host()) {
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    session.context_made();
    session.resize(width, height, 1.0);
    session.set_paused(true);
    session.show_panel(false);
  }

  void frames(int count) {
    for (int i = 0; i < count; ++i) session.frame(now_ += 0.016, framebuffer_);
  }

  // Until nothing moves any more.
  void settle() {
    for (int i = 0; i < 2000; ++i) {
      if (!session.frame(now_ += 0.016, framebuffer_).again) return;
    }
    ADD_FAILURE() << "never comes to rest";
  }

  // As a machine draws them whose first step takes so long, s.
  void frames_by_cost(int count, double first_step) {
    for (int i = 0; i < count; ++i) {
      const auto step = nlohmann::json::parse(session.stats()).at("quality").at("step").get<std::size_t>();
      session.frame(now_ += first_step * quality_path()[step].cost, framebuffer_);
    }
  }

  // Until the ground is as fine as is asked, although the clock runs.
  void settle_refinement() { frames(400); }

  void tap(Key key, Modifiers modifiers = {}) {
    session.key(key, true, modifiers);
    session.key(key, false, {});
  }

  void drag() {
    session.pointer_moved(40.0, 25.0);
    session.pointer_button(Button::left, true);
    for (int i = 1; i < 5; ++i) session.pointer_moved(40.0 + 3.0 * i, 25.0);
    frames(20);  // held still, so that it is no throw
    session.pointer_button(Button::left, false);
  }

  std::vector<unsigned char> pixels() {
    settle();
    std::vector<unsigned char> bytes(std::size_t{4} * width * height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return bytes;
  }

  double longitude() const { return session.document().scene.camera.longitude; }

 private:
  Session::Host host() {
    Session::Host host;
    host.scene_changed = [this] { ++changes; };
    host.copy_typed = [this](const std::string& text) { copied = text; };
    host.fill_screen = [this] { ++screens; };
    host.keep_habits = [this](const std::string& habits) { kept.push_back(habits); };
    return host;
  }

  std::unique_ptr<EglContext> context_;

 protected:
  GLuint texture_ = 0, framebuffer_ = 0;
  double now_ = 1.0;
  int changes = 0, screens = 0;   // told to the host
  std::vector<std::string> kept;  // by the host
  std::string copied;             // from a field
  Session session;
};

constexpr Modifiers control{false, true}, control_shift{true, true};

// A planet that takes this machine long, with its clock running.
class SlowSessionTest : public SessionTest {
 protected:
  static constexpr int large_width = 1000, large_height = 640;

  void SetUp() override {
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, large_width, large_height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    session.resize(large_width, large_height, 1.0);
    session.load_link("preset=storm");
    settle();
    session.set_paused(false);
    for (int i = 0; i < 20 && bands() == 1; ++i) session.frame(now_ += 0.2, framebuffer_);
    if (bands() == 1) GTEST_SKIP() << "this machine is too quick";
  }

  int bands() const { return nlohmann::json::parse(session.stats())["bands"]; }
  int shown() const { return nlohmann::json::parse(session.stats())["frames"]; }

  Session::Turn frame() { return session.frame(now_ += 0.02, framebuffer_); }

  std::vector<unsigned char> screen() const {
    std::vector<unsigned char> bytes(std::size_t{4} * large_width * large_height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glReadPixels(0, 0, large_width, large_height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return bytes;
  }

  // To where a picture is under way.
  void go_half_way() {
    while (!frame().drawn) {
    }
    frame();
    EXPECT_FALSE(frame().drawn);
  }
};

TEST_F(SlowSessionTest, TheClocksPictureIsOnScreenWhenAllOfItsBandsAre) {
  go_half_way();
  for (int picture = 0; picture < 3; ++picture) {
    const int before = shown();
    const std::vector<unsigned char> old = screen();
    int frames = 0;
    Session::Turn turn = frame();
    for (; !turn.drawn && frames < 10000; ++frames) {
      EXPECT_TRUE(turn.again);
      EXPECT_EQ(shown(), before);
      EXPECT_EQ(screen(), old);
      turn = frame();
    }
    EXPECT_GE(frames, 1);
    EXPECT_EQ(shown(), before + 1);
    EXPECT_NE(screen(), old);
  }
}

TEST_F(SlowSessionTest, WhatAHandChangesIsOnScreenInTheNextFrame) {
  go_half_way();
  const std::vector<unsigned char> before = screen();
  session.set("planet.seed", "77");
  EXPECT_TRUE(frame().drawn);
  EXPECT_NE(screen(), before);
}

TEST_F(SlowSessionTest, APanelThatChangesCompletesThePicture) {
  go_half_way();
  const int before = shown();
  session.show_panel(false);
  EXPECT_TRUE(frame().drawn);
  EXPECT_EQ(shown(), before + 1);
}

TEST_F(SlowSessionTest, AStoppedClockLeavesThePictureOfItsMoment) {
  go_half_way();
  session.set_paused(true);
  int frames = 0;
  Session::Turn turn = frame();
  for (; turn.again && frames < 1000; ++frames) turn = frame();
  EXPECT_FALSE(turn.again);
  const std::vector<unsigned char> stopped = screen();
  session.resize(large_width, large_height, 1.0);  // draws anew
  settle();
  EXPECT_EQ(screen(), stopped);
}

TEST_F(SlowSessionTest, APictureInBetweenDoesNotDisturbTheScreen) {
  go_half_way();
  const Image one = session.picture(64, 36);
  EXPECT_TRUE(frame().drawn);
  session.render_at(5.0, framebuffer_);
  const std::vector<unsigned char> five = screen();
  go_half_way();
  session.render_at(5.0, framebuffer_);
  EXPECT_EQ(screen(), five);
}

TEST_F(SessionTest, AMapIsMadeWhileThePanelShowsItAndThenFramesComeToRest) {
  const auto textures = [&] { return nlohmann::json::parse(session.stats()).at("textures").get<int>(); };
  session.resize(640, 520, 1.0);  // wide and high enough for a panel with a map
  session.show_panel(true);
  settle();
  const int without = textures();
  session.take_habits("camera");
  settle();
  EXPECT_EQ(textures(), without + 1);
  session.set("planet.seed", "77");
  settle();
  EXPECT_EQ(textures(), without + 1);
}

TEST_F(SessionTest, ArrowsAreThePlanetsUntilTabLeadsIntoThePanel) {
  session.show_panel(true);
  settle();
  const auto turns = [&] {
    const SceneDocument before = session.document();
    session.key(Key::right, true, {});
    frames(5);
    session.key(Key::right, false, {});
    settle();
    return !(session.document() == before);
  };
  EXPECT_TRUE(turns());
  EXPECT_TRUE(session.key(Key::tab, true, {}));
  session.key(Key::tab, false, {});
  settle();
  EXPECT_FALSE(turns());
  tap(Key::escape);
  settle();
  EXPECT_TRUE(turns());
  EXPECT_FALSE(session.key(Key::tab, true, {}));  // it leads on, out of the planet
  session.keys_left();
  EXPECT_TRUE(session.key(Key::tab, true, {}));  // as it comes back
  session.show_panel(false);
  settle();
  EXPECT_FALSE(session.key(Key::tab, true, {}));
}

TEST_F(SessionTest, FillsTheScreenOnceAPressAndLeavesTheCameraAlone) {
  session.set("camera.pitch", "-45");
  settle();
  const SceneDocument before = session.document();
  for (int i = 0; i < 3; ++i) session.key(Key::f, true, {true, false});  // held down, it repeats
  frames(3);
  session.key(Key::f, false, {});
  settle();
  EXPECT_EQ(screens, 1);
  EXPECT_EQ(session.document(), before);
  session.key(Key::f, true, {});
  frames(3);
  session.key(Key::f, false, {});
  EXPECT_EQ(screens, 1);
  EXPECT_NE(session.document(), before);  // without Shift it looks down
}

TEST_F(SessionTest, ADragOfThePlanetIsUndoneAndRedoneByKeys) {
  settle();
  const double start = longitude();
  drag();
  settle();
  const double dragged = longitude();
  ASSERT_NE(dragged, start);
  const int told = changes;
  tap(Key::z, control);
  EXPECT_EQ(longitude(), start);
  EXPECT_EQ(changes, told + 1);
  tap(Key::z, control);  // nothing more to undo
  EXPECT_EQ(changes, told + 1);
  tap(Key::z, control_shift);
  EXPECT_EQ(longitude(), dragged);
  tap(Key::z, control);
  tap(Key::y, control);
  EXPECT_EQ(longitude(), dragged);
}

// The clock of frames stands while nothing is drawn.
TEST_F(SessionTest, AHandThatHasHeldStillUntilNothingIsDrawnThrowsNothing) {
  settle();
  session.pointer_moved(40.0, 25.0);
  session.pointer_button(Button::left, true);
  for (int i = 1; i < 5; ++i) session.pointer_moved(40.0 + 3.0 * i, 25.0);
  settle();
  const double held = longitude();
  session.pointer_button(Button::left, false);
  frames(20);
  EXPECT_EQ(longitude(), held);
}

TEST_F(SessionTest, APlanetThatStillRunsOnIsUndoneWithItsThrow) {
  settle();
  const double start = longitude();
  session.pointer_moved(40.0, 25.0);
  session.pointer_button(Button::left, true);
  for (int i = 1; i < 5; ++i) {
    session.pointer_moved(40.0 + 3.0 * i, 25.0);
    frames(1);
  }
  session.pointer_button(Button::left, false);
  frames(3);
  const double thrown = longitude();
  session.key(Key::unknown, true, control);  // the Ctrl key comes first
  frames(3);
  ASSERT_NE(longitude(), thrown);
  tap(Key::z, control);
  EXPECT_EQ(longitude(), start);
  settle();
  EXPECT_EQ(longitude(), start);
}

TEST_F(SessionTest, AHeldKeyIsOneStep) {
  settle();
  const double start = longitude();
  session.key(Key::d, true, {});
  frames(30);
  session.key(Key::d, false, {});
  settle();
  ASSERT_NE(longitude(), start);
  tap(Key::z, control);
  EXPECT_EQ(longitude(), start);
}

TEST_F(SessionTest, ARunOfNotchesIsOneStepAndTheNextRunAnother) {
  settle();
  const double start = session.document().scene.camera.altitude;
  for (int i = 0; i < 3; ++i) {
    session.wheel(1.0);
    frames(3);
  }
  settle();
  const double nearer = session.document().scene.camera.altitude;
  rest();
  session.wheel(1.0);
  settle();
  tap(Key::z, control);
  EXPECT_EQ(session.document().scene.camera.altitude, nearer);
  tap(Key::z, control);
  EXPECT_EQ(session.document().scene.camera.altitude, start);
}

TEST_F(SessionTest, DigitsChangeHowHandsMoveTheCamera) {
  settle();
  const auto before = session.document().scene.camera;
  tap(Key::two);
  EXPECT_EQ(session.camera_mode(), CameraMode::fly);
  settle();
  EXPECT_TRUE(session.document().scene.camera == before);
  session.key(Key::t, true, {});
  frames(30);
  session.key(Key::t, false, {});
  settle();
  EXPECT_GT(session.document().scene.camera.altitude, before.altitude);
  session.key(Key::e, true, {});
  frames(10);
  session.key(Key::e, false, {});
  EXPECT_GT(session.document().scene.camera.roll, 1.0);
  tap(Key::one);
  EXPECT_EQ(session.camera_mode(), CameraMode::orbit);
  session.key(Key::t, true, {});  // is nothing here: no frame is drawn for it
  settle();
  session.key(Key::t, false, {});
}

TEST_F(SessionTest, AFallComesToRestAndIsUndoneIntoOrbit) {
  settle();
  const auto before = session.document().scene.camera;
  tap(Key::three);
  settle();
  const double standing = session.document().scene.camera.altitude;
  EXPECT_LT(standing, 0.3);
  EXPECT_FALSE(session.frame(now_ += 1.0, framebuffer_).again);
  tap(Key::z, control);
  EXPECT_EQ(session.camera_mode(), CameraMode::orbit);
  settle();
  EXPECT_TRUE(session.document().scene.camera == before);
  tap(Key::y, control);
  settle();
  EXPECT_EQ(session.document().scene.camera.altitude, standing);
}

TEST_F(SessionTest, SpaceJumpsOnFoot) {
  session.load_link("preset=moon");
  tap(Key::three);
  settle();
  const double standing = session.document().scene.camera.altitude;
  tap(Key::space);
  frames(5);
  EXPECT_GT(session.document().scene.camera.altitude, standing);
  settle();
  EXPECT_NEAR(session.document().scene.camera.altitude, standing, 1e-9);
}

TEST_F(SessionTest, ASceneThatIsOpenedIsShownAsItIsAlsoToAWalker) {
  settle();
  tap(Key::three);
  settle();
  session.load_link("preset=moon");
  settle();
  EXPECT_EQ(session.camera_mode(), CameraMode::orbit);
  EXPECT_TRUE(session.document().scene.camera == find_preset("moon")->scene.camera);
}

TEST_F(SessionTest, APressInFlightDoesNotBrakeIt) {
  settle();
  tap(Key::two);
  session.key(Key::s, true, {});
  frames(60);
  const auto moved = [&] {
    const double before = session.document().scene.camera.altitude;
    frames(5);
    return session.document().scene.camera.altitude / before;
  };
  const double usual = moved();
  session.pointer_button(Button::left, true);
  EXPECT_NEAR(moved(), usual, 0.02 * (usual - 1.0));
  session.pointer_button(Button::left, false);
  session.key(Key::s, false, {});
}

TEST_F(SessionTest, NothingIsUndoneUnderAHandThatHolds) {
  settle();
  session.pointer_moved(40.0, 25.0);
  session.pointer_button(Button::left, true);
  session.pointer_moved(50.0, 25.0);
  const double held = longitude();
  tap(Key::z, control);
  EXPECT_EQ(longitude(), held);
}

TEST_F(SessionTest, WhatIsLoadedBeforeTheFirstPictureIsTheBeginning) {
  session.load_link("preset=storm");
  settle();
  tap(Key::z, control);
  EXPECT_EQ(session.document().preset, "storm");
  session.load_json(R"({"terrella": 1, "preset": "moon"})");
  EXPECT_EQ(session.set("sun.intensity", "2"), "");
  tap(Key::z, control);
  EXPECT_EQ(session.document(), (SceneDocument{find_preset("moon")->scene, "moon"}));
  tap(Key::z, control);
  EXPECT_EQ(session.document().preset, "storm");
}

TEST_F(SessionTest, ASlashSearchesAndThenTheKeysBelongToTheField) {
  session.load_link("quality.resolution_scale=0.25");
  session.resize(640, 400, 1.0);
  settle();
  drag();
  settle();
  const double dragged = longitude();
  session.text('/');  // the panel is hidden, and comes
  settle();
  EXPECT_TRUE(ImGui::GetIO().WantTextInput);
  tap(Key::z, control);
  session.key(Key::d, true, {});
  frames(5);
  session.key(Key::d, false, {});
  EXPECT_EQ(longitude(), dragged);
  tap(Key::escape);
  settle();
  EXPECT_FALSE(ImGui::GetIO().WantTextInput);
  tap(Key::z, control);
  EXPECT_NE(longitude(), dragged);
}

// What the field with the keyboard holds, by way of the clipboard.
TEST_F(SessionTest, FieldsShareTheClipboardWithEverybody) {
  session.load_link("quality.resolution_scale=0.25");
  session.resize(640, 400, 1.0);
  settle();
  session.text('/');
  settle();
  const auto copy_all = [this] {
    tap(Key::a, control);
    settle();
    tap(Key::c, control);
    settle();
    return std::exchange(copied, {});
  };
  session.text('s');
  settle();
  EXPECT_EQ(copy_all(), "s");
  session.key(Key::unknown, true, control);  // Ctrl itself stays down
  session.key(Key::v, true, control);
  session.pasted("gr\u00fcn\n{}");
  settle();
  session.key(Key::v, false, control);
  session.key(Key::unknown, false, {});
  settle();
  EXPECT_EQ(copy_all(), "gr\u00fcn{}");
  session.pasted("once");  // by a menu: no key at all
  settle();
  EXPECT_EQ(copy_all(), "once");
  session.text('x');  // Ctrl does not hang
  settle();
  EXPECT_EQ(copy_all(), "x");
}

// Where frames take long, a word is typed between two of them.
TEST_F(SessionTest, WhatIsTypedWithinAFrameArrivesWhole) {
  session.load_link("quality.resolution_scale=0.25");
  session.resize(640, 400, 1.0);
  settle();
  session.text('/');
  settle();
  for (int i = 0; i < 12; ++i) {
    session.key(Key::z, true, {});
    session.text('z');
    session.key(Key::z, false, {});
  }
  settle();
  tap(Key::a, control);
  settle();
  tap(Key::c, control);
  settle();
  EXPECT_EQ(copied, "zzzzzzzzzzzz");
}

TEST_F(SessionTest, WhileCIsHeldThePlanetIsAsItWasOpened) {
  session.load_link("preset=moon");
  const auto opened = pixels();
  EXPECT_EQ(session.set("terrain.land_color", "ff0000"), "");
  EXPECT_EQ(session.set("terrain.mountain_color", "ff0000"), "");
  const SceneDocument document = session.document();
  const auto changed = pixels();
  ASSERT_NE(changed, opened);
  const int told = changes;
  session.key(Key::c, true, {});
  EXPECT_EQ(pixels(), opened);
  EXPECT_EQ(session.document(), document);
  session.key(Key::c, false, {});
  EXPECT_EQ(pixels(), changed);
  EXPECT_EQ(changes, told);
}

TEST_F(SessionTest, ComparingEndsWhenTheKeyboardGoesElsewhere) {
  session.load_link("preset=moon");
  EXPECT_EQ(session.set("terrain.land_color", "ff0000"), "");
  EXPECT_EQ(session.set("terrain.mountain_color", "ff0000"), "");
  const auto changed = pixels();
  session.key(Key::c, true, {});
  EXPECT_NE(pixels(), changed);
  session.keys_left();
  EXPECT_EQ(pixels(), changed);
}

TEST_F(SessionTest, APlanetByChanceIsOneStep) {
  settle();
  const SceneDocument start = session.document();
  session.key(Key::n, true, {});
  const SceneDocument first = session.document();
  EXPECT_NE(first, start);
  session.key(Key::n, true, {});  // it repeats while it is held
  EXPECT_EQ(session.document(), first);
  session.key(Key::n, false, {});
  tap(Key::n);
  EXPECT_NE(session.document(), first);
  tap(Key::z, control);
  EXPECT_EQ(session.document(), first);
  tap(Key::z, control);
  EXPECT_EQ(session.document(), start);
}

TEST_F(SessionTest, HabitsAreKeptWhenTheyChangeAndNotBefore) {
  session.load_link("quality.resolution_scale=0.25");
  session.resize(640, 400, 1.0);
  session.take_habits("folded waves");
  session.show_panel(true);
  settle();
  EXPECT_EQ(kept, std::vector<std::string>{});
  session.text('/');  // unfolds
  settle();
  EXPECT_EQ(kept, std::vector<std::string>{"waves"});
}

TEST_F(SessionTest, DrawsThePicturesOfPresetsOnceTheirListIsOpened) {
  const auto textures = [&] { return nlohmann::json::parse(session.stats())["textures"].get<std::size_t>(); };
  session.resize(1280, 720, 1.0);
  session.show_panel(true);
  settle();
  const std::size_t before = textures();
  for (int i = 0; i < 4; ++i) {  // to the list of keys, full screen, fold, presets
    tap(Key::tab);
    settle();
  }
  EXPECT_EQ(textures(), before);
  tap(Key::enter);
  settle();
  EXPECT_EQ(textures(), before + presets().size());
}

TEST_F(SessionTest, ComparingKeepsTheCamera) {
  settle();
  const auto opened = pixels();
  drag();
  const auto dragged = pixels();
  ASSERT_NE(dragged, opened);
  session.key(Key::c, true, {});
  EXPECT_EQ(pixels(), dragged);
}

TEST_F(SessionTest, TellsWhatLiesBeyondTheRangeOfItsTechniqueUntilItNoLongerDoes) {
  const auto issues = [&] { return nlohmann::json::parse(session.stats())["issues"]; };
  settle();
  EXPECT_TRUE(issues().empty());
  EXPECT_EQ(session.set("terrain.height", "7"), "");
  EXPECT_EQ(session.set("camera.altitude", "20"), "");
  settle();
  ASSERT_EQ(issues().size(), 1U);
  EXPECT_EQ(issues()[0].get<std::string>().rfind("terrain.height: 7 m is more than", 0), 0U);
  EXPECT_EQ(session.set("terrain.height", "0.1"), "");
  settle();
  EXPECT_TRUE(issues().empty());
}

// Where each picture takes a second, a few milliseconds of making for each would leave the ground coarse for minutes.
TEST_F(SessionTest, MakesMoreOfTheGroundForEachPictureWherePicturesAreSlow) {
  const auto pictures_until_settled = [&](const char* link, double apart) {
    session.load_link(link);
    int pictures = 0;
    while (pictures < 2000 && session.frame(now_ += apart, framebuffer_).again) ++pictures;
    return pictures;
  };
  session.load_link("preset=blue");  // and its programs
  settle();
  const int quick =
      pictures_until_settled("preset=blue&clouds.model=none&camera.altitude=1020&camera.latitude=10", 0.016);
  const int slow =
      pictures_until_settled("preset=blue&clouds.model=none&camera.altitude=1020&camera.latitude=-10", 2.0);
  if (test::prints()) std::printf("%d and %d\n", quick, slow);
  EXPECT_LT(2 * slow, quick);  // measured: 16 and 48
}

TEST_F(SessionTest, GivesUpQualityForItsTargetAndTakesItBackAtRest) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  session.set("camera.altitude", "1.5");
  session.set("quality.target_ms", "16");
  session.set_paused(false);
  settle_refinement();
  const auto quality = [&] { return nlohmann::json::parse(session.stats()).value("quality", nlohmann::json()); };
  const double before = quality().at("psnr");
  frames_by_cost(12, 0.07);
  EXPECT_EQ(quality().at("step"), 0);
  EXPECT_LT(quality().at("psnr"), before);
  session.set_paused(true);
  settle();
  EXPECT_EQ(quality().at("step"), static_cast<int>(quality_path().size()) - 1);
  const auto frames = nlohmann::json::parse(session.stats()).at("frames");
  settle();
  EXPECT_EQ(nlohmann::json::parse(session.stats()).at("frames"), frames);  // at rest it draws no more
  session.set("camera.altitude", "1.6");
  this->frames(1);
  EXPECT_EQ(quality().at("step"), 0);
  session.set("quality.target_ms", "0");
  settle();
  EXPECT_TRUE(quality().is_null());
}

TEST_F(SessionTest, GivesUpNoQualityForTheTimeThatPassesUntilThereIsAPlanet) {
  session.set("quality.target_ms", "16");
  session.set_paused(false);
  const auto step = [&] { return nlohmann::json::parse(session.stats()).at("quality").at("step").get<int>(); };
  const int before = step();
  frames(1);
  now_ += 3.0;  // as a compiler takes them
  while (nlohmann::json::parse(session.stats()).at("frames") == 1) frames(1);
  for (int i = 0; i < 3; ++i) {
    now_ += 0.1;
    frames(1);
  }
  EXPECT_EQ(step(), before);
}

TEST_F(SessionTest, APictureThatIsKeptIsDrawnAtItsFinest) {
  session.set_paused(true);
  const Scene finest = with_quality(session.document().scene, quality_path().back());
  settle();
  for (const Parameter& parameter : parameters()) {
    if (parameter.group == "quality") session.set(std::string(parameter.path), to_text(parameter.get(finest)));
  }
  const Image as_set = session.picture(64, 36);
  for (const Parameter& parameter : parameters()) {
    if (parameter.group == "quality") session.set(std::string(parameter.path), to_text(parameter.default_value));
  }
  EXPECT_NE(session.picture(64, 36).pixels, as_set.pixels);
  session.set("quality.target_ms", "5");
  EXPECT_EQ(session.picture(64, 36).pixels, as_set.pixels);
}

// Hands move in the pixels that are shown, however many are drawn.
TEST_F(SessionTest, TheWheelLeadsToTheSamePlaceWhateverTheQuality) {
  const auto zoomed = [&](const char* target) {
    session.load_link("preset=moon");
    session.set("quality.target_ms", target);
    settle();
    session.pointer_moved(60.0, 20.0);
    session.wheel(3.0);
    settle();
    return session.document().scene.camera;
  };
  const auto plain = zoomed("0"), held = zoomed("16");
  EXPECT_LT(plain.altitude, SceneDocument{}.scene.camera.altitude);
  EXPECT_NEAR(held.altitude, plain.altitude, 1e-6 * plain.altitude);
  EXPECT_NEAR(held.latitude, plain.latitude, 1e-6);
  EXPECT_NEAR(held.longitude, plain.longitude, 1e-6);
}

// From so far, coarse pixels show no ripples, so that nothing moves; the finest would show them, and move.
TEST_F(SessionTest, DoesNotGoToAndFroBetweenAQualityThatMovesAndOneThatRests) {
  session.load_link("clouds.model=none&camera.altitude=9&quality.target_ms=16");
  session.set_paused(false);
  for (int i = 0; i < 200; ++i) {
    frames(1);
    const auto quality = nlohmann::json::parse(session.stats()).at("quality");
    ASSERT_LT(quality.at("step").get<std::size_t>() + 1, quality.at("steps").get<std::size_t>()) << i;
  }
}

TEST_F(SessionTest, GoesOnInAnotherWhereHandsLeftIt) {
  session.load_link("preset=storm");
  settle();
  session.set("water.level", "0.3");
  rest();
  session.set("waves.count", "3");
  session.undo();
  session.set_seconds(4.5);
  session.add_notices({"A sentence."});
  const std::string all = session.hand_over();
  const SceneDocument document = session.document();
  session.load_link("preset=moon");
  session.set_seconds(1.0);
  const int before = changes;
  session.take_over(all);
  EXPECT_EQ(changes, before);
  EXPECT_EQ(session.document(), document);
  EXPECT_NE(session.stats().find("A sentence."), std::string::npos);
  session.redo();
  EXPECT_EQ(session.document().scene.waves.count, 3);
  session.undo();
  session.undo();
  EXPECT_EQ(session.document().scene, find_preset("storm")->scene);
  EXPECT_NE(session.hand_over().find("seconds 4.5\n"), std::string::npos);
}

TEST_F(SessionTest, RestsOnceNoHandHoldsAnything) {
  settle();
  EXPECT_TRUE(session.hands_rest());
  session.pointer_moved(40.0, 25.0);
  session.pointer_button(Button::left, true);
  EXPECT_FALSE(session.hands_rest());
  session.pointer_button(Button::left, false);
  EXPECT_TRUE(session.hands_rest());
  session.key(Key::left, true, {});
  EXPECT_FALSE(session.hands_rest());
  session.key(Key::left, false, {});
  settle();
  EXPECT_TRUE(session.hands_rest());
  session.wheel(2.0);
  EXPECT_FALSE(session.hands_rest());
  settle();
  EXPECT_TRUE(session.hands_rest());
}

}  // namespace
}  // namespace terrella
