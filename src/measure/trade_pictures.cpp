#include "measure/trade_pictures.hpp"

#include "base/text.hpp"
#include "measure/base64.hpp"
#include "measure/html.hpp"
#include "measure/thumbnail.hpp"
#include "measure/words.hpp"

namespace terrella {

std::string picture_html(const Image& image, const std::string& what) {
  const std::string png = encode_png(image.channels == 1 ? heat(image, brightest_error) : image);
  return text_of("<img width=\"", image.width, "\" height=\"", image.height, "\" alt=\"", escaped(what),
                 "\" src=\"data:image/png;base64,", base64(png), "\">");
}

std::string truths_html(const TradeReport& report) {
  std::string html = "<div class=\"views\">\n";
  for (const CameraTruth& truth : report.cameras) {
    html += text_of("<figure>", picture_html(truth.picture, truth.camera.what), "<figcaption>",
                    escaped(truth.camera.what), "; ", truth.samples, " samples a pixel, known within ",
                    decibels(truth.self_psnr), "</figcaption></figure>\n");
  }
  return html + "</div>\n";
}

std::string sightings_html(const TradeReport& report, const Setting& setting, const std::vector<std::size_t>& cameras) {
  std::string html;
  for (const std::size_t c : cameras) {
    const Sighting& sighting = setting.sightings[c];
    const std::string& what = report.cameras[c].camera.what;
    html += text_of("<figure>", picture_html(sighting.picture, what), picture_html(sighting.errors, "errors of it"),
                    "<figcaption>", escaped(report.cameras[c].camera.name), ": ", decibels(sighting.error.psnr()),
                    "</figcaption></figure>\n");
  }
  return html;
}

std::string heat_scale_html() {
  constexpr int width = 200, height = 12;
  Image scale(width, height, 1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) *scale.at(x, y) = static_cast<float>(brightest_error * x / (width - 1));
  }
  return text_of("<p class=\"scale\">Error maps: 0 ", picture_html(scale, "from black over red to pale yellow"), ' ',
                 figure(brightest_error), " of FLIP and above</p>\n");
}

}  // namespace terrella
