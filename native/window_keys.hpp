#pragma once

#include "app/input.hpp"

namespace terrella {

// GLFW tells keys by their place on an American keyboard. The key of the letter that is printed there on this one:
// what is pressed together with Ctrl goes by its letter.
int printed_key(int code);

// What one of GLFW's key codes means to the session.
Key key_of_glfw(int code);

}  // namespace terrella
