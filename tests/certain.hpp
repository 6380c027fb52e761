#pragma once
// Is what a table shows known to one per cent? Asked point by point, because a column may span
// decades. The description of the error column says where another scale is meant:
//
//   "against the largest ..."           the largest modulus of the column
//   "against the neighbouring rows"     the largest modulus of this row and two on either side
//                                       (a quantity that crosses zero)
//   "relative ..."                      the error is relative already
//   "... nan ..."                       values or errors may be missing, but not all
//   "exact ..."                         the error may be zero everywhere

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "report/table.hpp"

/// The value against whose modulus the error of row `i` is judged.
inline double judged_against(const std::vector<double>& x, std::size_t i, const std::string& how) {
  const auto says = [&](const char* word) { return how.find(word) != std::string::npos; };
  std::size_t from = i, to = i + 1;
  if (says("against the largest")) {
    from = 0;
    to = x.size();
  } else if (says("against the neighbouring rows")) {
    from = i < 2 ? 0 : i - 2;
    to = std::min(x.size(), i + 3);
  } else if (says("relative")) {
    return 1;
  }
  double scale = 0;
  for (std::size_t k = from; k < to; ++k)
    if (std::isfinite(x[k])) scale = std::max(scale, std::abs(x[k]));
  return scale;
}

/// One complaint for each column with an error that is not known to one per cent.
inline std::vector<std::string> doubts(const lattice::Table& table) {
  std::vector<std::string> out;
  for (const lattice::Column& column : table.columns) {
    const auto at = column.name.rfind("_error");
    if (at == std::string::npos || at + 6 != column.name.size()) continue;
    const std::string quantity = column.name.substr(0, at), how = column.description;
    const auto x = table.numbers(quantity), error = table.numbers(column.name);
    const bool gaps = how.find("nan") != std::string::npos;
    std::size_t known = 0, missing = 0, bad = 0, first = 0;
    bool positive = false;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!std::isfinite(x[i]) || !std::isfinite(error[i])) {
        ++missing;
        continue;
      }
      ++known;
      positive = positive || error[i] > 0;
      const bool good = error[i] >= 0 && error[i] <= 0.01 * judged_against(x, i, how);
      if (!good && bad++ == 0) first = i;
    }
    const std::string name = "column " + column.name + ": ";
    if (bad)
      out.push_back(name + std::to_string(bad) + " of " + std::to_string(x.size()) +
                    " rows not known to one per cent, first row " + std::to_string(first) + ": " +
                    lattice::number_text(x[first]) + " +- " + lattice::number_text(error[first]));
    else if (known == 0)
      out.push_back(name + "no row has a value and an error");
    else if (missing && !gaps)
      out.push_back(name + std::to_string(missing) + " rows are not numbers");
    else if (!positive && how.find("exact") == std::string::npos)
      out.push_back(name + "every error is zero");
  }
  return out;
}
