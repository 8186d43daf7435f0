#pragma once

#include "app/input.hpp"

namespace terrella {

// What one of GLFW's key codes means to the session.
Key key_of_glfw(int code);

}  // namespace terrella
