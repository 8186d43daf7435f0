// Small widgets that Dear ImGui does not have.
#pragma once

#include <functional>
#include <string>

namespace terrella {

// The height of a line of text, in points. For fingers it is larger, and all lengths in points with it.
inline constexpr float kFontSize = 15.0F;

// Pixels of a length in points.
float points(float count);

// A bar that is filled up to a position, 0..1, with a text in it.
void bar(const char* id, double position, const std::string& text, float width);
// Where an x, in pixels, lies on the bar that was drawn last: 0..1, beyond it beside it.
double position_on_bar(float x);

// A square button with an arrow that turns back.
bool reset_button(const char* id);
// How wide that is.
float reset_button_width();

// A square button with the corners of a screen.
bool full_screen_button(const char* id);

// An entry of an open list, as high as a row of the panel.
bool choice_row(const std::string& text, bool chosen);

// The same with a picture of 16 by 9 at its left. picture: a texture of OpenGL, bottom row first; 0: it is not there
// yet.
bool picture_row(const std::string& text, unsigned picture, bool chosen);

// A button that looks pressed while something is on.
bool toggle_button(const char* label, bool on, float width);

// A text to click, underlined.
bool link_button(const char* label);

// A line of text in the colour of what matters less, wrapped.
void quiet_text(const std::string& text);

// Two things side by side, the left one in a share of the width. Text in both is wrapped.
void two_columns(float share, const std::function<void()>& left, const std::function<void()>& right);

// Opens a tooltip beside the panel, where it hides none of its sliders, at the height of the pointer, or of the widget
// drawn last that has the keyboard. Close it with
// end_side_tooltip().
void begin_side_tooltip();
void end_side_tooltip();

// A tooltip of one sentence for the widget drawn last, while the pointer is on it.
void tooltip(const std::string& text);

}  // namespace terrella
