// What a hand does to a slider: it drags, turns the wheel, or asks to type.
#pragma once

#include <optional>
#include <string_view>

#include "panel/memory.hpp"

namespace terrella {

struct SliderWish {
  std::optional<double> position;  // where the hand drags it, 0..1
  double steps = 0.0;              // small ones, by the wheel or arrow keys
  std::optional<double> type;      // the value that shall be typed over
  bool takes_back = false;         // what a first click did: this was the second
};

// What the hand does to the slider drawn last, which stands at a position and a value. A press takes it to the pointer;
// with Ctrl it stays and is dragged at a tenth of the speed. Under a finger it stays until the finger is drawn along
// it, or let go: a finger that is drawn across it scrolls the panel. Ctrl+click and double click ask to type; as the
// first click of two has moved the slider, they bring the value before it. By keyboard, arrows take steps and Enter
// asks to type.
SliderWish hand_on_slider(SliderHand& hand, std::string_view path, double position, double value);

// After all sliders of a frame. Where the wheel scrolled the panel it goes on to do so, although a slider comes to lie
// under the pointer, until the pointer moves.
void note_scrolling(Wheel& wheel);

}  // namespace terrella
