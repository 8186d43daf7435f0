// Sentences about bad input. The parameter that one is about is a link to it.
#pragma once

#include <string>
#include <string_view>

#include "panel/sheet.hpp"

namespace terrella {

// The sentences that there are: those about input until they are dismissed, those about the scene as long as they hold.
void notices_section(Sheet& sheet);

// A sentence, as Issue::text() words it, in its parts.
struct Notice {
  const Parameter* about = nullptr;      // at its beginning, "waves.steepness: 7 is out of range; ..."
  const Parameter* suggested = nullptr;  // at its end, "...; did you mean waves.count?"
  std::string sentence;                  // without the parameter it is about
};

Notice notice_of(std::string_view text);

}  // namespace terrella
