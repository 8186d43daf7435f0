#include "measure/html.hpp"

#include "base/check.hpp"
#include "base/text.hpp"

namespace terrella {
namespace {

constexpr std::string_view all_pages = R"(
:root { color-scheme: light dark; --ink: #1c2530; --soft: #5a6675; --line: #d5dbe3; --panel: #eef2f7; --page: #fff;
  --wrong: #fdeaea; --accent: #1769aa; --mark: #c2410c; --faint: #9aa8b8; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e9f0; --soft: #9aa7b7; --line: #323c49; --panel: #1d2630; --page: #12181f; --wrong: #4a2226;
    --accent: #6cb6f5; --mark: #ff9a5c; --faint: #566474; }
}
body { font: 16px/1.5 system-ui, sans-serif; max-width: 68rem; margin: 2rem auto; padding: 0 1rem; color: var(--ink);
  background: var(--page); overflow-wrap: break-word; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .6rem; }
h2 { font-size: 1.3rem; margin: 2.4rem 0 .4rem; }
h3 { font-size: 1.05rem; margin: 1.8rem 0 .3rem; }
p { max-width: 46rem; }
.wide { overflow-x: auto; margin: .5rem 0 1.5rem; }
table { border-collapse: collapse; width: 100%; font-size: .875rem; font-variant-numeric: tabular-nums; }
th, td { text-align: left; vertical-align: top; padding: .3rem .6rem; border-bottom: 1px solid var(--line); }
th { background: var(--panel); }
.wrong td { background: var(--wrong); }
@media print {
  :root { color-scheme: light; --ink: #000; --soft: #444; --line: #bbb; --panel: #eee; --page: #fff; --wrong: #fdd;
    --accent: #1769aa; --mark: #c2410c; --faint: #888; }
  body { margin: 0; max-width: none; font-size: 10pt; }
  .wide { overflow: visible; }
  table { font-size: 8pt; }
  th, td { padding: .15rem .3rem; }
  tr, figure, svg { break-inside: avoid; }
  h2, h3 { break-after: avoid; }
}
)";

}  // namespace

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&': safe += "&amp;"; break;
      case '<': safe += "&lt;"; break;
      case '>': safe += "&gt;"; break;
      case '"': safe += "&quot;"; break;
      default: safe += c;
    }
  }
  return safe;
}

std::string html_page(std::string_view title, std::string_view styles, std::string_view body) {
  return text_of("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>", escaped(title),
                 "</title>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<style>",
                 all_pages, styles, "</style></head><body>\n", body, "</body></html>\n");
}

Table::Table(const std::vector<std::string>& heads) : heads_(heads) {
  html_ = "<div class=\"wide\" tabindex=\"0\"><table><thead><tr>";
  for (const std::string& head : heads) html_ += text_of("<th>", escaped(head), "</th>");
  html_ += "</tr></thead><tbody>\n";
}

void Table::row(const std::vector<std::string>& cells, std::string_view row_class) {
  CHECK(cells.size() == heads_.size(), cells.size(), " cells in ", heads_.size(), " columns");
  html_ += row_class.empty() ? "<tr>" : text_of("<tr class=\"", row_class, "\">");
  // Its head again, for pages so narrow that a row is a list.
  for (std::size_t i = 0; i < cells.size(); ++i)
    html_ += text_of("<td data-head=\"", escaped(heads_[i]), "\">", escaped(cells[i]), "</td>");
  html_ += "</tr>\n";
}

}  // namespace terrella
