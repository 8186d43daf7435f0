#include "mutate.hpp"

#include <algorithm>

namespace terrella {
namespace {

// Not a std distribution: those differ from one standard library to another.
std::size_t below(std::size_t end, std::mt19937& random) { return end == 0 ? 0 : random() % end; }

struct Piece {
  std::size_t start, length;
};

// Mostly short: long ones would leave nothing of the text after a few changes.
Piece random_piece(const std::string& text, std::mt19937& random) {
  const std::size_t start = below(text.size() + 1, random);
  const std::size_t longest = std::min<std::size_t>(text.size() - start, below(8, random) == 0 ? text.size() : 12);
  return {start, below(longest + 1, random)};
}

void flip_a_byte(std::string& text, std::mt19937& random) {
  if (text.empty()) return;
  text[below(text.size(), random)] = static_cast<char>(below(256, random));
}

void remove_a_piece(std::string& text, std::mt19937& random) {
  const Piece piece = random_piece(text, random);
  text.erase(piece.start, piece.length);
}

void repeat_a_piece(std::string& text, std::mt19937& random) {
  const Piece piece = random_piece(text, random);
  text.insert(below(text.size() + 1, random), text.substr(piece.start, piece.length));
}

void put_in_a_word(std::string& text, std::span<const std::string_view> words, std::mt19937& random) {
  const std::string_view word = words[below(words.size(), random)];
  const Piece piece = random_piece(text, random);
  text.replace(piece.start, below(2, random) == 0 ? 0 : piece.length, word);
}

}  // namespace

std::string mutated(std::string text, std::span<const std::string_view> words, std::mt19937& random) {
  for (std::size_t changes = 1 + below(8, random); changes > 0; --changes) {
    switch (below(9, random)) {
      case 0:
      case 1: flip_a_byte(text, random); break;
      case 2:
      case 3: remove_a_piece(text, random); break;
      case 4: repeat_a_piece(text, random); break;
      case 5:
        if (below(4, random) == 0) text.resize(below(text.size() + 1, random));
        break;
      default: put_in_a_word(text, words, random); break;
    }
  }
  return text;
}

}  // namespace terrella
