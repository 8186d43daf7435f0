// What measuring needs, whatever is measured: a machine that can, and a folder.
#pragma once

#include <string>
#include <vector>

namespace terrella {

// Why the machine of the current context cannot measure, or nothing.
std::string beyond_this_machine();

// Makes a folder if need be; returns what went wrong, or nothing.
std::string make_folder(const std::string& folder);

struct NamedText {
  const char* name;  // of a file
  std::string text;
};

// Writes files into it; returns what went wrong, or nothing.
std::string write_files(const std::string& folder, const std::vector<NamedText>& files);

}  // namespace terrella
