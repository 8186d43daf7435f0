#pragma once

namespace terrella {

// Shows on standard error which part (0..1) of a long work is done: a bar on a terminal, whose line ends with the work;
// else the lines of ProgressLines. what: a few words.
void show_progress(const char* what, double part);

}  // namespace terrella
