// Compensated sums: less rounding than plain ones in a long run, by a clear factor.

#include "lattice/integrators/compensated.hpp"

#include <cstring>

#include "check.hpp"
#include "lattice/packets/impact.hpp"

using namespace lattice;

namespace {

/// A small wave on a ring whose contacts stay closed: nothing in it magnifies an error.

constexpr std::size_t sites = 16, steps = 400000;
constexpr double step = 0.004;

Chain ring() {
  return {sites, Harmonic{}, CompressedHertz{0.5}, Ends::periodic};
}

template <class T>
State<T> wave() {
  State<T> s(sites);
  for (std::size_t n = 0; n < sites; ++n) s.y[n] = T(0.1 * std::sin(M_PI * double(n) / 4));
  return s;
}

template <class T, class Stepper>
State<T> after(const Stepper& stepper, State<T> s, std::size_t count) {
  Window all{0, sites};
  stepper.advance(ring(), s, all, step, count);
  return s;
}

template <class A, class B>
double distance(const State<A>& a, const State<B>& b) {
  long double d = 0;
  for (std::size_t n = 0; n < sites; ++n)
    d = std::max({d, std::abs((long double)(a.y[n]) - (long double)(b.y[n])),
                  std::abs((long double)(a.v[n]) - (long double)(b.v[n]))});
  return double(d);
}

template <class Stepper>
double reversal_error(const Stepper& stepper) {
  auto s = after(stepper, wave<double>(), steps);
  for (double& v : s.v) v = -v;
  return distance(after(stepper, s, steps), wave<double>());
}

}  // namespace

TEST_CASE("compensation brings a long run closer to one with more digits", "[property]") {
  const auto exact = after(Splitting{verlet(), step}, wave<long double>(), steps);
  const double plain = distance(after(Splitting{verlet(), step}, wave<double>(), steps), exact);
  const double better = distance(after(Compensated{verlet(), step}, wave<double>(), steps), exact);
  CAPTURE(plain, better);
  CHECK(plain > 1e-15);
  CHECK(better < plain / 8);
}

TEST_CASE("compensation brings a reversed run closer to its start", "[property]") {
  const double plain = reversal_error(Splitting{verlet(), step});
  const double better = reversal_error(Compensated{verlet(), step});
  CAPTURE(plain, better);
  CHECK(better < plain / 8);
}

TEST_CASE("a compensated run is that of the plain scheme but for rounding", "[property][window]") {
  const Chain chain{60, Quartic{1}};
  auto a = struck(60, 1.9), b = a, c = a;
  Window some = waking(chain, a), all{0, 60}, third = some;
  Compensated{blanes_moan_6(), 0.05}.advance(chain, a, some, 0.05, 400);
  Compensated{blanes_moan_6(), 0.05}.advance(chain, b, all, 0.05, 400);
  Splitting{blanes_moan_6(), 0.05}.advance(chain, c, third, 0.05, 400);
  CHECK(a.y == b.y);
  CHECK(a.v == b.v);
  for (std::size_t n = 0; n < 60; ++n) check_close(a.y[n], c.y[n], 1e-11);
}

TEST_CASE("a varied chain is compensated, too", "[property]") {
  Chain chain{60, Quartic{1}};
  std::vector<double> mass(60), eta(61);
  for (std::size_t n = 0; n < 60; ++n) mass[n] = 1 + 0.1 * double(n % 7);
  for (std::size_t n = 0; n < 61; ++n) eta[n] = 1 + 0.2 * double(n % 5);
  const auto compare = [&] {
    auto a = struck(60, 1.9), b = a;
    Window some = waking(chain, a), other = some;
    Compensated{blanes_moan_6(), 0.05}.advance(chain, a, some, 0.05, 200);
    Splitting{blanes_moan_6(), 0.05}.advance(chain, b, other, 0.05, 200);
    CHECK(a.y != b.y);
    for (std::size_t n = 0; n < 60; ++n) check_close(a.y[n], b.y[n], 1e-11);
    return a.y;
  };
  const auto plain = compare();
  vary(chain, mass, {});
  const auto heavy = compare();
  vary(chain, {}, eta);
  const auto stiff = compare();
  CHECK(plain != heavy);
  CHECK(plain != stiff);
}
