#include "measure/report.hpp"

#include <cmath>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "measure/html.hpp"

namespace terrella {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Extent extent) {
  return extent == Extent::full ? "full" : extent == Extent::quick ? "quick" : "sample";
}

// Where the program first says that the range is left: the warned value that lies next to one that is not. None: it
// holds all along.
const LimitPoint* first_beyond(const Limit& limit) {
  for (std::size_t i = 0; i < limit.points.size(); ++i) {
    const LimitPoint& point = limit.points[i];
    const bool beside_a_good_one =
        (i > 0 && !limit.points[i - 1].warned) || (i + 1 < limit.points.size() && !limit.points[i + 1].warned);
    if (point.warned && beside_a_good_one) return &point;
  }
  return nullptr;
}

std::string short_number(double value) { return std::isinf(value) ? "lost" : printed_number(value, 3); }

// The class of a row that tells of something wrong.
std::string_view marked(bool wrong) { return wrong ? "wrong" : ""; }

std::string faults_html(const ExtremesReport& report) {
  if (report.faults.empty()) return "<p>None.</p>\n";
  Table table({"context", "case", "what is wrong", "scene, size and time"});
  for (const Fault& fault : report.faults) {
    table.row({fault.api, fault.group + ": " + fault.name, fault.text,
               text_of(fault.link, " --size ", fault.width, "x", fault.height, " --time ", fault.seconds)},
              marked(true));
  }
  return table.html();
}

std::string groups_html(const ExtremesReport& report) {
  Table table({"context", "group", "cases", "faulty", "pixels looked at for holes", "beside the reference",
               "light off by at most", "seconds"});
  for (const GroupTally& g : report.groups) {
    table.row({g.api, g.group, text_of(g.cases), text_of(g.faulty), text_of(g.hidden), text_of(g.compared),
               short_number(g.off), short_number(1e-3 * g.milliseconds)},
              marked(g.faulty > 0));
  }
  return table.html();
}

std::string points_of(const Limit& limit) {
  std::string text;
  for (const LimitPoint& point : limit.points) {
    text += text_of(text.empty() ? "" : ", ", point.value, point.warned ? "*" : "", ": ", short_number(point.error));
  }
  return text;
}

std::string limits_html(const ExtremesReport& report) {
  Table table({"technique", "along", "error", "demand", "worst within", "leaves its range", "value: error"});
  for (const Limit& limit : report.limits) {
    const LimitPoint* beyond = first_beyond(limit);
    table.row({limit.technique, text_of(limit.path, ", ", limit.unit), limit.error, short_number(limit.demand),
               short_number(limit.worst_within()), beyond == nullptr ? "nowhere" : "at " + format_number(beyond->value),
               points_of(limit)},
              marked(!limit.keeps_its_word()));
  }
  return table.html();
}

std::string invariances_html(const ExtremesReport& report) {
  Table table({"what", "measured", "number", "at most", "of what could differ"});
  for (const Invariance& found : report.invariances) {
    table.row({found.what, found.error, short_number(found.measured), short_number(found.bound),
               short_number(found.at_stake)},
              marked(!found.holds()));
  }
  return table.html();
}

// In narrow windows a row is a list, each cell after its head.
constexpr const char* styles = R"(
td { overflow-wrap: anywhere; }
@media (max-width: 50rem) {
  thead { display: none; }
  tr { display: block; padding: .4rem 0; border-bottom: 1px solid var(--line); }
  td { display: grid; grid-template-columns: 9rem 1fr; padding: .1rem 0; border: 0; }
  td::before { content: attr(data-head); color: var(--soft); }
}
)";

}  // namespace

std::string extremes_json(const ExtremesReport& report) {
  Json json;
  json["renderer"] = report.renderer;
  json["extent"] = name_of(report.extent);
  json["seconds"] = report.seconds;
  json["holds"] = report.holds();
  json["groups"] = Json::array();
  for (const GroupTally& g : report.groups) {
    json["groups"].push_back({{"context", g.api},
                              {"group", g.group},
                              {"cases", g.cases},
                              {"faulty", g.faulty},
                              {"hidden_pixels", g.hidden},
                              {"compared", g.compared},
                              {"light_off", g.off},
                              {"milliseconds", g.milliseconds}});
  }
  json["faults"] = Json::array();
  for (const Fault& f : report.faults) {
    json["faults"].push_back({{"context", f.api},
                              {"group", f.group},
                              {"name", f.name},
                              {"link", f.link},
                              {"size", {f.width, f.height}},
                              {"time", f.seconds},
                              {"what", f.text}});
  }
  json["limits"] = Json::array();
  for (const Limit& limit : report.limits) {
    Json points = Json::array();
    for (const LimitPoint& p : limit.points)
      points.push_back({{"value", p.value}, {"error", p.error}, {"warned", p.warned}});
    json["limits"].push_back({{"technique", limit.technique},
                              {"path", limit.path},
                              {"unit", limit.unit},
                              {"error", limit.error},
                              {"demand", limit.demand},
                              {"worst_within", limit.worst_within()},
                              {"holds", limit.keeps_its_word()},
                              {"points", points}});
  }
  json["invariances"] = Json::array();
  for (const Invariance& i : report.invariances) {
    json["invariances"].push_back({{"what", i.what},
                                   {"error", i.error},
                                   {"measured", i.measured},
                                   {"bound", i.bound},
                                   {"at_stake", i.at_stake},
                                   {"holds", i.holds()}});
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string extremes_page(const ExtremesReport& report) {
  std::string page = text_of("<h1>Terrella at the extremes</h1>\n<p>Drawn by ", escaped(report.renderer), ", extent ",
                             name_of(report.extent), ", in ", short_number(report.seconds),
                             " s: ", report.holds() ? "all holds" : "<strong>not all holds</strong>", ".</p>\n");
  page += "<h2>Faults</h2>\n" + faults_html(report);
  page +=
      "<h2>Where techniques hold</h2>\n<p>The error of a technique along one parameter. A star marks values of which "
      "the program says that its range was left; everywhere else the error is at most what is demanded.</p>\n" +
      limits_html(report);
  page += "<h2>What changes no picture</h2>\n" + invariances_html(report);
  page +=
      "<h2>Cases</h2>\n<p>Each is drawn four times; every pixel must be finite, the planet without a hole, normals of "
      "unit length, OpenGL without an error, the picture the same when drawn again, and the work within what the needs "
      "promise. One in seven is drawn with finer meshes and maps and compared with the reference, at 48 places, where "
      "the "
      "techniques are in their range.</p>\n" +
      groups_html(report);
  return html_page("Terrella at the extremes", styles, page);
}

}  // namespace terrella
