#include "measure/trade_effects.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "measure/html.hpp"
#include "measure/words.hpp"

namespace terrella {
namespace {

std::string bar(const char* css, double part, const std::string& text) {
  return text_of("<div class=\"bar", css, "\"><i style=\"width:", printed_number(100.0 * std::clamp(part, 0.0, 1.0), 3),
                 "%\"></i><b>", text, "</b></div>\n");
}

// To a whole number of steps.
std::string rounded(double value, double step) { return printed_number(std::round(value / step) * step, 6); }

}  // namespace

std::string effects_html(const TradeReport& report) {
  if (report.effects.empty()) return {};
  const PictureError with = report.settings[report.own].error();
  std::vector<const EffectTrade*> order;
  double most_ms = 1e-9, most_flip = 1e-9;
  for (const EffectTrade& trade : report.effects) {
    order.push_back(&trade);
    most_ms = std::max(most_ms, trade.cost_ms.median);
    most_flip = std::max(most_flip, trade.without.error().flip - with.flip);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const EffectTrade* a, const EffectTrade* b) { return a->cost_ms.median > b->cost_ms.median; });
  std::string html =
      "<h2>What is in the picture, and what it costs</h2>\n<p>Each effect of the scene is left out, one at a time: how "
      "much faster frames become, and by how much the picture is then farther from the one that has it.</p>\n"
      "<div class=\"bars\">\n<div class=\"head\"></div><div class=\"head\">costs, ms a frame</div>"
      "<div class=\"head\">adds to FLIP if left out, and takes off PSNR</div>\n";
  for (const EffectTrade* trade : order) {
    const PictureError without = trade->without.error();
    const double flip = without.flip - with.flip;
    html += text_of("<div class=\"what\">", escaped(trade->effect->title), "</div>\n",
                    bar("", trade->cost_ms.median / most_ms, with_spread(trade->cost_ms)),
                    bar(" gain", flip / most_flip,
                        text_of(rounded(flip, 1e-4), ", ", rounded(with.psnr() - without.psnr(), 0.01), " dB")));
  }
  return html + "</div>\n";
}

}  // namespace terrella
