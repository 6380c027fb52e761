/**
# The loops by themselves

Google Benchmark runs each loop until its time is certain; `items_per_second` are site-steps per
second. Try `build/bin/bench_kernels --benchmark_filter=verlet`. */

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "lattice/events/columns.hpp"
#include "lattice/integrators/compensated.hpp"
#include "lattice/integrators/contact_rkn.hpp"
#include "lattice/integrators/tiling.hpp"

using namespace lattice;

namespace {

State<double> swell(std::size_t sites) {
  State<double> s(sites);
  for (std::size_t n = 0; n < sites; ++n)
    s.y[n] = 0.3 * std::sin(0.37 * double(n) + 1) + 0.2 * std::sin(0.011 * double(n));
  return s;
}

/// What the contact law costs at least.
LATTICE_WIDE void all_roots(const double* __restrict__ x, double* __restrict__ out, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) out[i] = std::sqrt(x[i]);
}

void roots(benchmark::State& state) {
  const auto n = std::size_t(state.range(0));
  std::vector<double> x(n, 2), out(n);
  for (auto _ : state) {
    all_roots(x.data(), out.data(), n);
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// The acceleration of the whole chain, as the peers call it.
template <class Onsite>
void force(benchmark::State& state, Onsite onsite) {
  const Chain chain{std::size_t(state.range(0)), onsite};
  const State<double> s = swell(chain.sites);
  std::vector<double> a(chain.sites);
  Window all{0, chain.sites};
  for (auto _ : state) {
    accelerate(chain, s.y.data(), a.data(), all);
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// A stepper on a chain of which everything moves; a hundred steps a call.
template <class Onsite, class Stepper>
void steps(benchmark::State& state, Onsite onsite, Stepper stepper) {
  const Chain chain{std::size_t(state.range(0)), onsite};
  State<double> s = swell(chain.sites);
  Window all{0, chain.sites};
  double work = 0;
  for (auto _ : state) work += stepper.advance(chain, s, all, 0.01, 100);
  state.SetItemsProcessed(std::int64_t(work));
}

/// A kick of the tangent: rows times columns.
void kick(benchmark::State& state) {
  const auto n = std::size_t(state.range(0)), columns = 2 * n;
  std::vector<TangentRow<double>> rows(n, {-0.01, 0.001, 0.001});
  std::vector<double> y(n * columns, 1), v(n * columns, 0);
  for (auto _ : state) {
    kick_panel(rows.data(), y.data(), v.data(), n, columns);
    benchmark::DoNotOptimize(v.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(n * columns));
}

BENCHMARK(roots)->Arg(1024);
BENCHMARK_CAPTURE(force, harmonic, Harmonic{})->Arg(200)->Arg(1024);
BENCHMARK_CAPTURE(force, quartic, Quartic{1})->Arg(200)->Arg(1024);
BENCHMARK_CAPTURE(force, pendulum, Pendulum{})->Arg(1024);
BENCHMARK_CAPTURE(steps, verlet_harmonic, Harmonic{}, Splitting{verlet(), 0})->Arg(200)->Arg(1024);
BENCHMARK_CAPTURE(steps, verlet_quartic, Quartic{1}, Splitting{verlet(), 0})
    ->RangeMultiplier(10)
    ->Range(1000, 1000000);
BENCHMARK_CAPTURE(steps, verlet_tiled, Quartic{1}, Tiled{verlet(), 0})
    ->RangeMultiplier(10)
    ->Range(10000, 1000000)
    ->UseRealTime();
BENCHMARK_CAPTURE(steps, verlet_compensated, Quartic{1}, Compensated{verlet(), 0})->Arg(1024);
BENCHMARK_CAPTURE(steps, contact_aware, Quartic{1}, ContactAware{0.01})->Arg(200)->Arg(1024);
BENCHMARK(kick)->Arg(31)->Arg(99);

}  // namespace

BENCHMARK_MAIN();
