#include "measure/ground_report.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "measure/ground_limits.hpp"
#include "measure/html.hpp"
#include "measure/words.hpp"

namespace terrella {
namespace {

using Json = nlohmann::ordered_json;
using Cells = std::vector<std::string>;

const Cells heads = {"scene",   "altitude, m", "model", "asked, px", "pixel_error", "median",    "p99",     "most",
                     "upright", "cells",       "split", "nodes",     "vertices",    "triangles", "skirts",  "seen",
                     "coarse",  "of sea",      "made",  "look ms",   "choose ms",   "make ms",   "frame ms"};

Cells cells_of(const GroundRow& row) {
  const GroundMeasured& m = row.measured;
  return {row.scene,
          figure(row.altitude),
          row.model,
          figure(row.target),
          figure(row.pixel_error),
          printed_number(m.seen.median, 2),
          printed_number(m.seen.p99, 3),
          printed_number(m.seen.most, 3),
          printed_number(m.upright.p99, 3),
          text_of(m.cells),
          figure(m.split),
          text_of(m.ground.nodes),
          text_of(m.ground.vertices),
          text_of(m.ground.triangles),
          text_of(m.ground.skirt_triangles),
          text_of(m.seen_triangles),
          text_of(m.coarse_triangles),
          text_of(m.sea.triangles + m.sea.skirt_triangles),
          text_of(m.made),
          printed_number(m.look_ms, 2),
          printed_number(m.choose_ms, 2),
          figure(m.make_ms),
          row.frame_ms ? figure(row.frame_ms->median) : "-"};
}

const Cells flight_heads = {"scene", "model",         "median ms",         "p90 ms",    "worst ms",
                            "at, m", "of the median", "longer than twice", "incomplete"};

Cells cells_of(const FlightRow& row) {
  return {row.scene,
          row.model,
          printed_number(row.median_ms, 2),
          printed_number(row.p90_ms, 2),
          printed_number(row.worst_ms, 2),
          figure(row.worst_at),
          printed_number(row.worst_ms / row.median_ms, 2),
          percent(row.longer),
          percent(row.incomplete)};
}

Json json_of(const FlightRow& row) {
  return {{"scene", row.scene},   {"model", row.model},          {"median_ms", row.median_ms},
          {"p90_ms", row.p90_ms}, {"worst_ms", row.worst_ms},    {"worst_at", row.worst_at},
          {"longer", row.longer}, {"incomplete", row.incomplete}};
}

Json json_of(const ErrorSpread& error) { return {{"median", error.median}, {"p99", error.p99}, {"most", error.most}}; }

Json json_of(const NodeCounts& counts) {
  return {{"nodes", counts.nodes},
          {"vertices", counts.vertices},
          {"triangles", counts.triangles},
          {"skirt_vertices", counts.skirt_vertices},
          {"skirt_triangles", counts.skirt_triangles}};
}

Json json_of(const GroundRow& row) {
  const GroundMeasured& m = row.measured;
  Json json = {{"scene", row.scene},
               {"model", row.model},
               {"altitude", row.altitude},
               {"target_px", row.target},
               {"pixel_error", row.pixel_error},
               {"cells", m.cells},
               {"split", m.split},
               {"places", m.places},
               {"error_px", json_of(m.seen)},
               {"upright_error_px", json_of(m.upright)},
               {"ground", json_of(m.ground)},
               {"sea", json_of(m.sea)},
               {"seen_triangles", m.seen_triangles},
               {"coarse_triangles", m.coarse_triangles},
               {"made", m.made},
               {"lacking", m.lacking},
               {"look_ms", m.look_ms},
               {"choose_ms", m.choose_ms},
               {"make_ms", m.make_ms},
               {"allocations", m.allocations}};
  if (row.frame_ms)
    json["frame_ms"] = {{"median", row.frame_ms->median}, {"p10", row.frame_ms->p10}, {"p90", row.frame_ms->p90}};
  return json;
}

std::string table_html(const GroundTable& table) {
  Table html(heads);
  for (const GroundRow& row : table.rows) html.row(cells_of(row), broken_by(row).empty() ? "" : "wrong");
  return html.html();
}

std::string markdown_of(const std::vector<Cells>& lines) {
  std::string text;
  for (const Cells& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      std::size_t width = 0;
      for (const Cells& other : lines) width = std::max(width, other[i].size());
      text += text_of(i == 0 ? "| " : " | ", line[i], std::string(width - line[i].size(), ' '));
    }
    text += " |\n";
  }
  return text;
}

std::string flights_html(const GroundTable& table) {
  Table html(flight_heads);
  for (const FlightRow& row : table.flights) html.row(cells_of(row), "");
  return html.html();
}

std::string limits_html(const GroundTable& table) {
  const std::vector<std::string> broken = broken_limits(table);
  if (broken.empty()) return "<p>All are kept.</p>\n";
  Table html({"what is broken"});
  for (const std::string& sentence : broken) html.row({sentence}, "wrong");
  return html.html();
}

constexpr const char* columns = R"(<h2>What the columns say</h2>
<p>Each view is drawn with the largest quality.pixel_error (column pixel_error), of at most 16, by which 99 of 100 places of the ground
are off by no more than is asked. Errors are measured in double precision at random places of the
picture: from where a pixel shows the ground for it to where the ground above or below is, or as far as ground that
triangles lack rises before it (median, p99, most), in pixels; upright is the p99 of how far triangles themselves are off, as if
across the line of sight, as it never quite is from above. Nodes, of so
many cells along a side and split in four within so many of their edges,
vertices and triangles are all that the GPU is given for the ground, skirts apart; seen are those of its triangles that
turn to the eye, lie in the picture and have neither sea nor planet nor nearer mountains before them, coarse those that have passed wholly to the shape of the
level above, which a quarter as many would show; the sea is drawn with triangles of its
own. Made are nodes, also coarser ones that are not drawn, from nothing within make ms. Of every frame, on one core: look
ms to measure how near the ground is, choose ms to choose, to leave out what is not seen, and to sort. Frame ms is that of
the whole picture, where frames were drawn.</p>
)";

constexpr const char* flight_columns = R"(<h2>What the columns say</h2>
<p>A flight of 20 s, 30 frames a second (3 if quick), from 10,000 km over another place to 10 m over the ground, three times: the least
time of each frame that the CPU takes to tell where the camera is, how near its ground, which nodes are drawn, and to make
those that it has time for; what the GPU does is left out. At is how high over the ground the worst frame is; longer than
twice, the part of the frames that take longer than twice the median; incomplete, the part that lacks nodes which the picture
asks for, and shows coarser ones.</p>
)";

constexpr const char* styles = ".wide td, .wide th { white-space: nowrap; }\nbody { max-width: 100rem; }\n";

}  // namespace

std::string ground_json(const GroundTable& table) {
  Json json;
  json["size"] = {table.plan.width, table.plan.height};
  json["renderer"] = table.renderer;
  json["seconds"] = table.seconds;
  json["broken"] = broken_limits(table);
  json["rows"] = Json::array();
  for (const GroundRow& row : table.rows) json["rows"].push_back(json_of(row));
  if (table.plan.flown > 0) json["flights"] = Json::array();
  for (const FlightRow& row : table.flights) json["flights"].push_back(json_of(row));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string ground_markdown(const GroundTable& table) {
  std::vector<Cells> views = {heads, Cells(heads.size(), "---")};
  for (const GroundRow& row : table.rows) views.push_back(cells_of(row));
  std::vector<Cells> flights = {flight_heads, Cells(flight_heads.size(), "---")};
  for (const FlightRow& row : table.flights) flights.push_back(cells_of(row));
  return table.plan.flown > 0 ? markdown_of(flights) : markdown_of(views);
}

std::string ground_page(const GroundTable& table) {
  if (table.plan.flown > 0) {
    return html_page(
        "Terrella: a flight to the ground", styles,
        text_of("<h1>A flight to the ground of a planet of real size</h1>\n", flights_html(table), flight_columns));
  }
  std::string page =
      text_of("<h1>What a ground of real size costs</h1>\n<p>For the same error on screen, at ", table.plan.width, "×",
              table.plan.height, " pixels and 60 degrees, measured in ", figure(table.seconds), " s",
              table.renderer.empty() ? "" : text_of("; frames drawn by ", escaped(table.renderer)), ".</p>\n");
  page += "<h2>Limits</h2>\n" + limits_html(table);
  page += "<h2>The table</h2>\n" + table_html(table) + columns;
  return html_page("Terrella: what a ground of real size costs", styles, page);
}

}  // namespace terrella
