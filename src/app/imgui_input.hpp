// Hands to Dear ImGui, in pixels.
#pragma once

#include <string>

#include "app/input.hpp"

namespace terrella::imgui_input {

void move(double x, double y);
// What the movements and presses to come are made by.
void pointer_is_finger(bool finger);
void leave();
void button(int button, bool down);
void wheel(double notches);
// Whether a key leads from widget to widget, or presses one.
bool navigates(Key key);
void key(Key key, bool down, Modifiers modifiers);
void text(unsigned codepoint);
void text(const std::string& utf8);

// Whether events wait for the next frame: a key pressed twice takes as many.
bool events_left();

}  // namespace terrella::imgui_input
