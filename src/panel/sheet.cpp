#include "panel/sheet.hpp"

#include <imgui.h>

#include "base/text.hpp"
#include "panel/tour.hpp"

namespace terrella {

bool Sheet::differs(const Parameter& parameter) const {
  return parameter.get(document.scene) != parameter.get(preset->scene);
}

bool Sheet::differs(const Group& group) const {
  for (const Parameter& parameter : parameters()) {
    if (parameter.group == group.name && differs(parameter)) return true;
  }
  return false;
}

void Sheet::set(const Parameter& parameter, const Value& value) {
  const Value before = parameter.get(document.scene);
  if (assign(document.scene, parameter, value)) return;
  if (parameter.get(document.scene) != before) wishes.scene_changed = true;
}

void Sheet::reset(const Group& group) {
  for (const Parameter& parameter : parameters()) {
    if (parameter.group == group.name) reset(parameter);
  }
}

void Sheet::start_from(const Preset& other) {
  const SceneDocument fresh{other.scene, other.name};
  if (document == fresh) return;
  document = fresh;
  preset = &other;
  wishes.scene_replaced = true;
}

void Sheet::surprise() { surprise_but_for(memory.chance.locked); }

void Sheet::surprise(const Group& group) {
  Locks locks = memory.chance.locked;
  for (const Parameter& parameter : parameters()) {
    if (parameter.group != group.name) locks.insert(parameter.path);
  }
  surprise_but_for(locks);
}

void Sheet::surprise_but_for(const Locks& locked) {
  const Scene drawn = memory.chance.draw(document.scene, locked);
  if (drawn == document.scene) return;
  document.scene = drawn;
  wishes.scene_changed = true;
}

void Sheet::toggle_lock(const Parameter& parameter) {
  Locks& locks = memory.chance.locked;
  if (locks.erase(parameter.path) == 0) locks.insert(parameter.path);
}

void Sheet::place(std::string_view name, std::string_view suffix) const {
  if (suffix.empty()) note_tour_target(memory.tour, name);
  if (places == nullptr) return;
  const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
  places->push_back({text_of(name, suffix), from.x, from.y, to.x, to.y});
}

}  // namespace terrella
