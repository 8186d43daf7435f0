// The table of the ground, for programs and for people.
#pragma once

#include <string>

#include "measure/ground_table.hpp"

namespace terrella {

// One JSON object; docs/command_line.md tells its members.
std::string ground_json(const GroundTable& table);

// A table of Markdown, its columns aligned.
std::string ground_markdown(const GroundTable& table);

// A whole page that asks nothing of any host.
std::string ground_page(const GroundTable& table);

}  // namespace terrella
