#include "sec33/candidates.hpp"

#include <algorithm>

#include "lattice/events/event_driven.hpp"

namespace lattice {

namespace {

// A splitting whose sums have a 64-bit mantissa; it rounds once per sample
struct WideSplitting {
  Scheme scheme;
  double step;

  double advance(const Chain& chain, State<double>& state, Window& window, double h,
                 std::size_t count) const {
    State<long double> wide(chain.sites);
    std::copy(state.y.begin(), state.y.end(), wide.y.begin());
    std::copy(state.v.begin(), state.v.end(), wide.v.begin());
    const double work = Splitting{scheme, step}.advance(chain, wide, window, h, count);
    std::copy(wide.y.begin(), wide.y.end(), state.y.begin());
    std::copy(wide.v.begin(), wide.v.end(), state.v.begin());
    return work;
  }
};

}  // namespace

std::vector<Candidate> candidates(const RestingBreather& at, double c, double time) {
  std::vector<Candidate> all;
  const auto add = [&](const std::string& name, const auto& method, double length) {
    all.push_back({name, method.step, [=, &at] { return at.after(c, method, length); }});
  };
  for (double h : {0.2, 0.1, 0.05, 0.025}) {
    add("verlet", Splitting{verlet(), h}, time);
    add("blanes_moan_4", Splitting{blanes_moan_4(), h}, time);
    add("blanes_moan_4_wide", WideSplitting{blanes_moan_4(), h}, time);
    add("contact_aware_6", EventCorrected{h}, time);
    add("contact_aware_14", fourteen_stages(h), time);
  }
  add("landing", EventDriven{1}, time / 5);
  return all;
}

}  // namespace lattice
