// Hands to Dear ImGui, in pixels.
#pragma once

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
// Ctrl+V, whatever keys are held: while Ctrl is, fields take no letters.
void paste(Modifiers held);

// Whether some of it is still to come: Dear ImGui takes a key's way down and its way up in different frames.
bool waiting();

}  // namespace terrella::imgui_input
