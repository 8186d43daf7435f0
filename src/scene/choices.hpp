#pragma once

#include <string_view>

namespace terrella {
namespace choices {

struct Named {
  std::string_view path, names;  // names: "one|two|three"
};

#define GROUP(group, title, help)
#define FLOAT(group, name, value, min, max, unit, scale, help)
#define LENGTH(group, name, value, min, max, slider_max, scale, help)
#define INT(group, name, value, min, max, help)
#define BOOL(group, name, value, help)
#define COLOR(group, name, value, help)
#define CHOICE(group, name, value, choices, help) {#group "." #name, choices},
#define FILE_NAME(group, name, help)
#define END_GROUP(group)
inline constexpr Named kAll[] = {
#include "scene/params.inc"
};
#include "scene/params_undef.inc"

// Called, and therefore a compiler's error, when choice() is given a name that params.inc does not have.
int no_such_choice();

}  // namespace choices

// The index by which a scene holds a choice, found while compiling; a misspelt name does not compile:
//   if (scene.water.model == choice("water.model", "waves")) …
consteval int choice(std::string_view path, std::string_view name) {
  for (const choices::Named& parameter : choices::kAll) {
    if (parameter.path != path) continue;
    std::string_view rest = parameter.names;
    for (int index = 0;; ++index) {
      const std::size_t bar = rest.find('|');
      if (rest.substr(0, bar) == name) return index;
      if (bar == std::string_view::npos) break;
      rest.remove_prefix(bar + 1);
    }
  }
  return choices::no_such_choice();
}

}  // namespace terrella
