#include "native/measure_extremes.hpp"

#include <chrono>

#include "base/text.hpp"
#include "gl/caps.hpp"
#include "measure/report.hpp"
#include "native/egl_context.hpp"
#include "native/measuring.hpp"
#include "native/progress_bar.hpp"

namespace terrella {
namespace {

// Adds what is found in one kind of context; returns what went wrong, or nothing.
std::string measure_in(Api api, ExtremesReport& report) {
  const auto context = EglContext::make(api);
  if (!context) return context.sentence();
  if (std::string failure = beyond_this_machine(); !failure.empty()) return failure;
  const char* const name = api == Api::core ? "core" : "es";
  report.renderer = gl::renderer_name();
  Renderer renderer;
  examine_all(
      renderer, name, report.extent, [&](double part) { show_progress(name, part); }, report);
  if (api == Api::core) {
    show_progress("where techniques hold", 0.0);
    report.limits = measure_limits(renderer, report.extent);
    report.invariances = measure_invariances(renderer, report.extent);
    show_progress("where techniques hold", 1.0);
  }
  return {};
}

}  // namespace

std::string measure_extremes(const std::string& folder, bool quick) {
  const auto start = std::chrono::steady_clock::now();
  std::string failure = make_folder(folder);  // before minutes of work
  ExtremesReport report;
  report.extent = quick ? Extent::quick : Extent::full;
  for (const Api api : {Api::core, Api::es}) {
    if (failure.empty()) failure = measure_in(api, report);
  }
  if (!failure.empty()) return failure;
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  failure = write_files(folder, {{"report.json", extremes_json(report)}, {"index.html", extremes_page(report)}});
  if (failure.empty() && !report.holds())
    failure = text_of("Not all holds at the extremes; ", folder, "/index.html tells what.");
  return failure;
}

}  // namespace terrella
