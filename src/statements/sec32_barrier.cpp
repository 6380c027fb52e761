/**
# Statements of section 3.2: The Peierls-Nabarro barrier */

#include <cmath>
#include <vector>

#include "report/statement.hpp"

using namespace lattice;

namespace {

constexpr double soft = -1.0 / 6, linear = 0, hard = 1;  // the wells, by s

Estimate barrier(const Data::Row& pair) {
  return abs(pair["equal_frequency"]);
}

/// Whether the barrier has another sign than at the frequency before.
bool sign_changed(const Data::Row* pair) {
  return (pair[-1]["equal_frequency"] * pair[0]["equal_frequency"]).value < 0;
}

/// How often it changes its sign; where one may be zero that is not certain.
Estimate changes_of_sign(const Data& pairs) {
  int all = 0, doubtful = 0;
  for (const Data::Row* pair = pairs.begin() + 1; pair < pairs.end(); ++pair) {
    const Estimate product = pair[-1]["equal_frequency"] * pair[0]["equal_frequency"];
    all += sign_changed(pair);
    doubtful += std::abs(product.value) <= product.error;
  }
  return doubtful == 0 ? exact(all) : Estimate(all, doubtful);
}

/// The mean of barrier over energy; that over every second frequency tells how well it is known.
Estimate mean_ratio(const Data& pairs, const Data& frequencies) {
  std::vector<Estimate> all, second;
  for (const auto& at : frequencies) {
    const Data::Row pair = pairs.at("omega", at("omega"));
    all.push_back(barrier(pair) / pair["energy_bond"]);
    if (all.size() % 2 == 1) second.push_back(all.back());
  }
  return compare(mean_of(second), mean_of(all));
}

}  // namespace

STATEMENT("pn.omega11") {
  answer(table("key_pairs").at("s", linear, "omega", 1.1)["equal_frequency"]);
  accuracy(table("accuracy")["energy"]);
}

STATEMENT("pn.small") {
  answer(table("key_pairs").at("s", linear, "omega", 1.01)["equal_frequency"]);
}

STATEMENT("pn.omega15") {
  answer(table("key_pairs").at("s", soft, "omega", 1.5)["equal_frequency"]);
}

STATEMENT("pn.harmonic_ratio") {
  answer(table("key_pairs").at("s", soft, "omega", 1.3)["over_linear"]);
}

STATEMENT("pn.grows") {
  for (double s : {soft, linear, hard}) {
    const Data pairs = table("barriers").where("s", s);
    increases(pairs, "omega", "amplitude_bond");

    // Each arch between two zeros is higher than the one before
    std::vector<std::vector<Estimate>> arches{{barrier(pairs.begin()[0])}};
    for (const Data::Row* pair = pairs.begin() + 1; pair < pairs.end(); ++pair) {
      if (sign_changed(pair)) arches.push_back({});
      arches.back().push_back(barrier(*pair));
    }
    for (std::size_t k = 1; k < arches.size(); ++k)
      less(largest_of(arches[k - 1]), largest_of(arches[k]));

    // The last barrier is the largest
    const Data::Row& last = pairs.end()[-1];
    for (const auto& pair : pairs)
      if (pair("omega") < last("omega")) less(barrier(pair), barrier(last));
  }
}

STATEMENT("pn.remains_small") {
  answer(largest(table("barriers").where("omega", 1.005, 2), "relative"), "relative");
}

STATEMENT("pn.ratio_smallest") {
  const Data pairs = table("barriers");
  const Data shared =
      pairs.where("s", linear).where("omega", 1.005, 1.9);  // the soft branch ends there
  const auto ratio = [&](double s) { return mean_ratio(pairs.where("s", s), shared); };
  for (double s : {soft, hard}) less(ratio(linear), ratio(s));
}

STATEMENT("barrier.signs") {
  const Data pairs = table("barriers");
  near(changes_of_sign(pairs.where("s", linear)), 7, 0.5);
  near(changes_of_sign(pairs.where("s", soft)), 14, 0.5);
  near(changes_of_sign(pairs.where("s", hard)), 1, 0.5);
}

STATEMENT("barrier.equal_area") {
  // Towards omega_b = 1 the two barriers have the ratio -(omega_b - 1) / 5
  const Data pairs = table("key_pairs").where("s", linear);
  const Data::Row weakest = pairs.at("omega", 1.001), above = pairs.at("omega", 1.1);
  const Estimate ratio = weakest["equal_area"] / weakest["equal_frequency"];
  within(ratio / (-(weakest("omega") - 1) / 5), 0.95, 1.05);
  less(above["equal_area"], 0);
  less(0, above["equal_frequency"]);
}
