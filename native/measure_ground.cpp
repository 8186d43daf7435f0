#include "native/measure_ground.hpp"

#include <cstdio>
#include <memory>

#include "base/text.hpp"
#include "measure/ground_limits.hpp"
#include "measure/ground_report.hpp"
#include "native/measuring.hpp"
#include "native/progress_bar.hpp"

namespace terrella {

std::string measure_ground(const GroundTask& task) {
  std::string failure = make_folder(task.folder);  // before minutes of work
  if (!failure.empty()) return failure;
  std::unique_ptr<EglContext> context;
  if (task.plan.frames > 0 || task.plan.flown > 0) {
    auto made = EglContext::make(task.api);
    if (!made) return made.sentence();
    context = std::move(*made);
    if (failure = beyond_this_machine(); !failure.empty()) return failure;
  }
  const GroundTable table = measure_grounds(task.documents, task.plan, show_progress);
  const std::string text = ground_markdown(table);
  std::printf("%s", text.c_str());
  failure = write_files(task.folder,
                        {{"report.json", ground_json(table)}, {"index.html", ground_page(table)}, {"table.md", text}});
  const std::vector<std::string> broken = broken_limits(table);
  for (const std::string& sentence : broken) std::printf("%s\n", sentence.c_str());
  if (failure.empty() && !broken.empty())
    failure = text_of("Limits of a ground of real size are broken ", broken.size(), " times.");
  return failure;
}

}  // namespace terrella
