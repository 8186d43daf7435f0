// The panel while it is being drawn: what all its sections read and write.
#pragma once

#include "panel/panel.hpp"
#include "scene/parameters.hpp"
#include "scene/presets.hpp"

namespace terrella {

struct Sheet {
  SceneDocument& document;
  const Preset* preset;  // the document's
  const PanelFacts& facts;
  PanelMemory& memory;
  std::vector<WidgetPlace>* places;
  PanelWishes wishes{};

  // Whether a parameter has another value than in the preset.
  bool differs(const Parameter& parameter) const;
  bool differs(const Group& group) const;

  // Sets a parameter as a user does: a value that is not allowed changes nothing.
  void set(const Parameter& parameter, const Value& value);
  void reset(const Parameter& parameter) { set(parameter, parameter.get(preset->scene)); }
  void reset(const Group& group);
  void start_from(const Preset& other);

  // By chance, but for what is locked.
  void surprise();
  void surprise(const Group& group);
  bool locked(const Parameter& parameter) const { return memory.chance.locked.contains(parameter.path); }
  void toggle_lock(const Parameter& parameter);

  // Notes where the widget that was drawn last lies, for tests and for the tour.
  void place(std::string_view name, std::string_view suffix = {}) const;

 private:
  void surprise_but_for(const Locks& locked);
};

}  // namespace terrella
