#include "lattice/packets/impact.hpp"

namespace lattice {

State<double> struck(std::size_t sites, double velocity) {
  State<double> state(sites);
  state.v[0] = velocity;
  return state;
}

Chain endless(Chain chain, double velocity, double time) {
  const double sound = std::sqrt(chain.contact.stiffness(0.0));
  chain.sites = std::size_t(time * std::max({1.0, std::pow(velocity, 0.2), sound})) + 100;
  return chain;
}

double total(const std::vector<double>& e) {
  return std::accumulate(e.begin(), e.end(), 0.0);
}

double boundary_share(const std::vector<double>& e, std::size_t sites) {
  return std::accumulate(e.begin(), e.begin() + std::ptrdiff_t(std::min(sites, e.size())), 0.0) /
         total(e);
}

}  // namespace lattice
