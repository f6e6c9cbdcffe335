// SPDX-License-Identifier: MIT
// The optimal string alignment distance, by rows.
#include "app/suggestion.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace vides {

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before2, before(b.size() + 1), row(b.size() + 1);
  std::iota(before.begin(), before.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = before[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({before[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before2[j - 2] + 1);
      }
    }
    before2 = before;
    before = row;
  }
  return before[b.size()];
}

std::string nearestWord(std::string_view mistyped, std::span<const std::string> words) {
  std::string nearest;
  std::size_t least = 0;
  for (const std::string& word : words) {
    const std::size_t distance = editDistance(mistyped, word);
    const std::size_t most = std::max<std::size_t>(1, std::max(word.size(), mistyped.size()) / 3);
    if (distance <= most && (nearest.empty() || distance < least)) {
      nearest = word;
      least = distance;
    }
  }
  return nearest;
}

}  // namespace vides
