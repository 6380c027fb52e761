#include "lattice/numerics/criterion.hpp"

#include <algorithm>
#include <utility>

namespace lattice {

Estimate Condition::margin() const {
  const double left = side == Side::above ? value.value - limit : limit - value.value;
  return {left, value.error, value.is_exact};
}

Condition above(std::string name, const Estimate& value, double limit) {
  return {std::move(name), value, Condition::Side::above, limit};
}

Condition below(std::string name, const Estimate& value, double limit) {
  return {std::move(name), value, Condition::Side::below, limit};
}

Criterion within(const Estimate& value, double low, double high) {
  return {above("least", value, low), below("most", value, high)};
}

Criterion increasing(const std::vector<Estimate>& values) {
  if (values.size() < 2) return {};
  Estimate least = quotient(values[1], values[0]);
  for (std::size_t k = 2; k < values.size(); ++k)
    least = smaller(least, quotient(values[k], values[k - 1]));
  return {above("least_ratio", least, 1)};
}

Criterion named(const std::string& prefix, Criterion criterion) {
  for (Condition& c : criterion) c.name = prefix + "_" + c.name;
  return criterion;
}

void append(Criterion& all, const Criterion& more) {
  all.insert(all.end(), more.begin(), more.end());
}

bool holds(const Criterion& criterion) {
  return !criterion.empty() && std::all_of(criterion.begin(), criterion.end(),
                                           [](const Condition& c) { return c.holds(); });
}

}  // namespace lattice
