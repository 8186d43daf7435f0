#pragma once

#include <random>
#include <span>
#include <string>
#include <string_view>

namespace terrella {

// The text with one to eight changes: bytes flipped, pieces removed, repeated or moved, words put in, the end cut off.
// The same state of `random` makes the same text on every machine.
std::string mutated(std::string text, std::span<const std::string_view> words, std::mt19937& random);

}  // namespace terrella
