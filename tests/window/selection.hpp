// What one program gives another by way of the X server: the clipboard's text, files that are dragged.
#pragma once

#include <X11/Xlib.h>

#include <string>

namespace terrella::test {

// Answers a program that asks for a selection of a type; who asks for another type gets nothing. Returns whether it was
// given.
bool give_selection(const XSelectionRequestEvent& request, Atom type, const std::string& bytes);

}  // namespace terrella::test
