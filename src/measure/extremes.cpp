#include "measure/extremes.hpp"

#include <algorithm>

#include "scene/link.hpp"

namespace terrella {
namespace {

GroupTally& tally_of(ExtremesReport& report, const std::string& api, const std::string& group) {
  for (GroupTally& tally : report.groups) {
    if (tally.api == api && tally.group == group) return tally;
  }
  report.groups.push_back({api, group, 0, 0, 0, 0, 0.0, 0.0});
  return report.groups.back();
}

Fault fault_of(const Case& entry, const std::string& api, const Findings& found) {
  SceneDocument document;
  document.scene = entry.scene;
  return {
      api,         entry.group, entry.name, to_link(document), entry.view.width, entry.view.height, entry.view.seconds,
      found.text()};
}

}  // namespace

bool ExtremesReport::holds() const {
  return faults.empty() &&
         std::all_of(limits.begin(), limits.end(), [](const Limit& limit) { return limit.keeps_its_word(); }) &&
         std::all_of(invariances.begin(), invariances.end(), [](const Invariance& found) { return found.holds(); });
}

void examine_all(Renderer& renderer, const std::string& api, Extent extent, const Progress& progress,
                 ExtremesReport& report) {
  const std::vector<Case> cases = extreme_cases(extent);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Findings found = examine(renderer, cases[i], compared_with_reference(i));
    GroupTally& tally = tally_of(report, api, cases[i].group);
    ++tally.cases;
    tally.hidden += found.holes.looked_at;
    if (found.reference) {
      ++tally.compared;
      tally.off = std::max(tally.off, found.reference->light);
    }
    tally.milliseconds += found.milliseconds;
    if (!found.clean()) {
      ++tally.faulty;
      report.faults.push_back(fault_of(cases[i], api, found));
    }
    if (progress) progress(static_cast<double>(i + 1) / static_cast<double>(cases.size()));
  }
}

}  // namespace terrella
