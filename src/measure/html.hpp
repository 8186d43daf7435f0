// What pages of reports are made of.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace terrella {

// Text as HTML shows it, also between double quotes.
std::string escaped(std::string_view text);

// A whole page that asks nothing of any host: readable in light and dark, in narrow windows and on paper. styles: CSS
// beside that of all pages.
std::string html_page(std::string_view title, std::string_view styles, std::string_view body);

// A table that scrolls within itself where it is too wide.
class Table {
 public:
  // heads: of the columns, as text.
  explicit Table(const std::vector<std::string>& heads);

  // cells: as text.
  void row(const std::vector<std::string>& cells, std::string_view row_class = {});

  [[nodiscard]] std::string html() const { return html_ + "</tbody></table></div>\n"; }

 private:
  std::vector<std::string> heads_;
  std::string html_;
};

}  // namespace terrella
