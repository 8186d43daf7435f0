// All-pairs covering arrays: few rows in which every two values of every two factors meet.
#pragma once

#include <span>
#include <vector>

namespace terrella {

// levels: how many values each factor has, 1 or more. Each row holds a value 0..levels[f] - 1 for every factor f; for
// any two factors every pair of their values stands in at least one row. The same rows for the same seed, on every
// machine. Greedy, so that the rows are few (about 2.5 times the least for factors of 3 values), not fewest.
std::vector<std::vector<int>> covering_pairs(std::span<const int> levels, unsigned seed);

}  // namespace terrella
