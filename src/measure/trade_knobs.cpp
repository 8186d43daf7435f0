#include "measure/trade_knobs.hpp"

#include "base/text.hpp"
#include "measure/counters.hpp"
#include "measure/html.hpp"
#include "measure/trade_pictures.hpp"
#include "measure/words.hpp"

namespace terrella {
namespace {

std::string table_of(const KnobTrade& trade, const TradeReport& report) {
  std::vector<std::string> heads = {"value",       "ms",          "PSNR, dB",        "FLIP",
                                    "visibly off", "outline, px", "normals, degrees"};
  for (const Counter& counter : counters()) heads.emplace_back(counter.title);
  Table table(heads);
  for (std::size_t i = 0; i < trade.values.size(); ++i) {
    const Setting& setting = report.settings[trade.settings[i]];
    const PictureError error = setting.error();
    std::vector<std::string> cells = {
        value_in_words(*trade.knob, trade.values[i]) + (trade.settings[i] == report.own ? " (the scene's)" : ""),
        with_spread(setting.ms()),
        figure(error.psnr()),
        figure(error.flip),
        percent(error.visible),
        figure(error.silhouette),
        text_of(figure(error.normal_median), " and ", figure(error.normal_p99))};
    const std::vector<double> work = setting.work();
    for (std::size_t c = 0; c < work.size(); ++c) cells.push_back(figure(work[c] / counters()[c].unit));
    table.row(cells);
  }
  return table.html();
}

// The camera in which the cheapest and the finest value differ most.
std::size_t most_telling_camera(const KnobTrade& trade, const TradeReport& report) {
  const auto& cheapest = report.settings[trade.settings.front()].sightings;
  const auto& finest = report.settings[trade.settings.back()].sightings;
  std::size_t best = 0;
  const auto gain = [&](std::size_t c) { return cheapest[c].error.flip - finest[c].error.flip; };
  for (std::size_t c = 1; c < cheapest.size(); ++c) {
    if (gain(c) > gain(best)) best = c;
  }
  return best;
}

std::string pictures_of(const KnobTrade& trade, const TradeReport& report) {
  const std::size_t camera = most_telling_camera(trade, report);
  std::string html = text_of("<p>Where it shows most: ", escaped(report.cameras[camera].camera.what),
                             ".</p>\n<div class=\"row\" tabindex=\"0\">\n");
  for (std::size_t i = 0; i < trade.values.size(); ++i) {
    const Sighting& sighting = report.settings[trade.settings[i]].sightings[camera];
    html += text_of("<figure>", picture_html(sighting.picture, "drawn"), picture_html(sighting.errors, "its errors"),
                    "<figcaption>", value_in_words(*trade.knob, trade.values[i]), ": ", decibels(sighting.error.psnr()),
                    "</figcaption></figure>\n");
  }
  return html + "</div>\n";
}

}  // namespace

std::string knobs_html(const TradeReport& report) {
  if (report.knobs.empty()) return {};
  std::string html = "<h2>One knob at a time</h2>\n<p>All others as the scene has them.</p>\n";
  for (const KnobTrade& trade : report.knobs) {
    html += text_of("<h3>", trade.knob->path, "</h3>\n<p>", escaped(parameter_of(*trade.knob).help), ".</p>\n",
                    table_of(trade, report), pictures_of(trade, report));
  }
  return html;
}

}  // namespace terrella
