#include "native/measure_trade.hpp"

#include <algorithm>
#include <cstdio>

#include "base/text.hpp"
#include "gl/caps.hpp"
#include "measure/trade_json.hpp"
#include "measure/trade_page.hpp"
#include "native/measure_folder.hpp"
#include "native/progress_bar.hpp"

namespace terrella {
namespace {

// Why this machine cannot measure this, or nothing.
std::string beyond_this_machine(const TradeTask& task) {
  if (!gl::caps().full_float_targets)
    return "This machine's OpenGL cannot draw to 32 bit floats, which measuring needs.";
  const double most = find_parameter("quality.resolution_scale")->max;
  if (std::max(task.plan.width, task.plan.height) * most > gl::caps().max_texture)
    return text_of("This machine measures pictures of at most ", static_cast<int>(gl::caps().max_texture / most),
                   " pixels along a side.");
  return {};
}

// On standard output.
void tell(const Comparison& comparison, const std::string& against) {
  std::printf("Beside %s, of whose settings %d were measured again:\n%s\n", against.c_str(), comparison.compared,
              comparison.about_times.c_str());
  for (const auto* sentences : {&comparison.worse, &comparison.better}) {
    for (const std::string& sentence : *sentences) std::printf("%s\n", sentence.c_str());
  }
  if (comparison.worse.empty()) std::printf("Nothing became slower or less accurate.\n");
}

}  // namespace

std::string measure_trade(const TradeTask& task) {
  std::string failure = make_folder(task.folder);  // before minutes of work
  if (!failure.empty()) return failure;
  const auto context = EglContext::make(task.api);
  if (!context) return context.sentence();
  if (failure = beyond_this_machine(task); !failure.empty()) return failure;
  const TradeReport report = measure_trade(task.document, task.plan, show_progress);
  const std::string json = trade_json(report);
  std::optional<Comparison> comparison;
  if (task.before) comparison = compare(*task.before, *read_trade(json));
  failure = write_report(task.folder, json, trade_page(report, comparison));
  if (!failure.empty() || !comparison) return failure;
  tell(*comparison, task.against);
  if (comparison->worse.empty()) return {};
  return text_of(comparison->worse.size(), " times something became slower or less accurate than in ", task.against,
                 ".");
}

}  // namespace terrella
