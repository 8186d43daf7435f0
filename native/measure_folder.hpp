#pragma once

#include <string>

namespace terrella {

// Makes a folder if need be; returns what went wrong, or nothing.
std::string make_folder(const std::string& folder);

// Writes report.json and index.html into it; returns what went wrong, or nothing.
std::string write_report(const std::string& folder, const std::string& json, const std::string& page);

}  // namespace terrella
