// Where the desktop program keeps the panel's habits. A panel that forgets is no reason to complain: nothing here
// fails.
#pragma once

#include <string>

namespace terrella {

// The file, by the XDG base directory specification: state_home and home are the values of XDG_STATE_HOME and HOME, or
// empty. Empty where there is no place for it.
std::string habits_path(const std::string& state_home, const std::string& home);

// Of this user.
std::string habits_path();

// What was kept. At the first visit those of a newcomer, if they can be kept: nobody is to be shown around twice. Empty
// if nothing can be read.
std::string kept_habits(const std::string& path);
// Makes the file's folder where there is none.
void keep_habits(const std::string& path, const std::string& habits);

}  // namespace terrella
