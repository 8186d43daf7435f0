// The table of the probe's functions.
#include <iterator>

#include "probe/table.hpp"

namespace terrella::probe {

std::span<const Function> functions() {
  static const std::vector<Function> all = [] {
    std::vector<Function> joined;
    for (std::vector<Function>& subject :
         std::vector<std::vector<Function>>{geometry_functions(), wave_functions(), height_functions(),
                                            surface_functions(), air_functions(), noise_functions(), ground_functions(),
                                            light_functions(), water_functions(), cloud_functions(), sky_functions()}) {
      joined.insert(joined.end(), std::make_move_iterator(subject.begin()), std::make_move_iterator(subject.end()));
    }
    return joined;
  }();
  return all;
}

const Function* find_function(std::string_view name) {
  for (const Function& function : functions()) {
    if (function.name == name) return &function;
  }
  return nullptr;
}

}  // namespace terrella::probe
