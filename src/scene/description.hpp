#pragma once

#include <string>

#include "scene/document.hpp"

namespace terrella {

// What a picture of the scene shows, for those who do not see it: "Storm at sea, a procedural planet. High waves break
// … sky. Seen from above 12 degrees north, 20 degrees west. 2 settings changed."
std::string description(const SceneDocument& document);

}  // namespace terrella
