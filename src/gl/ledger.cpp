#include "gl/ledger.hpp"

namespace terrella::gl {

Ledger& ledger() {
  static Ledger the_ledger;
  return the_ledger;
}

void begin_frame() {
  ledger().draw_calls = 0;
  ledger().triangles = 0;
}

}  // namespace terrella::gl
