#include "app/session.hpp"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "app/imgui_input.hpp"
#include "app/stats.hpp"
#include "app/still.hpp"
#include "base/text.hpp"
#include "gl/caps.hpp"
#include "planet/needs.hpp"
#include "planet/validity.hpp"
#include "scene/json.hpp"
#include "scene/link.hpp"
#include "scene/parameters.hpp"

namespace terrella {
namespace {

constexpr double double_click_time = 0.3;  // s
// Where nothing but the clock runs, the panel follows it at this pace: every new picture of the panel costs a frame a
// third more on a processor, and nobody reads hundredths of a second.
constexpr double clock_pace = 0.5;  // s
constexpr std::size_t frames_timed = 60;
constexpr double longest_refinement = 1.0;  // s
constexpr std::ptrdiff_t most_notices = 24;
constexpr double share_of_map = 0.05;  // of the time of a frame
// For what the ground lacks, of the time by which frames are slower than where nothing is slow (ms), and at most.
constexpr double share_of_making = 0.25, quick_frame_ms = 40.0, most_making_ms = 250.0;
constexpr double making_ms_at_rest = 10.0;  // where no picture is drawn meanwhile

// camera.fov is that of the shorter side of what is free: in an upright window the planet would be twice as wide as
// that.
double field_of(double width, double height, glm::dvec2 covered = glm::dvec2(0.0)) {
  return std::max(1.0, height / std::max(1.0, std::min(width - covered.x, height - covered.y)));
}

// Notes the time since the last one, ms, if there was one.
void note_interval(std::optional<double>& last, double now, std::vector<double>& intervals) {
  if (last) intervals.push_back(1000.0 * (now - *last));
  last = now;
  if (intervals.size() > frames_timed) intervals.erase(intervals.begin());
}

}  // namespace

double Session::seconds_by_the_clock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Session::Session(Host host) : host_(std::move(host)), imgui_(ImGui::CreateContext()) {
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().LogFilename = nullptr;
  ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  share_clipboard();
  style_panel(static_cast<float>(scale_));
  history_.start({document_, opened_});
}

Session::~Session() {
  painter_.reset();
  ImGui::DestroyContext(imgui_);
}

// By itself, Dear ImGui would have a clipboard of its own, of which nobody else knows.
void Session::share_clipboard() {
  ImGuiIO& io = ImGui::GetIO();
  io.ClipboardUserData = this;
  io.GetClipboardTextFn = [](void* session) { return static_cast<const Session*>(session)->clipboard_.c_str(); };
  io.SetClipboardTextFn = [](void* session, const char* text) {
    Session& self = *static_cast<Session*>(session);
    self.clipboard_ = text;
    if (self.host_.copy_typed) self.host_.copy_typed(self.clipboard_);
  };
}

void Session::context_made() {
  renderer_ = std::make_unique<Renderer>();
  renderer_->prepare(shown(), view(), effort());  // the driver compiles while the rest is on its way
  planet_stale_ = true;
  panel_frames_ = 3;
}

void Session::context_lost() {
  bands_.context_lost();
  painter_.reset();
  preset_pictures_.reset();
  map_.reset();
  renderer_.reset();
}

void Session::resize(int width, int height, double scale, bool fingers) {
  PanelPlace place = first_panel_place(width, height, fingers);
  // What has taken of the height alone is a keyboard on the screen: what is typed into stays where it is.
  if (fingers && width == width_ && wants_text()) place = panel_.place();
  const bool large_rows = fingers || place.below;
  if (scale != scale_ || large_rows != large_rows_) {
    style_panel(static_cast<float>(scale), large_rows);
    if (painter_) painter_->forget_font();
  }
  panel_.put_at(place);
  large_rows_ = large_rows;
  width_ = std::max(1, width);
  height_ = std::max(1, height);
  scale_ = scale;
  ImGui::GetIO().DisplaySize = {static_cast<float>(width_ * scale_), static_cast<float>(height_ * scale_)};
  planet_stale_ = true;
  panel_frames_ = 3;
}

gl::Screen Session::screen(GLuint framebuffer) const {
  return {framebuffer, static_cast<int>(width_ * scale_ + 0.5), static_cast<int>(height_ * scale_ + 0.5)};
}

// Of the pixels that are shown, which is what hands move in.
View Session::shown_view() const {
  const gl::Screen screen = this->screen(0);
  View view;
  view.width = std::max(1, screen.width);
  view.height = std::max(1, screen.height);
  view.seconds = seconds_;
  // Into the middle of what the panel leaves free.
  const Covered hidden = panel_shown_ ? panel_.covered() : Covered();
  const glm::dvec2 covered(hidden.left, hidden.below);
  view.field = field_of(width_, height_, covered / scale_);
  view.shift = glm::dvec2(0.5, -0.5) * covered;
  return view;
}

// More samples a pixel than fit into memory are not drawn; where nobody asked for them, not more than are worth it.
View Session::view_of(const Scene& scene) const {
  const double most_pixels = holds_time(scene) ? 4096.0 * 4096.0 : 6144.0 * 6144.0;  // 12 bytes each
  const View view = shown_view();
  const double largest = std::sqrt(most_pixels / (static_cast<double>(view.width) * view.height));
  const double scale = std::min(scene.quality.resolution_scale, std::max(1.0, largest));
  return drawn_at(view, scale, std::max(1, gl::caps().max_texture));
}

View Session::view() const { return view_of(shown()); }

glm::dvec2 Session::to_pixels(glm::dvec2 points) const { return points * scale_; }

// Frames

Session::Turn Session::frame(double now, GLuint framebuffer) {
  Turn turn;
  const double elapsed = at_rest_ ? 0.0 : std::clamp(now - now_, 0.0, 1.0);
  last_elapsed_ = elapsed;
  choose_making(at_rest_ ? 0.0 : 1000.0 * (now - now_));
  now_ = now;
  if (made_at_ < 0.0) made_at_ = now;
  if (!renderer_) return turn;
  if (planet_stale_) {
    leave_rest();
    // A technique that is new to the scene compiles in the background; until then the last picture stays.
    turn.progress = renderer_->prepare(shown(), view(), effort());
    turn.again = true;
    if (turn.progress < 1.0) return turn;
  }

  if (camera_.tick(document_.scene, shown_view(), elapsed)) scene_was_changed();
  if (elapsed > 0.0 && !keys_tapped_.empty()) {
    keys_tapped_.clear();
    update_pushes();
  }
  advance_clock(elapsed);
  // The planet is shown first: a panel's font and programs would keep it waiting.
  const bool picture_comes = planet_stale_ || (clock_moved_ && (bands_.bands() == 1 || bands_.complete()));
  const bool clock_due = picture_comes && seconds_by_the_clock() - panel_ran_ >= clock_pace;
  const bool panel_wanted = panel_shown_ && frames_ > 0 && (panel_frames_ > 0 || clock_due);
  if (panel_wanted) run_panel();
  hand_on_typed_ahead();
  if (panel_wanted && panel_.shows_presets()) draw_preset_picture();
  if (panel_wanted && panel_.shows_map()) draw_map();
  if (!panel_shown_) ImGui::GetIO().ClearEventsQueue();  // which nobody reads
  choose_quality(now);
  if (planet_stale_ || frames_ == 0 || is_finer()) {
    draw_planet(now);
    turn.drawn = true;
  } else if (clock_moved_ || bands_.under_way()) {
    turn.drawn = draw_for_the_clock(now);
  } else {
    forget_intervals();  // what comes next follows on no frame of the planet
    turn.drawn = panel_wanted || panel_frames_ > 0;
  }
  if (turn.drawn) {
    renderer_->show(screen(framebuffer), shown().quality.antialias);
    if (panel_shown_ && painter_) painter_->draw(*ImGui::GetDrawData(), screen(framebuffer));
    if (panel_frames_ > 0) --panel_frames_;
  }
  turn.bare = renderer_->only_air();
  turn.whole = !planet_stale_ && renderer_->whole() && (!panel_shown_ || painter_);
  const bool clock_runs = !paused_ && renderer_->needs().moving;
  turn.again = panel_frames_ > 0 || clock_runs || camera_.moving() || !renderer_->settled() || planet_stale_ ||
               clock_moved_ || bands_.under_way() || refines_ ||
               (stands_still() && quality_.will_refine(document_.scene));
  at_rest_ = !turn.again;
  if (at_rest_) forget_intervals();  // a pause is not a slow frame
  return turn;
}

void Session::draw_preset_picture() {
  if (!preset_pictures_) preset_pictures_ = std::make_unique<PresetPictures>();
  if (preset_pictures_->complete()) return;
  preset_pictures_->advance();
  planet_stale_ = true;
  panel_frames_ = std::max(panel_frames_, 2);
}

// The planet on screen is as it was: what is drawn anew is the panel.
void Session::draw_map() {
  if (!map_) map_ = std::make_unique<MapPicture>();
  if (!map_->advance(document_.scene, std::max(1.0, 1000.0 * share_of_map * last_elapsed_))) return;
  painter_->textures_changed();
  panel_frames_ = std::max(panel_frames_, 2);
}

void Session::advance_clock(double elapsed) {
  if (paused_ || document_.scene.time.speed == 0.0) return;
  seconds_ += elapsed * document_.scene.time.speed;
  if (renderer_->needs().moving) clock_moved_ = true;
}

// Nothing changes by itself, whatever the quality: coarse waves may be too small to be drawn as such, and rest.
bool Session::stands_still() const { return paused_ || !may_move(shown()); }

void Session::leave_rest() {
  quality_.moved();
  refines_ = false;
}

// A planet that rests is drawn as well as can be, and one that moves as fast as is asked.
void Session::choose_quality(double now) {
  if (planet_stale_ || clock_moved_ || bands_.under_way() || camera_.moving() || hand_is_busy()) {
    leave_rest();
  } else if (stands_still() && renderer_->settled() && quality_.rested(now, document_.scene)) {
    refines_ = true;
  }
  // What is shown stays until the programs are there.
  if (refines_ && renderer_->prepare(shown(), view(), effort()) == 1.0) {
    refines_ = false;
    planet_stale_ = true;
  }
}

// Whether there is more to show than the last frame did, without anything having changed.
bool Session::is_finer() {
  if (clock_moved_ || bands_.under_way() || renderer_->settled() || hand_on_value_) return false;
  return !renderer_->whole() || renderer_->refine(shown(), view(), std::max(making_ms_, making_ms_at_rest));
}

Effort Session::effort() const {
  if (!soonest_drawn_) return Effort::soonest;
  return hand_on_value_ ? Effort::hurried : Effort::live;
}

void Session::draw_planet(double now) {
  bands_.drop();
  const Effort effort = this->effort();
  renderer_->draw(shown(), view(), {Channel::color, effort, false, std::nullopt, making_ms_});
  const bool soonest = effort == Effort::soonest;
  planet_stale_ = soonest;  // the rest follows
  clock_moved_ = false;
  soonest_drawn_ = true;
  planet_shown_ = !soonest;
  note_frame_time(now);
  note_picture_time(now);
  if (!soonest) return;
  // How long the compiler takes is no time of a frame.
  forget_intervals();
  unsettled_since_.reset();
}

bool Session::is_watched() const {
  // Where time is held, quality is given up, not pictures.
  return holds_time(document_.scene) || panel_frames_ > 0 || hand_is_busy() || camera_.moving() ||
         !renderer_->settled();
}

bool Session::draw_for_the_clock(double now) {
  const bool at_once = is_watched();
  if (at_once && !bands_.under_way()) {
    draw_planet(now);
    return true;
  }
  if (!at_once && bands_.gpu_is_busy()) return false;
  // To show a picture is as much work as a band, and has a frame of its own.
  const bool show = at_once || bands_.bands() == 1 || bands_.complete();
  if (!bands_.under_way()) {
    const double after = last_drawn_ ? 1000.0 * (now - *last_drawn_) : 0.0;
    bands_.begin(*renderer_, shown(), view(), {Channel::color, Effort::live, false, std::nullopt, making_ms_}, after);
    clock_moved_ = false;
  } else if (!bands_.complete()) {
    do bands_.draw_next(*renderer_);
    while (at_once && !bands_.complete());
  }
  note_frame_time(now);
  if (show) {
    bands_.drop();
    note_picture_time(now);
  }
  return show;
}

// One late frame may have any cause; two in a row are slow ones.
void Session::choose_making(double interval_ms) {
  const double slow_ms = std::min(interval_ms, std::exchange(last_interval_ms_, interval_ms)) - quick_frame_ms;
  making_ms_ = std::clamp(share_of_making * slow_ms, least_making_ms, most_making_ms);
}

void Session::forget_intervals() {
  last_drawn_.reset();
  last_shown_.reset();
}

void Session::note_frame_time(double now) { note_interval(last_drawn_, now, frame_ms_); }

void Session::note_picture_time(double now) {
  if (++frames_ == 1) first_frame_ms_ = 1000.0 * (now - made_at_);
  // What refines the ground, or a hand that holds it coarse, makes no common picture; unless it goes on and on.
  if (renderer_->settled()) {
    unsettled_since_.reset();
  } else if (!unsettled_since_) {
    unsettled_since_ = now;
  }
  const bool common = !unsettled_since_ || now - *unsettled_since_ > longest_refinement;
  if (last_shown_ && common && !hand_on_value_) {
    quality_.note(now, 1000.0 * (now - *last_shown_), document_.scene);
  } else {
    quality_.interrupt();
  }
  note_interval(last_shown_, now, picture_ms_);
}

// Runs the panel's logic on the events since the last time; what it shows is drawn later.
void Session::run_panel() {
  ImGuiIO& io = ImGui::GetIO();
  const double now = seconds_by_the_clock();
  io.DeltaTime = static_cast<float>(std::clamp(now - panel_ran_, 0.001, 1.0));  // tells two clicks from a double click
  panel_ran_ = now;
  if (!painter_) painter_ = std::make_unique<PanelPainter>();
  // Two presses are told apart frame by frame: where frames are slow, a double click takes longer.
  io.MouseDoubleClickTime = static_cast<float>(double_click_time + 2.0 * last_elapsed_);
  painter_->begin_frame();
  ImGui::NewFrame();
  if (imgui_input::waiting()) panel_frames_ = std::max(panel_frames_, 4);  // one for it, three to settle
  const Covered covered = panel_.covered();
  const PanelPlace place = panel_.place();
  const bool had_keyboard = panel_.has_keyboard();
  const PanelWishes wishes = panel_.draw(document_, facts());
  if (panel_.covered() != covered) planet_stale_ = true;
  if (panel_.place() != place) panel_frames_ = std::max(panel_frames_, 4);  // to find its size
  if (panel_.moves()) panel_frames_ = std::max(panel_frames_, 2);
  if (had_keyboard && !panel_.has_keyboard()) tab_leads_out_ = ImGui::IsKeyDown(ImGuiKey_Escape);
  ImGui::Render();
  keep_habits();
  obey(wishes);
}

void Session::keep_habits() {
  std::string habits = panel_.habits();
  if (habits == kept_habits_) return;
  kept_habits_ = std::move(habits);
  if (host_.keep_habits) host_.keep_habits(kept_habits_);
}

void Session::obey(const PanelWishes& wishes) {
  if (wishes.scene_replaced) {
    camera_.scene_replaced(document_.scene);
    lacks_real_size_ = false;  // it is asked for again
  }
  if (wishes.preset_chosen) opened_ = document_;
  if (wishes.scene_changed || wishes.scene_replaced) {
    begin_step_of_panel();
    if (wishes.takes_back) history_.take_back();
    scene_was_changed();
  }
  // The hand has left a value: now the finer ground can come.
  if (hand_on_value_ && !wishes.dragging) planet_stale_ = true;
  hand_on_value_ = wishes.dragging;
  if (wishes.undo) undo();
  if (wishes.redo) redo();
  if (wishes.camera_mode) set_camera_mode(*wishes.camera_mode);
  if (wishes.go_to) fly_to(*wishes.go_to);
  if (wishes.paused) set_paused(*wishes.paused);
  if (wishes.seconds) set_seconds(*wishes.seconds);
  if (wishes.copy_link && host_.copy_text) host_.copy_text(to_link(document_));
  if (wishes.copy_json && host_.copy_text) host_.copy_text(to_json(document_));
  if (wishes.save_json && host_.save_json) host_.save_json(to_json(document_));
  if (wishes.open_json && host_.open_json) host_.open_json();
  if (wishes.save_picture && host_.save_picture) host_.save_picture(*wishes.save_picture);
  if (wishes.fill_screen && host_.fill_screen) host_.fill_screen();
  if (wishes.dismiss_notices) notices_.clear();
}

PanelFacts Session::facts() const {
  PanelFacts facts;
  const RenderStats work = renderer_->stats();
  facts.seconds = seconds_;
  facts.paused = paused_;
  facts.comparing = comparing_;
  facts.camera_mode = camera_.mode();
  facts.can_fill_screen = host_.fill_screen != nullptr;
  facts.can_undo = history_.can_undo();
  facts.can_redo = history_.can_redo();
  facts.frame_ms = spread_of(picture_ms_).median;
  facts.triangles = work.triangles;
  facts.gpu_bytes = work.gpu_bytes;
  facts.noise_evaluations = work.noise_evaluations;
  facts.draw_calls = work.draw_calls;
  facts.width = screen(0).width;
  facts.height = screen(0).height;
  facts.largest_picture = largest_picture;
  facts.renderer = gl::renderer_name();
  for (const Decision& d : renderer_->needs().decisions) facts.decisions.push_back({d.what, d.chosen, d.why});
  facts.notices = notices_;
  facts.beyond = beyond();
  facts.quality = quality_.step_for(document_.scene);
  if (map_) facts.map = map_->texture();
  if (preset_pictures_) facts.preset_pictures = preset_pictures_->textures();
  return facts;
}

std::vector<std::string> Session::beyond() const {
  if (!renderer_ || frames_ == 0 || comparing_) return {};
  std::vector<std::string> sentences;
  for (const Issue& issue : beyond_validity(document_.scene, view(), renderer_->pose(), renderer_->needs())) {
    sentences.push_back(issue.text());
  }
  return sentences;
}

// The scene

void Session::scene_was_changed() {
  history_.note({document_, opened_}, seconds_by_the_clock());
  planet_stale_ = true;
  panel_frames_ = std::max(panel_frames_, 2);
  if (host_.scene_changed) host_.scene_changed();
  ask_for_real_size();
}

// Once, and not at every step of a hand: where the program cannot be had, who opens another scene may try again.
void Session::ask_for_real_size() {
  const bool lacked = std::exchange(lacks_real_size_, lacks_real_size(document_.scene));
  if (lacks_real_size_ && !lacked && host_.want_real_size) host_.want_real_size();
}

// What is opened before the first picture is the beginning: nothing leads back from it.
void Session::open(const SceneDocument& loaded) {
  document_ = loaded;
  find_map(document_.scene);
  opened_ = document_;
  notices_.clear();          // they were about another scene
  lacks_real_size_ = false;  // it is asked for again
  camera_.scene_replaced(document_.scene);
  if (!planet_shown_) history_.start({document_, opened_});
  history_.begin();
  scene_was_changed();
}

void Session::find_map(Scene& scene) const {
  MapFile& file = scene.terrain.map;
  for (const MapFile& known : maps_) {
    if (!file.map && known.name == file.name) file = known;
  }
}

void Session::know_map(const MapFile& file) {
  constexpr std::size_t most_kept = 4;  // up to 180 MB each
  std::erase_if(maps_, [&](const MapFile& known) { return known.name == file.name; });
  if (maps_.size() == most_kept) maps_.erase(maps_.begin());
  maps_.push_back(file);
}

void Session::take_map(const MapFile& file) {
  know_map(file);
  document_.scene.terrain.map = file;
  go_on_by(History::Means::calls);
  scene_was_changed();
}

void Session::undo() {
  if (history_.can_undo() && !hand_is_busy()) return_to(history_.undo());
}

void Session::redo() {
  if (history_.can_redo() && !hand_is_busy()) return_to(history_.redo());
}

void Session::return_to(const Snapshot& snapshot) {
  document_ = snapshot.document;
  opened_ = snapshot.opened;
  camera_.scene_replaced(document_.scene);
  scene_was_changed();
}

std::vector<std::string> Session::load_json(const std::string& text) {
  SceneDocument loaded;
  const Issues issues = terrella::load_json(loaded, text);
  if (!issues.empty() && loaded == SceneDocument{}) return issues.sentences();  // nothing applies: keep what is there
  open(loaded);
  return issues.sentences();
}

std::vector<std::string> Session::load_link(const std::string& link) {
  SceneDocument loaded;
  const Issues issues = terrella::load_link(loaded, link);
  open(loaded);
  return issues.sentences();
}

std::string Session::set(const std::string& path, const std::string& text) {
  const std::optional<Issue> issue = assign_text(document_.scene, path, text);
  if (issue) return issue->text();
  find_map(document_.scene);
  go_on_by(History::Means::calls);
  scene_was_changed();
  return {};
}

void Session::set_paused(bool paused) {
  paused_ = paused;
  panel_frames_ = std::max(panel_frames_, 2);
}

void Session::set_seconds(double seconds) {
  seconds_ = seconds;
  planet_stale_ = true;
}

void Session::show_panel(bool shown) {
  panel_shown_ = shown;
  if (!shown) hand_on_value_ = false;
  if (panel_.covered() != Covered()) planet_stale_ = true;
  panel_frames_ = 3;
}

void Session::take_habits(const std::string& habits) {
  panel_.take_habits(habits);
  kept_habits_ = panel_.habits();
  panel_frames_ = 3;
}

void Session::add_notices(const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences) {
    std::erase(notices_, sentence);  // said again, it is said last
    notices_.push_back(sentence);
  }
  if (std::ssize(notices_) > most_notices) notices_.erase(notices_.begin(), notices_.end() - most_notices);
  if (!sentences.empty()) panel_.unfold();
  panel_frames_ = 3;
}

void Session::copy_failed() {
  panel_.forget_copied();
  add_notices(
      {"Nothing was copied: the browser keeps its clipboard from this page. Save writes the scene into a file."});
}

// What holds the time of a frame is not for a picture that is kept: it may take its time.
Scene Session::as_kept() const {
  const Scene& scene = document_.scene;
  return holds_time(scene) ? with_quality(scene, quality_path().back()) : scene;
}

void Session::render_at(double seconds, GLuint framebuffer) {
  if (!renderer_) return;
  seconds_ = seconds;
  bands_.drop();
  const Scene scene = as_kept();
  renderer_->draw(scene, view_of(scene), {});
  ++frames_;
  soonest_drawn_ = planet_shown_ = true;
  forget_intervals();
  renderer_->show(screen(framebuffer), scene.quality.antialias);
  planet_stale_ = clock_moved_ = false;
  panel_frames_ = 2;
  unsigned char pixel[4];
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
}

Image Session::picture(int width, int height, bool transparent) {
  planet_stale_ = true;  // the renderer's picture will have another size
  soonest_drawn_ = true;
  StillOptions options;
  options.width = width;
  options.height = height;
  options.seconds = seconds_;
  options.field = field_of(width, height);
  options.transparent = transparent;
  return take_picture(*renderer_, as_kept(), options);
}

std::string Session::stats() const {
  StatsReport report;
  if (renderer_) report.renderer = gl::renderer_name();
  const View v = view();
  report.width = v.width;
  report.height = v.height;
  report.frame_ms = frame_ms_;
  report.picture_ms = picture_ms_;
  report.first_frame_ms = first_frame_ms_;
  report.frames = frames_;
  report.bands = bands_.bands();
  if (renderer_) {
    report.work = renderer_->stats();
    report.needs = renderer_->needs();
  }
  report.quality = quality_.step_for(document_.scene);
  report.issues = notices_;
  for (std::string& sentence : beyond()) report.issues.push_back(std::move(sentence));
  return to_json(report);
}

}  // namespace terrella
