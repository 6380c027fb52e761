#include "lattice/integrators/compensated.hpp"

#include "lattice/model/typed.hpp"

namespace lattice {
namespace {

/// The way of adding for the sweep of kernel.hpp: what the positions and velocities have lost so far,
/// one entry per site.
template <class T>
struct CompensatedSum {
  T* __restrict__ low_y, * __restrict__ low_v;

  __attribute__((always_inline)) void kick(T& v, std::size_t i, T term) const {
    add_exactly(v, low_v[i], term);
  }
  __attribute__((always_inline)) void drift(T& y, std::size_t i, T term) const {
    add_exactly(y, low_y[i], term);
  }
  CompensatedSum from(std::size_t site) const { return {low_y + site, low_v + site}; }
};

}  // namespace

double Compensated::advance(const Chain& chain, State<double>& state, Window& window, double h,
                            std::size_t count) const {
  const auto move = detail::kick_drifter<double, CompensatedSum<double>>(chain);
  State<double> low(chain.sites);
  const CompensatedSum<double> sum{low.y.data(), low.v.data()};
  double work = 0;
  for (std::size_t k = 0; k < stage_count(scheme, count); ++k) {
    const Stage<double> stage = stage_at<double>(scheme, h, count, k);
    move(chain, state, window, stage.kick, stage.drift, sum);
    work += double(window.last - window.first);
  }
  return work;
}

}  // namespace lattice
