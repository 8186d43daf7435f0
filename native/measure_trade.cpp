#include "native/measure_trade.hpp"

#include <algorithm>
#include <cstdio>

#include "base/text.hpp"
#include "gl/caps.hpp"
#include "measure/trade_json.hpp"
#include "measure/trade_page.hpp"
#include "measure/trade_path.hpp"
#include "native/measuring.hpp"
#include "native/progress_bar.hpp"

namespace terrella {
namespace {

// Why this machine cannot measure pictures of this size, or nothing.
std::string too_large(const TradePlan& plan) {
  const double most = find_parameter("quality.resolution_scale")->max;
  if (std::max(plan.width, plan.height) * most <= gl::caps().max_texture) return {};
  return text_of("This machine measures pictures of at most ", static_cast<int>(gl::caps().max_texture / most),
                 " pixels along a side.");
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
  if (failure = beyond_this_machine(); !failure.empty()) return failure;
  if (failure = too_large(task.plan); !failure.empty()) return failure;
  const TradeReport report = measure_trade(task.document, task.plan, show_progress);
  const std::string json = trade_json(report);
  std::optional<Comparison> comparison;
  if (task.before) comparison = compare(*task.before, *read_trade(json));
  std::vector<NamedText> files = {{"report.json", json}, {"index.html", trade_page(report, comparison)}};
  files.push_back({"table.md", path_table(report)});
  if (!task.plan.path_only) files.push_back({"path.inc", path_inc(report)});
  failure = write_files(task.folder, files);
  if (!failure.empty() || !comparison) return failure;
  tell(*comparison, task.against);
  if (comparison->worse.empty()) return {};
  return text_of(comparison->worse.size(), " times something became slower or less accurate than in ", task.against,
                 ".");
}

}  // namespace terrella
