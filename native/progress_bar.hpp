#pragma once

namespace terrella {

// Shows on standard error which part (0..1) of a long work is done; the line ends with the work. Only on a terminal.
// what: a few words.
void show_progress(const char* what, double part);

}  // namespace terrella
