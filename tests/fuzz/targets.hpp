#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace terrella {

// Load a text that anyone may have made up as a scene's JSON, or as its link, and CHECK what must hold all the same:
// every value is within its range, what is said about the text can be read, and what was loaded can be saved and loaded
// again.
void fuzz_json(std::string_view text);
void fuzz_link(std::string_view text);
// The same of a path for the camera: what is read without a complaint can be flown.
void fuzz_path(std::string_view text);

}  // namespace terrella

// libFuzzer's entry: the first byte says which of the three, the rest is the text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
