#include "measure/words.hpp"

#include <cmath>

#include "base/text.hpp"

namespace terrella {
namespace {

std::string listed(const std::string& before, const std::string& more) {
  return before.empty() ? more : text_of(before, ", ", more);
}

// "quality.ground_texels" as "ground texels"
std::string knob_in_words(const Knob& knob) { return in_words(parameter_of(knob).name); }

}  // namespace

std::string figure(double value) {
  if (std::abs(value) >= 1000.0) return text_of(static_cast<long long>(std::llround(value)));
  return printed_number(value, 3);
}

std::string decibels(double psnr) { return printed_number(psnr, 3) + " dB"; }

std::string percent(double part) { return printed_number(100.0 * part, 3) + " %"; }

std::string with_spread(const Spread& spread) {
  return text_of(figure(spread.median), " (", figure(spread.p10), " to ", figure(spread.p90), ")");
}

std::string changes(const Scene& from, const Scene& to) {
  std::string text;
  for (const Knob& knob : knobs()) {
    const Value before = parameter_of(knob).get(from), after = parameter_of(knob).get(to);
    if (before != after)
      text = listed(text, text_of(knob_in_words(knob), ' ', to_text(before), " to ", value_in_words(knob, after)));
  }
  return text;
}

std::string setting_in_words(const Setting& setting, const Scene& scene) {
  std::string text;
  for (const Knob& knob : knobs()) {
    const Value value = parameter_of(knob).get(setting.scene);
    if (value != parameter_of(knob).get(scene))
      text = listed(text, text_of(knob_in_words(knob), ' ', value_in_words(knob, value)));
  }
  return text.empty() ? "as the scene has it" : text;
}

std::string value_in_words(const Knob& knob, const Value& value) {
  const std::string_view unit = parameter_of(knob).unit;
  return unit.empty() ? to_text(value) : text_of(to_text(value), ' ', unit);
}

}  // namespace terrella
