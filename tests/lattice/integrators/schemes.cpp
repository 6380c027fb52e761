// Splittings and Runge-Kutta-Nystrom schemes: coefficients, orders where contacts stay closed, reversal, energy.

#include "lattice/integrators/schemes.hpp"

#include "lattice/events/event_driven.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/integrators/refinement.hpp"
#include "support/check.hpp"
#include "support/states.hpp"

using namespace lattice;

TEST_CASE("coefficients of the schemes satisfy their order conditions", "[unit][formulas]") {
  // Quadrature of t^k by the velocity weights and, with a second integral, by the position weights;
  // and the two conditions that couple the stages up to order five.
  for (const Nystrom& base : {dormand_prince_6(), nystrom(blanes_moan_4()),
                              nystrom(blanes_moan_6()), nystrom(blanes_moan_6_14())}) {
    for (int k = 0; k < base.order; ++k) {
      CAPTURE(base.name, k);
      double velocity = 0, position = 0, coupled = 0;
      for (std::size_t i = 0; i < base.b.size(); ++i) {
        velocity += base.b[i] * std::pow(base.c[i], k);
        if (i < base.last()) position += base.a[base.last()][i] * std::pow(base.c[i], k);
        for (std::size_t j = 0; j < i; ++j)
          coupled += base.b[i] * base.a[i][j] * std::pow(base.c[j], k);
      }
      check_close(velocity, 1.0 / (k + 1), 2e-13);
      if (k + 1 < base.order) check_close(position, 1.0 / (k + 1) / (k + 2), 2e-13);
      if (k < 3 && k + 3 <= base.order)
        check_close(coupled, 1.0 / (k + 1) / (k + 2) / (k + 3), 2e-13);
    }
  }
  const Nystrom base = dormand_prince_6();
  for (std::size_t i = 1; i < base.c.size(); ++i) {
    double sum = 0;
    for (double a : base.a[i]) sum += a;
    check_close(sum, base.c[i] * base.c[i] / 2, 1e-15);
  }
}

TEST_CASE("schemes have their order where contacts stay closed", "[convergence][contact]") {
  const Chain ring{20, Quartic{1}, CompressedHertz{2}, Ends::periodic};
  State<double> wave(20);
  for (int n = 0; n < 20; ++n) wave.y[n] = 0.3 * std::sin(0.3 * M_PI * n);
  const auto exact = after(EventCorrected{0.01}, ring, wave, 5);
  const auto order = [&](const auto& coarse, const auto& fine) {
    return std::log2(distance(after(coarse, ring, wave, 5), exact) /
                     distance(after(fine, ring, wave, 5), exact));
  };
  for (const Nystrom& base :
       {dormand_prince_6(), nystrom(blanes_moan_6()), nystrom(blanes_moan_6_14())}) {
    CAPTURE(base.name);
    check_close(order(EventCorrected{0.2, base}, EventCorrected{0.1, base}), 6, 0.5);
  }
  const struct {
    Scheme scheme;
    double step, within;
  } splittings[] = {{verlet(), 0.02, 0.1},
                    {blanes_moan_4(), 0.1, 0.2},
                    {blanes_moan_6(), 0.2, 0.4},
                    {blanes_moan_6_14(), 0.4, 0.4}};
  for (const auto& [scheme, step, within] : splittings) {
    CAPTURE(scheme.name);
    check_close(order(Splitting{scheme, step}, Splitting{scheme, step / 2}), scheme.order, within);
  }
}

TEST_CASE("a run is undone by turning the velocities round", "[property]") {
  const Chain chain{60, Quartic{1}};
  for (const Scheme& scheme : {verlet(), blanes_moan_4(), blanes_moan_6()}) {
    CAPTURE(scheme.name);
    auto s = after(Splitting{scheme, 0.05}, chain, struck(60, 1.9), 20);
    for (double& v : s.v) v = -v;
    s = after(Splitting{scheme, 0.05}, chain, s, 20);
    check_close(largest_difference(s, struck(60, -1.9)), 0, 1e-11);
  }
}

TEST_CASE("energy drift is small and reported", "[property]") {
  const Chain chain{200, Quartic{1}};
  auto s = struck(200, 1.9);
  const Run run = evolve(Splitting{blanes_moan_6(), 0.02}, chain, s, 200, Every{1});
  CHECK(run.energy_drift > 0);
  CHECK(run.energy_drift < 1e-5);
  check_close(energy(chain, s), 1.9 * 1.9 / 2, 0, run.energy_drift * 1.01);
}

TEST_CASE("the chain agrees with GSL's adaptive method", "[property]") {
  const Chain chain{40, Quartic{-0.3}};
  auto ours = after(Splitting{blanes_moan_6(), 1e-3}, chain, struck(40, 0.9), 10);
  check_close(distance_from_reference(chain, struck(40, 0.9), 10, ours, 1e-6), 0, 1e-7);
  ours.v[3] += 1e-5;  // a state that GSL does not confirm is refused
  CHECK_THROWS_AS(distance_from_reference(chain, struck(40, 0.9), 10, ours, 1e-6),
                  std::runtime_error);
}
