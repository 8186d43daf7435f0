#pragma once

#include <string>

// What `terrella manual` and `terrella presets` print, for people and for programs. Each text ends with a newline.
namespace terrella {

// Markdown: a section for each group with a table of its parameters.
std::string manual_text();

// [{"path", "type", "default", "min", "max", "unit", "choices", "help"}]; min and max are null where a type has none.
std::string manual_json();

// A line for each preset: name, title, about.
std::string presets_text();

// [{"name", "title", "radius"}]; the radius in metres.
std::string presets_json();

}  // namespace terrella
