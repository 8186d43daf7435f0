#include "measure/trade_chart.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/text.hpp"
#include "measure/image_error.hpp"
#include "measure/words.hpp"

namespace terrella {
namespace {

struct Point {
  double ms, psnr;
};

Point point_of(const Offer& offer) { return {offer.ms, psnr_of(offer.mean_square)}; }

// From values to places along an axis.
class Axis {
 public:
  Axis(double low, double high, double begin, double end, bool logarithmic)
      : low_(low), high_(high), begin_(begin), end_(end), logarithmic_(logarithmic) {}

  [[nodiscard]] double at(double value) const {
    const double part =
        logarithmic_ ? std::log(value / low_) / std::log(high_ / low_) : (value - low_) / (high_ - low_);
    return std::lerp(begin_, end_, part);
  }

  // Round values, at most about so many.
  [[nodiscard]] std::vector<double> ticks(double most) const { return logarithmic_ ? decades(most) : steps(most); }

 private:
  [[nodiscard]] std::vector<double> decades(double most) const {
    const bool all = std::log10(high_ / low_) * 3.0 <= most;
    std::vector<double> values;
    for (double decade = std::pow(10.0, std::floor(std::log10(low_))); decade <= high_; decade *= 10.0) {
      for (const double factor : {1.0, 2.0, 5.0}) {
        const double value = decade * factor;
        if ((all || factor == 1.0) && value >= low_ * 0.999 && value <= high_ * 1.001) values.push_back(value);
      }
    }
    return values;
  }
  [[nodiscard]] std::vector<double> steps(double most) const {
    const double rough = (high_ - low_) / most, decade = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10.0 * decade;
    for (const double factor : {5.0, 2.0, 1.0}) {
      if (factor * decade >= rough) step = factor * decade;
    }
    std::vector<double> values;
    for (double value = std::ceil(low_ / step) * step; value <= high_ * (1.0 + 1e-9); value += step)
      values.push_back(value);
    return values;
  }

  double low_, high_, begin_, end_;
  bool logarithmic_;
};

std::string place(double value) { return printed_number(std::round(10.0 * value) / 10.0, 5); }

std::string text_at(double x, double y, const char* anchor, const std::string& text, const char* css = "label") {
  return text_of("<text class=\"", css, "\" x=\"", place(x), "\" y=\"", place(y), "\" text-anchor=\"", anchor, "\">",
                 text, "</text>\n");
}

std::string line(double x1, double y1, double x2, double y2) {
  return text_of("<line class=\"grid\" x1=\"", place(x1), "\" y1=\"", place(y1), "\" x2=\"", place(x2), "\" y2=\"",
                 place(y2), "\"/>\n");
}

class Chart {
 public:
  Chart(const TradeReport& report, double width, double height) : report_(report), width_(width), height_(height) {
    for (const Setting& setting : report.settings) points_.push_back(point_of(setting.offer()));
    for (const Estimate& estimate : report.estimates) tried_.push_back(point_of(estimate.offer));
  }

  std::string svg() {
    const Axis x = x_axis(), y = y_axis();
    return text_of("<svg viewBox=\"0 0 ", place(width_), ' ', place(height_),
                   "\" role=\"img\" aria-label=\"Milliseconds a frame against decibels of accuracy\">\n", grid(x, y),
                   dots(tried_, x, y, 1.8, "tried"), dots(points_, x, y, 3.0, "single"), front(x, y), names(x, y),
                   "</svg>\n");
  }

 private:
  static constexpr double left = 46.0, right = 14.0, above = 16.0, below = 44.0;  // of the plot
  static constexpr double air = 1.12;                                             // beside the outermost points

  [[nodiscard]] Axis x_axis() const {
    double low = points_.front().ms, high = low;
    for (const auto* points : {&points_, &tried_}) {
      for (const Point& p : *points) low = std::min(low, p.ms), high = std::max(high, p.ms);
    }
    return {std::max(low, 1e-6) / air, std::max(high, 2e-6) * air, left, width_ - right, true};
  }

  // Equal pictures, of 200 dB, are drawn at the upper edge.
  [[nodiscard]] Axis y_axis() const {
    double low = 100.0, high = 0.0;
    for (const auto* points : {&points_, &tried_}) {
      for (const Point& p : *points) low = std::min(low, p.psnr), high = std::max(high, std::min(p.psnr, 100.0));
    }
    return {std::floor(low - 0.5), std::ceil(high + 0.7), height_ - below, above, false};
  }

  [[nodiscard]] std::string grid(const Axis& x, const Axis& y) const {
    std::string svg;
    const double bottom = height_ - below;
    for (const double ms : x.ticks(width_ / 70.0)) {
      svg += line(x.at(ms), above, x.at(ms), bottom) + text_at(x.at(ms), bottom + 17.0, "middle", figure(ms), "tick");
    }
    for (const double db : y.ticks(height_ / 50.0)) {
      svg += line(left, y.at(db), width_ - right, y.at(db)) +
             text_at(left - 6.0, y.at(db) + 4.0, "end", figure(db), "tick");
    }
    svg += text_at(0.5 * (left + width_ - right), height_ - 6.0, "middle", "milliseconds a frame", "axis");
    return svg + text_at(4.0, above - 4.0, "start", "dB", "axis");
  }

  [[nodiscard]] std::string dot(const Point& point, const Axis& x, const Axis& y, double radius,
                                const char* css) const {
    return text_of("<circle class=\"", css, "\" cx=\"", place(x.at(point.ms)), "\" cy=\"",
                   place(std::max(above, y.at(point.psnr))), "\" r=\"", place(radius), "\"");
  }

  [[nodiscard]] std::string dots(const std::vector<Point>& points, const Axis& x, const Axis& y, double radius,
                                 const char* css) const {
    std::string svg;
    for (const Point& point : points) svg += dot(point, x, y, radius, css) + "/>\n";
    return svg;
  }

  [[nodiscard]] std::string front(const Axis& x, const Axis& y) const {
    std::string places, marks;
    for (const std::size_t i : report_.front) {
      places += text_of(places.empty() ? "" : " ", place(x.at(points_[i].ms)), ',',
                        place(std::max(above, y.at(points_[i].psnr))));
      marks += text_of(dot(points_[i], x, y, 3.5, "front"), "><title>", figure(points_[i].ms), " ms, ",
                       decibels(points_[i].psnr), ": ", setting_in_words(report_.settings[i], report_.document.scene),
                       "</title></circle>\n");
    }
    return text_of("<polyline class=\"front\" points=\"", places, "\"/>\n", marks);
  }

  // Below and to the right of a point lies only what it dominates.
  [[nodiscard]] std::string names(const Axis& x, const Axis& y) const {
    std::string svg = dot(points_[report_.own], x, y, 6.0, "own") + "/>\n";
    bool named = false;
    for (const QualityPreset& preset : report_.presets) {
      named = named || preset.setting == report_.own;
      svg += dot(points_[preset.setting], x, y, 6.0, "preset") + "/>\n" +
             name(points_[preset.setting], x, y, preset.name, "name");
    }
    return named ? svg : svg + name(points_[report_.own], x, y, "the scene's own", "label");
  }

  [[nodiscard]] std::string name(const Point& point, const Axis& x, const Axis& y, const std::string& text,
                                 const char* css) const {
    const double at = x.at(point.ms), letter = 7.0;
    const bool fits = at + 10.0 + letter * static_cast<double>(text.size()) < width_;
    return text_at(fits ? at + 9.0 : at - 9.0, y.at(point.psnr) + (fits ? 15.0 : -9.0), fits ? "start" : "end", text,
                   css);
  }

  const TradeReport& report_;
  double width_, height_;
  std::vector<Point> points_, tried_;
};

}  // namespace

std::string trade_chart(const TradeReport& report, double width, double height) {
  return Chart(report, width, height).svg();
}

}  // namespace terrella
