#include "measure/trade_page.hpp"

#include <algorithm>
#include <numeric>

#include "base/text.hpp"
#include "measure/html.hpp"
#include "measure/moment.hpp"
#include "measure/trade_chart.hpp"
#include "measure/trade_effects.hpp"
#include "measure/trade_knobs.hpp"
#include "measure/trade_pictures.hpp"
#include "measure/words.hpp"
#include "scene/json.hpp"
#include "scene/quality_path.hpp"

namespace terrella {
namespace {

constexpr std::string_view styles = R"(
svg { display: block; width: 100%; height: auto; margin: .5rem 0; }
svg text { font: 13px system-ui, sans-serif; fill: var(--ink); }
svg .tick, svg .axis { font-size: 12px; fill: var(--soft); }
svg .name { font-weight: 650; }
svg text.name, svg text.label { paint-order: stroke; stroke: var(--page); stroke-width: 4px; }
svg .grid { stroke: var(--line); }
svg .tried { fill: var(--faint); opacity: .35; }
svg .single { fill: var(--faint); opacity: .8; }
svg polyline.front { fill: none; stroke: var(--accent); stroke-width: 2; }
svg circle.front { fill: var(--accent); }
svg .preset { fill: var(--mark); }
svg .own { fill: var(--page); stroke: var(--ink); stroke-width: 2; }
svg.narrow, .narrow svg { display: none; }
img { display: block; max-width: 100%; height: auto; image-rendering: auto; }
figure { margin: 0; }
figure img + img { margin-top: 2px; }
figcaption { font-size: .8rem; color: var(--soft); padding: .15rem 0 .4rem; }
.views { display: grid; grid-template-columns: repeat(3, minmax(0, 15rem)); gap: .6rem; margin: .4rem 0 1rem; }
.row { display: flex; gap: .6rem; overflow-x: auto; margin: .4rem 0 1rem; }
.row figure { flex: 0 0 auto; width: 10rem; }
.step { font-weight: 600; margin: 1.2rem 0 .2rem; }
.step span { font-weight: 400; color: var(--soft); }
.scale img { display: inline; vertical-align: middle; border: 1px solid var(--line); }
.wide td, .wide th { white-space: nowrap; }
.presets td:last-child, .presets th:last-child { white-space: normal; min-width: 16rem; }
.bars { display: grid; grid-template-columns: minmax(8rem, 13rem) minmax(0, 1fr) minmax(0, 1fr); gap: .35rem .9rem; align-items: center;
  font-size: .9rem; margin: .6rem 0 1rem; }
.bars .head { color: var(--soft); font-size: .8rem; }
.bar { position: relative; background: var(--panel); min-height: 1.5rem; line-height: 1.5rem; }
.bar i { position: absolute; inset: 0 auto 0 0; background: var(--accent); opacity: .45; }
.bar.gain i { background: var(--mark); }
.bar b { position: relative; font-weight: 400; padding: 0 .4rem; font-variant-numeric: tabular-nums; white-space: nowrap; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .15rem 1rem; font-size: .9rem; }
dt { color: var(--soft); }
dd { margin: 0; overflow-wrap: anywhere; }
.good { color: var(--soft); }
@media (max-width: 40rem) {
  body { margin: 1rem auto; }
  .wide-chart { display: none; }
  .narrow svg { display: block; }
  .bars { grid-template-columns: minmax(0, 1fr) minmax(0, 1fr); gap: .2rem .5rem; }
  .bar b { white-space: normal; padding: 0 .2rem; font-size: .8rem; }
  .bars .what { grid-column: 1 / -1; margin-top: .5rem; font-weight: 600; }
  .bars .head:first-child { display: none; }
  .views { gap: .3rem; }
  dl { grid-template-columns: 1fr; }
  dd { margin-bottom: .4rem; }
}
@media print {
  .wide-chart { display: block; }
  .narrow svg { display: none; }
  .wide td, .wide th { white-space: normal; }
  .row { flex-wrap: wrap; overflow: visible; }
  .row figure { width: 4.1cm; }
  .bar, img, svg { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  .bars > * , .step { break-inside: avoid; }
  .step { break-after: avoid; }
}
)";

std::string paragraph(const std::string& html) { return "<p>" + html + "</p>\n"; }

std::string summary(const TradeReport& report) {
  const Setting& own = report.settings[report.own];
  const Setting& cheapest = report.settings[report.front.front()];
  const Setting& finest = report.settings[report.front.back()];
  const auto told = [](const Setting& setting) {
    return text_of(figure(setting.ms().median), " ms for ", decibels(setting.error().psnr()));
  };
  return paragraph(
      text_of("What does a more accurate picture cost? ", report.settings.size(),
              " settings of the knobs of quality were drawn by ", escaped(report.machine.renderer), ", from ",
              report.cameras.size(), " cameras, at ", report.plan.width, "×", report.plan.height,
              " pixels, timed by turns, and compared with the same scene traced by rays in double precision. "
              "As the scene has them, a frame takes ",
              told(own), "; what can be bought reaches from ", told(cheapest), " to ", told(finest), "."));
}

std::string comparison_html(const Comparison& comparison) {
  std::string html =
      "<h2>Beside the older report</h2>\n" +
      paragraph(text_of(comparison.compared, " settings are in both. ", escaped(comparison.about_times)));
  if (comparison.worse.empty()) html += paragraph("Nothing became slower or less accurate.");
  Table table({"what changed"});
  for (const std::string& sentence : comparison.worse) table.row({sentence}, "wrong");
  for (const std::string& sentence : comparison.better) table.row({sentence});
  return comparison.worse.empty() && comparison.better.empty() ? html : html + table.html();
}

std::string chart_html(const TradeReport& report) {
  return text_of(
      "<h2>Time against accuracy</h2>\n",
      paragraph("Up is nearer to the truth, left is faster. The line joins the settings that nothing beats in both. "
                "Ringed: the scene's own. Grey: settings off the line; small and pale: those that were only tried, by "
                "a few frames."),
      "<div class=\"wide-chart\">", trade_chart(report, 860.0, 460.0), "</div><div class=\"narrow\">",
      trade_chart(report, 340.0, 360.0), "</div>\n");
}

std::string presets_html(const TradeReport& report) {
  Table table({"preset", "ms", "PSNR, dB", "FLIP", "visibly off", "asked for", "settings, beside the scene's"});
  for (const QualityPreset& preset : report.presets) {
    const Setting& setting = report.settings[preset.setting];
    const PictureError error = setting.error();
    const std::string asked = preset.target == 0.0 ? "the finest"
                              : preset.reached     ? text_of(figure(preset.target), " dB")
                                                   : text_of(figure(preset.target), " dB, which none reaches");
    table.row({preset.name, with_spread(setting.ms()), figure(error.psnr()), figure(error.flip), percent(error.visible),
               asked, setting_in_words(setting, report.document.scene)});
  }
  return "<h2>Presets</h2>\n" +
         paragraph(
             "Each is at least 1.6 times as fast as the next; one for which there is no room is left out. Where "
             "nothing reaches what a preset is to reach, it is the most accurate there is room for.") +
         "<div class=\"presets\">" + table.html() + "</div>\n";
}

std::string steps_html(const TradeReport& report) {
  if (report.steps.empty()) return {};
  Table table({"step", "ms", "PSNR, dB", "FLIP", "visibly off", "settings, beside the scene's"});
  for (std::size_t i = 0; i < report.steps.size(); ++i) {
    const Setting& setting = report.settings[report.steps[i]];
    const PictureError error = setting.error();
    table.row({text_of(i + 1, ' ', quality_path()[i].preset), with_spread(setting.ms()), figure(error.psnr()),
               figure(error.flip), percent(error.visible), setting_in_words(setting, report.document.scene)});
  }
  return "<h2>The program's steps</h2>\n" +
         paragraph("What it walks along to hold quality.target_ms, drawn with this scene.") +
         "<div class=\"presets\">" + table.html() + "</div>\n";
}

std::string path_html(const TradeReport& report) {
  std::string html = "<h2>The way from fast to accurate</h2>\n" +
                     paragraph("The line above, step by step, with steps of less than a tenth of the time left out.") +
                     heat_scale_html();
  std::vector<std::size_t> all(report.cameras.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const Scene* before = nullptr;
  for (const std::size_t i : report.path) {
    const Setting& setting = report.settings[i];
    const std::string what =
        before == nullptr ? setting_in_words(setting, report.document.scene) : changes(*before, setting.scene);
    html += text_of("<div class=\"step\">", figure(setting.ms().median), " ms, ", decibels(setting.error().psnr()),
                    " <span>", escaped(what), "</span></div>\n<div class=\"views\">\n",
                    sightings_html(report, setting, all), "</div>\n");
    before = &setting.scene;
  }
  return html;
}

std::string fact(const std::string& name, const std::string& value) {
  return text_of("<dt>", name, "</dt><dd>", escaped(value), "</dd>\n");
}

std::string machine_html(const TradeReport& report) {
  const Machine& machine = report.machine;
  return text_of(
      "<h2>Where and how</h2>\n<dl>\n", fact("Renderer", machine.renderer), fact("OpenGL", machine.gl_version),
      fact("Processor", text_of(machine.cpu, ", ", machine.cores, " cores")),
      fact("Times", machine.gpu_timer ? "by the GPU's own clock" : "from the call until the picture is there"),
      fact("Work that never changes", with_spread(machine.control_ms) + " ms"), fact("Scene", to_json(report.document)),
      fact("Pictures are judged", text_of(figure(judged_at(report.document.scene)),
                                          " s after the scene began: where clouds are blended at every setting")),
      fact("All of it took", text_of(figure(report.seconds), " s, ", report.plan.rounds, " rounds")), "</dl>\n",
      "<h2>What the columns say</h2>\n<dl>\n",
      fact("ms",
           "Median time of a frame, mean over the cameras; in brackets the 10th and 90th of a hundred. Each round "
           "draws every setting."),
      fact("PSNR", "Of the mean square error of the finished sRGB picture, over all cameras."),
      fact("FLIP",
           "Mean difference as seen by someone who flips between picture and truth, 0 to 1 (Andersson et al. "
           "2020)."),
      fact("visibly off",
           "Pixels more than 2.3 from the truth in CIE L*a*b*, a difference one just sees (Mahy et al. "
           "1994)."),
      fact("outline",
           "Pixels by which planet's edge is off: what only one of both shows as planet, by the edge's "
           "length."),
      fact("normals",
           "Degrees between the surface's normals and the true ones: half of the pixels are below the first "
           "number, 99 of a hundred below the second."),
      "</dl>\n");
}

}  // namespace

std::string trade_page(const TradeReport& report, const std::optional<Comparison>& comparison) {
  std::string body = "<h1>What accuracy costs</h1>\n" + summary(report);
  if (comparison) body += comparison_html(*comparison);
  body += chart_html(report) + presets_html(report) + steps_html(report);
  body += "<h2>What was looked at</h2>\n" +
          paragraph("The truth: the reference, with as many samples a pixel as it takes to know it that well.") +
          truths_html(report);
  body += effects_html(report) + path_html(report) + knobs_html(report) + machine_html(report);
  return html_page("Terrella: what accuracy costs", styles, body);
}

}  // namespace terrella
