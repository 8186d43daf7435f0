#include "native/window_keys.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace terrella {

int printed_key(int code) {
  const char* const name = glfwGetKeyName(code, 0);
  const bool letter = name != nullptr && name[0] >= 'a' && name[0] <= 'z' && name[1] == '\0';
  return letter ? GLFW_KEY_A + (name[0] - 'a') : code;
}

Key key_of_glfw(int code) {
  switch (code) {
    case GLFW_KEY_LEFT: return Key::left;
    case GLFW_KEY_RIGHT: return Key::right;
    case GLFW_KEY_UP: return Key::up;
    case GLFW_KEY_DOWN: return Key::down;
    case GLFW_KEY_PAGE_UP: return Key::page_up;
    case GLFW_KEY_PAGE_DOWN: return Key::page_down;
    case GLFW_KEY_HOME: return Key::home;
    case GLFW_KEY_END: return Key::end;
    case GLFW_KEY_EQUAL:  // where plus is, unshifted, on many keyboards
    case GLFW_KEY_KP_ADD: return Key::plus;
    case GLFW_KEY_MINUS:
    case GLFW_KEY_KP_SUBTRACT: return Key::minus;
    case GLFW_KEY_SPACE: return Key::space;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER: return Key::enter;
    case GLFW_KEY_ESCAPE: return Key::escape;
    case GLFW_KEY_TAB: return Key::tab;
    case GLFW_KEY_BACKSPACE: return Key::backspace;
    case GLFW_KEY_DELETE: return Key::del;
    case GLFW_KEY_A: return Key::a;
    case GLFW_KEY_C: return Key::c;
    case GLFW_KEY_D: return Key::d;
    case GLFW_KEY_E: return Key::e;
    case GLFW_KEY_F: return Key::f;
    case GLFW_KEY_G: return Key::g;
    case GLFW_KEY_H: return Key::h;
    case GLFW_KEY_N: return Key::n;
    case GLFW_KEY_Q: return Key::q;
    case GLFW_KEY_R: return Key::r;
    case GLFW_KEY_S: return Key::s;
    case GLFW_KEY_T: return Key::t;
    case GLFW_KEY_V: return Key::v;
    case GLFW_KEY_W: return Key::w;
    case GLFW_KEY_X: return Key::x;
    case GLFW_KEY_Y: return Key::y;
    case GLFW_KEY_Z: return Key::z;
    case GLFW_KEY_1:
    case GLFW_KEY_KP_1: return Key::one;
    case GLFW_KEY_2:
    case GLFW_KEY_KP_2: return Key::two;
    case GLFW_KEY_3:
    case GLFW_KEY_KP_3: return Key::three;
    default: return Key::unknown;
  }
}

}  // namespace terrella
