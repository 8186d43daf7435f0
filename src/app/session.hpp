// One planet on screen: scene, clock, camera, panel and renderer. The window and the page feed it with what hands do
// and ask it for frames; it draws only when something has changed.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/camera_control.hpp"
#include "app/history.hpp"
#include "app/input.hpp"
#include "app/map_picture.hpp"
#include "app/panel_painter.hpp"
#include "app/picture_in_bands.hpp"
#include "app/preset_pictures.hpp"
#include "app/quality_control.hpp"
#include "base/image.hpp"
#include "panel/panel.hpp"
#include "render/renderer.hpp"
#include "scene/document.hpp"

struct ImGuiContext;

namespace terrella {

// Pixels along a side of a picture that Session makes: the memory of a page holds no larger one.
inline constexpr int largest_picture = 8192;

class Session {
 public:
  // What the surroundings do for the session.
  struct Host {
    std::function<void()> scene_changed;                   // by the user or by a call
    std::function<void(const std::string&)> copy_text;     // a link or JSON, to the clipboard
    std::function<void(const std::string&)> copy_typed;    // what was marked in a field of the panel, likewise
    std::function<void(const std::string&)> save_json;     // offers a file
    std::function<void()> open_json;                       // asks for a file; comes back through load_json
    std::function<void(const PictureWish&)> save_picture;  // offers a picture made by picture()
    std::function<void(const std::string&)> keep_habits;   // the panel's, for take_habits at the next visit
    std::function<void()> fill_screen;                     // the whole one, or back; empty where that cannot be
    std::function<void()> want_real_size;                  // a program that draws such planets, for a scene has come
                                                           // to be of one; this session could hand over to it
  };

  explicit Session(Host host);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // After a context was made current and its caps read; again after it was lost and restored.
  void context_made();
  // Everything on the GPU is gone. The scene is not.
  void context_lost();

  // points: size of the window or canvas; scale: pixels per point; fingers: they are what points here, not a mouse.
  void resize(int width, int height, double scale, bool fingers = false);

  // What the next movements and presses are made by.
  void pointer_is_finger(bool finger);

  void pointer_moved(double x, double y);
  void pointer_button(Button button, bool down);
  void pointer_left();  // the window
  void wheel(double notches);
  // Two fingers: factor of their distance, twist of the line through them (rad, clockwise), movement of their middle,
  // around a place.
  void pinch(double factor, double twist, double dx, double dy, double x, double y);
  // Returns whether it was of use here. Tab is not once the panel was left by Escape, so that it leads out of the
  // planet.
  bool key(Key key, bool down, Modifiers modifiers);
  void keys_left();  // the keyboard has gone elsewhere: none is held any more
  void text(unsigned codepoint);
  // Whether a field of the panel waits for text: where there are no keys, they are to be shown.
  [[nodiscard]] bool wants_text() const;
  // From the clipboard: into the field that has the keyboard, else it is a scene. Ctrl+V by itself does nothing.
  void pasted(const std::string& text);

  struct Turn {
    bool drawn = false;     // into the framebuffer given
    bool bare = false;      // what is on screen is the air alone
    bool whole = false;     // what is on screen lacks nothing, as the first pictures do
    bool again = false;     // another frame is wanted without a further event
    double progress = 1.0;  // below 1 until the first frame: share of the shaders that are ready
  };
  // now: seconds of any steady clock.
  Turn frame(double now, GLuint framebuffer);

  [[nodiscard]] const SceneDocument& document() const { return document_; }
  [[nodiscard]] CameraMode camera_mode() const { return camera_.mode(); }
  // Sentences for what was skipped; the rest applies.
  std::vector<std::string> load_json(const std::string& text);
  std::vector<std::string> load_link(const std::string& link);
  // A map of heights that is at hand, for scenes that name it. The last few are kept.
  void know_map(const MapFile& file);
  // The same, which the scene takes at once.
  void take_map(const MapFile& file);
  // A sentence if the value was refused, else nothing. text: as in a link.
  std::string set(const std::string& path, const std::string& text);
  // One step back or ahead; nothing where there is none, or while a hand is in the middle of a change.
  void undo();
  void redo();

  void set_paused(bool paused);
  void set_seconds(double seconds);
  void show_panel(bool shown);
  // What the host was given to keep, or nothing.
  void take_habits(const std::string& habits);
  // Unfolds the panel, where they stand.
  void add_notices(const std::vector<std::string>& sentences);
  // What Host::copy_text or copy_typed was given did not reach the clipboard.
  void copy_failed();

  // Whether no hand holds anything, so that the session of another program can go on in its place.
  [[nodiscard]] bool hands_rest() const;
  // All that it needs for that but maps (know_map) and a context, as text.
  [[nodiscard]] std::string hand_over() const;
  // For a new session. The host hears of no change.
  void take_over(const std::string& text);

  // Draws the planet as it is at a time, complete, and waits until it is there. Leaves the clock at that time.
  void render_at(double seconds, GLuint framebuffer);
  // A picture of the planet alone, of any size that the machine can draw.
  Image picture(int width, int height, bool transparent = false);
  // As JSON.
  [[nodiscard]] std::string stats() const;

 private:
  enum class Drag { none, turn, look };
  enum class OnPanel { nothing_new, press, wheel };  // a hand, since the panel last changed the scene

  // Of hands. What frame() is told stands still while nothing is drawn.
  static double seconds_by_the_clock();
  bool is_for_panel(Key key) const;
  bool lead_into_panel();
  void share_clipboard();
  void hand_on_typed_ahead();
  View shown_view() const;
  View view_of(const Scene& scene) const;
  // Of the pixels that are drawn.
  View view() const;
  // The window or canvas, in its own pixels.
  gl::Screen screen(GLuint framebuffer) const;
  // What is drawn: the scene or, while comparing, the planet as it was opened, seen from where the camera is now; with
  // the quality that holds its target.
  Scene shown() const;
  Scene as_kept() const;
  void compare(bool wanted);
  void surprise();
  void set_camera_mode(CameraMode mode);
  void fly_to(const Destination& there);
  void scene_was_changed();
  void open(const SceneDocument& loaded);
  // Gives a scene the map that it names, if it is at hand.
  void find_map(Scene& scene) const;
  SceneDocument document_of(std::string_view json) const;
  void ask_for_real_size();
  void return_to(const Snapshot& snapshot);
  bool hand_is_busy() const { return drag_ != Drag::none || hand_on_value_; }
  void begin_step_of_panel();
  void go_on_by(History::Means means);
  void update_pushes();
  void run_panel();
  void obey(const PanelWishes& wishes);
  void keep_habits();
  void advance_clock(double seconds);
  bool stands_still() const;
  void leave_rest();
  void choose_quality(double now);
  bool is_finer();
  Effort effort() const;
  void draw_planet(double now);
  // What only the clock has made stale; returns whether there is a picture to be shown.
  bool draw_for_the_clock(double now);
  // Whether somebody may see that a picture is late.
  bool is_watched() const;
  void draw_preset_picture();
  void draw_map();
  void note_frame_time(double now);
  void note_picture_time(double now);
  void forget_intervals();
  // interval_ms: since the frame before, 0 after a rest.
  void choose_making(double interval_ms);
  PanelFacts facts() const;
  // Sentences about what of the scene lies beyond the range in which its technique holds.
  std::vector<std::string> beyond() const;
  glm::dvec2 to_pixels(glm::dvec2 points) const;

  Host host_;
  SceneDocument document_;
  SceneDocument opened_;       // as it was when it was loaded
  std::vector<MapFile> maps_;  // at hand, the last one last
  History history_;
  ImGuiContext* imgui_;
  std::string clipboard_;                  // as the panel's fields know it
  std::unique_ptr<PanelPainter> painter_;  // from when the panel first runs in a context
  Panel panel_;
  std::string kept_habits_ = panel_.habits();
  CameraControl camera_;
  QualityControl quality_;
  std::unique_ptr<Renderer> renderer_;
  std::unique_ptr<PresetPictures> preset_pictures_;  // from when they are first asked for in a context
  std::unique_ptr<MapPicture> map_;                  // likewise

  int width_ = 1280, height_ = 720;  // points
  double scale_ = 1.0;
  bool large_rows_ = false;  // for fingers
  double seconds_ = 0.0;
  bool paused_ = false;
  bool panel_shown_ = true;
  std::vector<std::string> notices_;

  glm::dvec2 pointer_{0.0};
  Drag drag_ = Drag::none;
  double last_drag_time_ = 0.0;
  std::set<Key> keys_down_;
  std::set<Key> keys_tapped_;  // since the camera last moved: a tap may be shorter than a frame
  Modifiers modifiers_;
  bool hand_on_value_ = false;
  bool tab_leads_out_ = false;  // the panel was left by Escape
  OnPanel on_panel_ = OnPanel::nothing_new;
  bool pressed_on_panel_ = false;              // by the last press
  std::optional<std::u32string> typed_ahead_;  // for the search, whose field is on its way
  bool comparing_ = false;
  bool lacks_real_size_ = false;  // the scene did, after the last change

  bool planet_stale_ = true;  // the scene, the size or the place in time has changed since it was drawn
  bool clock_moved_ = false;  // or the clock has run on
  PictureInBands bands_;
  std::optional<double> unsettled_since_;  // s
  bool refines_ = false;                   // a finer picture waits for its programs
  int panel_frames_ = 3;                   // frames that the panel still needs to settle after an event
  double now_ = 0.0;
  double making_ms_ = least_making_ms;  // as of Shot
  double last_interval_ms_ = 0.0;       // from the frame before to the last one; 0 after a rest
  double last_elapsed_ = 0.0;           // s that the last frame came after the one before it; 0 after a rest
  double panel_ran_ = 0.0;              // s, by a clock of its own: between frames there may be long rests
  bool at_rest_ = true;  // nothing moved after the last frame, so that the time until the next one does not count
  double made_at_ = -1.0;
  std::optional<double> last_drawn_, last_shown_;  // s: a frame that drew anything, a picture on screen
  std::vector<double> frame_ms_, picture_ms_;
  double first_frame_ms_ = 0.0;
  std::int64_t frames_ = 0;     // pictures shown
  bool soonest_drawn_ = false;  // or made needless
  bool planet_shown_ = false;   // by a picture that was not the soonest
};

}  // namespace terrella
