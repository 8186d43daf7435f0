#include "panel/habits.hpp"

#include <algorithm>
#include <set>

#include "panel/sections.hpp"
#include "scene/parameters.hpp"

namespace terrella {
namespace {

constexpr std::string_view folded = "folded", mix = "mix", tour = kNewcomersHabits;

std::vector<std::string_view> sections() {
  std::vector<std::string_view> names;
  for (const Group& group : groups()) names.push_back(group.name);
  names.push_back(decisions_name);
  names.push_back(statistics_name);
  return names;
}

std::set<std::string_view> words_of(std::string_view text) {
  std::set<std::string_view> words;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
    words.insert(text.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

}  // namespace

std::string habits_of(const PanelMemory& memory) {
  std::string text;
  const auto add = [&](std::string_view word, bool wanted) {
    if (!wanted) return;
    if (!text.empty()) text += ' ';
    text += word;
  };
  add(folded, memory.folded.value_or(false));
  add(mix, memory.mix.shown);
  add(tour, memory.tour.wanted);
  for (const std::string_view name : sections()) add(name, memory.open.contains(name));
  return text;
}

void take_habits(PanelMemory& memory, std::string_view text) {
  const std::set<std::string_view> words = words_of(text.substr(0, kLongestHabits));
  memory.folded.reset();
  if (words.contains(folded)) memory.folded = true;
  memory.mix.shown = words.contains(mix);
  memory.tour.wanted = words.contains(tour);
  memory.open.clear();
  for (const std::string_view name : sections()) {
    if (words.contains(name)) memory.open.insert(name);
  }
}

}  // namespace terrella
