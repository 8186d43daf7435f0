// A file manager from which a file is dragged.
#pragma once

#include <string>

namespace terrella::test {

class Screen;

// Drops a file into the middle of a window, by the protocol XDND. False if the window does not take it.
bool drop_file(const Screen& screen, const std::string& title, const std::string& path);

}  // namespace terrella::test
