// What hands do, the same in a window and on a page. Places are in points (CSS pixels) from the top left.
#pragma once

namespace terrella {

enum class Button { left = 0, right = 1, middle = 2 };

enum class Key {
  unknown,
  left,
  right,
  up,
  down,
  page_up,
  page_down,
  home,
  end,
  plus,
  minus,
  space,
  enter,
  escape,
  tab,
  backspace,
  del,
  a,
  c,
  d,
  e,
  f,
  g,
  h,
  n,
  q,
  r,
  s,
  t,
  v,
  w,
  x,
  y,
  z,
  one,
  two,
  three
};

struct Modifiers {
  bool shift = false, control = false;
};

}  // namespace terrella
