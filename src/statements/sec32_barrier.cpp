/**
# Statements of section 3.2: The Peierls-Nabarro barrier */

#include <algorithm>
#include <cmath>
#include <vector>

#include "report/statement.hpp"

using namespace report;

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

/// The one that is farthest, as a factor, from the middle of the range that is printed.
Estimate farthest(const std::vector<Estimate>& all, double low, double high) {
  const double middle = std::sqrt(low * high);
  const auto apart = [&](const Estimate& e) {
    return e.value > 0 ? std::abs(std::log(e.value / middle)) : HUGE_VAL;
  };
  return *std::ranges::max_element(all, {}, apart);
}

}  // namespace

STATEMENT("pn.omega11") {
  answer(table("key_pairs").at("s", linear, "omega", 1.1)["equal_frequency"]);
  accuracy(table("accuracy")["energy"]);
}

// Three wells, of which none may be farther from the printed range than the answer
STATEMENT("pn.small") {
  std::vector<Estimate> all;
  for (double s : {soft, linear, hard})
    all.push_back(table("key_pairs").at("s", s, "omega", 1.01)["equal_frequency"]);
  answer(farthest(all, 1e-15, 1e-14), "");
}

STATEMENT("pn.omega15") {
  answer(table("key_pairs").at("s", soft, "omega", 1.5)["equal_frequency"]);
}

// Both anharmonic wells
STATEMENT("pn.harmonic_ratio") {
  std::vector<Estimate> all;
  for (double s : {soft, hard})
    all.push_back(table("key_pairs").at("s", s, "omega", 1.3)["over_linear"]);
  answer(farthest(all, 1e3, 1e4), "");
}

// Much is an order of magnitude; beyond small amplitude, which ends at 1.1 in the article
STATEMENT("pn.harmonic_smaller") {
  const Data harmonic = table("barriers").where("s", linear);
  const auto below = [&](double s, double last) {
    const Data other = table("barriers").where("s", s);
    for (const auto& pair : harmonic.where("omega", 1.1, last))
      less(barrier(pair), bound(0.1) * barrier(other.at("omega", pair("omega"))));
  };
  below(soft, 1.9);
  below(hard, 2);
}

// From each frequency to the next
STATEMENT("pn.grows") {
  for (double s : {soft, linear, hard}) {
    const Data pairs = table("barriers").where("s", s);
    control([&] { increases(pairs, "omega", "amplitude_bond"); });
    for (const Data::Row* pair = pairs.begin() + 1; pair < pairs.end(); ++pair) {
      less(barrier(pair[-1]), barrier(*pair));
    }
  }
}

STATEMENT("pn.remains_small") {
  const auto largest_up_to = [&](double last) {
    return Quantity{{largest(table("barriers").where("omega", 1.005, last), "relative")},
                    "of the energy"};
  };
  answer(largest_up_to(2));
  reading("to_1.5", largest_up_to(1.5));
}

// At small amplitude the wells differ by less than a half
STATEMENT("pn.comparable") {
  for (double s : {soft, hard})
    near(table("key_pairs").at("s", s, "omega", 1.01)["over_linear"], 1, bound(0.5));
}

STATEMENT("pn.approximates") {
  const Data::Row pair = table("key_pairs").at("s", linear, "omega", 1.1);
  answer(abs(pair["equal_area"] / pair["equal_frequency"]), "of the barrier at equal frequency");
}

// At every frequency that both wells have in common; the soft branch ends at 1.9
STATEMENT("pn.ratio_smallest") {
  const Data harmonic = table("barriers").where("s", linear);
  const auto above = [&](double s, double last) {
    const Data other = table("barriers").where("s", s);
    for (const auto& pair : harmonic.where("omega", 1.005, last))
      less(pair["relative"], other.at("omega", pair("omega"))["relative"]);
  };
  above(soft, 1.9);
  above(hard, 2);
}

STATEMENT("barrier.signs") {
  const Data pairs = table("barriers");
  near(changes_of_sign(pairs.where("s", linear)), 7, bound(0.5));
  near(changes_of_sign(pairs.where("s", soft)), 14, bound(0.5));
  near(changes_of_sign(pairs.where("s", hard)), 1, bound(0.5));
}

STATEMENT("barrier.equal_area") {
  // Towards omega_b = 1 the two barriers have the ratio -(omega_b - 1) / 5
  const Data pairs = table("key_pairs").where("s", linear);
  const Data::Row weakest = pairs.at("omega", 1.001), above = pairs.at("omega", 1.1);
  const Estimate ratio = weakest["equal_area"] / weakest["equal_frequency"];
  near(ratio / (-(weakest("omega") - 1) / 5), 1, bound(0.05));
  less(above["equal_area"], 0);
  less(0, above["equal_frequency"]);
}
