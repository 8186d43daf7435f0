#include "native/progress_lines.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace terrella {

std::optional<std::string> ProgressLines::line(std::string_view what, double part, double seconds) {
  const double done = std::clamp(part, 0.0, 1.0);
  if (what != what_ || done < part_) {
    what_ = what;
    said_at_ = seconds;
    tenths_ = static_cast<int>(10.0 * done);
    any_ = false;
  }
  part_ = done;
  const int tenths = static_cast<int>(10.0 * done);
  // Whoever has read that it goes on also reads that it is done.
  const bool soon = seconds - said_at_ < apart && !(any_ && tenths == 10);
  if (tenths == tenths_ || soon) return std::nullopt;
  tenths_ = tenths;
  said_at_ = seconds;
  any_ = true;
  return text_of(what_, ": ", static_cast<int>(100.0 * done), " %");
}

}  // namespace terrella
