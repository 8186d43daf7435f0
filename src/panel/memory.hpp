// What the panel remembers from one frame to the next, beside what Dear ImGui does.
#pragma once

#include <array>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <string_view>

#include "scene/surprise.hpp"

namespace terrella {

// A number that is being typed in the place of its slider.
struct Typing {
  std::string_view path;  // the parameter's; empty while nobody types
  std::array<char, 48> text{};
  std::string before;  // what the text was at first
  bool begun = false;  // the field has had the keyboard
  int frames_waited = 0;
};

// The press on a slider.
struct Grip {
  std::string_view path;  // of the slider pressed last
  double before = 0.0;    // its value before that
  double position = 0.0;  // where it is dragged; beyond 0..1 the pointer is beside it
  float x = 0.0F;         // of the pointer, pixels
  bool stays = false;     // pressed with Ctrl or by a finger, and not moved yet
};

// The wheel over the panel.
struct Wheel {
  std::string_view path;                         // of the slider over which it turns
  double turned = 0.0;                           // parts of a notch
  bool taken = false;                            // in this frame, by a slider
  float scrolled_x = -1.0F, scrolled_y = -1.0F;  // where the pointer was when it scrolled the panel, pixels
};

struct SliderHand {
  Grip grip;
  Wheel wheel;
};

// Which parameters are shown.
struct Search {
  std::array<char, 48> text{};
  bool wanted = false;  // the field shall have the keyboard
  bool alone = false;   // what is found stands there without the rest of the panel
};

// A finger on the panel.
struct FingerScroll {
  unsigned window = 0;  // that it was put on, by Dear ImGui's number
  bool decided = false, scrolls = false;
  float speed = 0.0F;  // of what is scrolled, pixels a second; it runs on when the finger has left
};

// How far down the rows are.
struct Scrolling {
  float at = 0.0F;        // in the last frame, pixels
  float wanted = 0.0F;    // to go on from where another panel was
  int frames_to_get = 0;  // there: at first the rows are not known to be so long
};

// Where text is typed.
struct Caret {
  float window_height = 0.0F;  // at the last frame, pixels
  int frames_to_follow = 0;    // it may still move with the layout
};

// Who has the keyboard.
struct Keyboard {
  bool wanted = false;  // the panel shall have it
  bool here = false;    // a widget of the panel has it, and is marked
  bool busy = false;    // an open list or a value being changed has the next Escape
};

struct PanelPlace {
  bool below = false;   // it is a sheet under the planet, not at the left edge
  bool folded = false;  // to a button

  bool operator==(const PanelPlace&) const = default;
};

// What the panel hides of the window, pixels.
struct Covered {
  float left = 0.0F, below = 0.0F;

  bool operator==(const Covered&) const = default;
};

// What is drawn by chance.
struct Chance {
  Locks locked;           // by the user
  std::minstd_rand dice;  // for the seeds

  // The next planet by chance, but for some locks.
  Scene draw(const Scene& scene, const Locks& but_for) {
    return surprise(scene, but_for, static_cast<std::uint32_t>(dice()));
  }
};

// The way from a scene to a preset.
struct Mix {
  bool shown = false;
  std::string_view preset;  // its name, empty before the first
  double share = 0.0;       // of the way
  Scene from, mixed;        // while share is above 0: the beginning, and what was made last
};

// The next picture to be saved that has a size of its own, and whether any has a sky.
struct PictureSize {
  int width = 1920, height = 1080;
  bool transparent = false;
};

// Where something was drawn last, pixels.
struct Box {
  float left = 0.0F, top = 0.0F, right = 0.0F, bottom = 0.0F;
};

// The bubbles for newcomers.
struct Tour {
  bool wanted = false;
  int step = 0;
  Box target;            // the widget to which the bubble points
  bool arrived = false;  // it has been scrolled into sight
};

struct PanelMemory {
  PanelPlace first_place;      // before a hand has folded or unfolded it
  std::optional<bool> folded;  // as a hand has left it
  [[nodiscard]] PanelPlace place() const { return {first_place.below, folded.value_or(first_place.folded)}; }

  bool keys_shown = false;          // the list of keys
  bool presets_shown = false;       // a list of them, in this frame
  bool map_shown = false;           // in this frame
  std::set<std::string_view> open;  // sections
  Typing typing;
  FingerScroll finger;
  Scrolling scrolling;
  Caret caret;
  Keyboard keyboard;
  SliderHand hand;
  Search search;
  Chance chance;
  Mix mix;
  PictureSize picture;
  Tour tour;
  std::string no_place;     // what is wrong with the place that was typed to go to
  std::string_view copied;  // the button that has just copied something, while the pointer rests on it
};

}  // namespace terrella
