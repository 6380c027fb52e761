// The DpS equation of spheres and the chain that it approximates; of other contacts and by its laws in dps.cpp.

#include "lattice/model/dps.hpp"

#include "lattice/numerics/line_fit.hpp"
#include "support/check.hpp"
#include "support/conditions.hpp"
#include "support/dps_deviation.hpp"

using namespace lattice;

namespace {

/// A well whose frequency at rest is not one.
struct Stiff {
  double energy(double y) const { return 0.501 * y * y; }
  double force(double y) const { return -1.002 * y; }
  double stiffness(double) const { return 1.002; }
};

template <class Values>
void check_all(const Values& values, const std::vector<double>& expected) {
  REQUIRE(values.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) check_close(values[i], expected[i], 1e-13);
}

}  // namespace

TEST_CASE("the DpS equation by hand", "[unit][dps]") {
  const auto rate = [](std::vector<double> a, Ends end) {
    std::vector<double> da(a.size());
    Dps{a.size() / 2, end}(0, a.data(), da.data());
    return da;
  };
  const double r = 1 / (2 * tau_0()), m = std::sqrt(5.0) * r;  // |3 + 4 i|^(1/2)
  check_all(rate({0, -1, 0, 0}, Ends::free), {r, 0, -r, 0});
  check_all(rate({3, 4, 0, 0}, Ends::fixed), {-8 * m, 6 * m, 4 * m, -3 * m});
  check_close(norm(Field{{3, 4}, 1}), 26, 1e-14);
  check_all(density(Field{{3, 4}, 1}), {25, 1});
  const auto still = dps_state(Field{{1, 2}}, 0.25, 0),
             later = dps_state(Field{{1, 2}}, 0.25, M_PI / 2);
  check_all(still.y, {0.5});
  check_all(still.v, {-1});
  check_all(later.y, {-1});
  check_all(later.v, {-0.5});
  CHECK(dps_impact(2)[0] == std::complex<double>(0, -1));
}

TEST_CASE("the order 3/2 needs a well of frequency one and the right tau_0", "[property][dps]") {
  const Field start = dps_impact(12);
  const auto stays = [&](const auto&... changed) {
    const auto error = [&](double eps) { return dps_deviation(start, eps, changed...); };
    return holds(within(order_between(1e-4, error(1e-4), 1e-5, error(1e-5)), 1.47, 1.53));
  };
  CHECK(stays(Well(Quartic{-1})));
  CHECK_FALSE(stays(Well(Stiff{})));
  CHECK_FALSE(stays(Well(Harmonic{}), 1 / (2 * 1.5)));
}
