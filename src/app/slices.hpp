// In how many bands a picture is drawn that nobody waits for, and where they part: so that no frame takes long, even
// where pictures do. Decided by what rows were measured to cost; it knows neither clock nor renderer.
#pragma once

#include <array>
#include <bitset>

namespace terrella {

class Slices {
 public:
  static constexpr int most = 6;     // bands: each has to draw again the vertices of its neighbours near the border
  static constexpr int strips = 48;  // of equal height, between which bands may part

  // Strips from the bottom of the picture.
  struct Band {
    int first = 0, end = strips;
  };

  // A picture drawn whole came so long after the one before it, ms.
  void whole_came_after(double ms);

  // Bands of the next picture, 1: it is drawn whole.
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] Band band(int i) const;

  // Whether that band is to be waited for, so that it can be told what it took: this disturbs the work that processor
  // and GPU do side by side, and is asked for where nothing is known and of one band a picture.
  [[nodiscard]] bool wants_time_of(int i) const;
  // From before its first command until its last pixel, ms.
  void took(int i, double ms);
  // All bands of a picture are drawn: the next may have others.
  void decide();

 private:
  [[nodiscard]] double cost(const Band& band) const;
  void part_anew(int count);
  [[nodiscard]] double dearest() const;

  std::array<double, strips> costs_{};  // ms, all 0 while unknown
  int count_ = 1;
  std::array<int, most + 1> borders_{0, strips};  // in front of each band, and behind the last
  std::bitset<most> known_;                       // bands that were timed since they parted so
  int next_to_time_ = 0;                          // in turn, once all are known
  int slow_ = 0;                                  // pictures in a row that came late
  int time_to_trust_ = 0;                         // pictures for which a time of a whole one holds
};

}  // namespace terrella
