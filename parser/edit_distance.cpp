#include "parser/edit_distance.h"

#include <algorithm>
#include <vector>

namespace durer {

int edit_distance(std::string_view a, std::string_view b, int most) {
  const size_t slack = static_cast<size_t>(most / 2);
  if (a.size() > b.size() + slack || b.size() > a.size() + slack) return most + 1;
  const auto replaced = [](char x, char y) {
    if (x == y) return 0;
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    return lower(x) == lower(y) ? 1 : 2;
  };
  const size_t width = b.size() + 1;
  std::vector<int> rows(width * (a.size() + 1));
  for (size_t j = 0; j < width; ++j) rows[j] = static_cast<int>(2 * j);
  for (size_t i = 1; i <= a.size(); ++i) {
    int* row = &rows[i * width];
    const int* above = row - width;
    row[0] = static_cast<int>(2 * i);
    for (size_t j = 1; j < width; ++j) {
      row[j] =
          std::min({row[j - 1] + 2, above[j] + 2, above[j - 1] + replaced(a[i - 1], b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], rows[(i - 2) * width + j - 2] + 2);
      }
    }
  }
  return rows.back();
}

}  // namespace durer
