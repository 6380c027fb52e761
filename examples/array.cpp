// An array of cantilevers in SI units: what an impact of one metre per second does at cantilever 80.
#include <iostream>
#include "lattice/cantilever/cantilever.hpp"
#include "lattice/diagnostics/pulse.hpp"
#include "lattice/impact/impact.hpp"

using namespace lattice;

int main() {
  const Scales si = CantileverArray{}.scales();
  const Impact impact{si.velocity(1), Chain{200}, si.time(60), 0.05};
  std::vector<double> t, force, v;
  strike(EventCorrected{0.1}, impact, [&](const State<double>& now, const auto&) {
    t.push_back(now.t), v.push_back(now.v[79]);
    force.push_back(contact_push(impact.chain, now.y.data(), 80));
  });
  const Push push = strongest_push(t, force).value();
  std::cout << "force " << push.force * si.unit_force() << " N, velocity "
            << largest_modulus(t, v) * si.unit_velocity() << " m/s, arrival "
            << si.milliseconds(push.t) << " ms\n";
}
