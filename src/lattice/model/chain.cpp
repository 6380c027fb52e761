#include "lattice/model/chain.ipp"

#include <sstream>
#include <stdexcept>

#include "lattice/model/precisions.hpp"

namespace lattice {

// Beads and contacts that differ from site to site, as far as such a chain can exist
void vary(Chain& chain, const std::vector<double>& mass, const std::vector<double>& eta) {
  if ((!mass.empty() && mass.size() != chain.sites) ||
      (!eta.empty() && eta.size() != chain.sites + 1))
    throw std::invalid_argument("a chain of N sites needs N masses and N + 1 contact stiffnesses");
  if (!std::all_of(mass.begin(), mass.end(), [](double m) { return m > 0 && std::isfinite(m); }))
    throw std::invalid_argument("every mass must be finite and > 0");
  if (!std::all_of(eta.begin(), eta.end(), [](double k) { return k >= 0 && std::isfinite(k); }))
    throw std::invalid_argument("every contact stiffness must be finite and >= 0");
  if (chain.ends == Ends::periodic && !eta.empty() && eta.front() != eta.back())
    throw std::invalid_argument(
        "the first and last stiffness of a ring belong to the same contact and must be equal");
  // If only the masses vary the stiffnesses are all one, and the other way round
  const auto given = [&](const std::vector<double>& all, std::size_t count) {
    return all.empty() ? std::vector<double>(count, 1) : all;
  };
  chain.variation.reset();
  if (mass.empty() && eta.empty()) return;
  const std::vector<double> mu = given(mass, chain.sites);
  chain.variation = Variation{mu, mu, given(eta, chain.sites + 1)};
  for (double& m : chain.variation->inverse_mass) m = 1 / m;
}

Chain Chain::with_sites(std::size_t n) const {
  if (variation && n != sites)
    throw std::invalid_argument(
        "a chain with masses or stiffnesses of its own cannot be lengthened");
  Chain out = *this;
  out.sites = n;
  return out;
}

void assert_fits(const Chain& chain, std::size_t entries) {
  static const Variation none{};
  const Variation& all = chain.variation ? *chain.variation : none;
  const std::size_t beads = chain.variation ? chain.sites : 0;
  const std::size_t contacts = chain.variation ? beads + 1 : 0;
  if (entries == chain.sites && all.mass.size() == beads && all.inverse_mass.size() == beads &&
      all.eta.size() == contacts)
    return;
  std::ostringstream text;
  text << "a chain of " << chain.sites << " sites has " << all.mass.size() << " masses and "
       << all.eta.size() << " stiffnesses, and its state " << entries << " numbers (allowed: N, N"
       << " + 1 and N, or no masses and stiffnesses)";
  throw std::invalid_argument(text.str());
}

LATTICE_IN_EACH_PRECISION(LATTICE_CHAIN)

// The push of each bead on its neighbour to the right
std::vector<double> contact_forces(const Chain& chain, const std::vector<double>& y) {
  assert_fits(chain, y.size());
  std::vector<double> f(chain.sites);
  for (std::size_t n = 0; n < chain.sites; ++n) f[n] = contact_push(chain, y.data(), n + 1);
  return f;
}

// Stiffnesses for small motions about y: a well acts on its own bead
Hessian linearise(const Chain& chain, const std::vector<double>& y) {
  assert_fits(chain, y.size());
  const std::size_t n = chain.sites;
  const bool ring = chain.ends == Ends::periodic;
  Hessian h{std::vector<double>(n), std::vector<double>(n, 0)};
  for (std::size_t i = 0; i < n; ++i) h.diagonal[i] = chain.well.stiffness(y[i]);
  // A contact stiffens both its beads and couples them; at an end there is only one bead
  for (std::size_t i = 0; i <= n; ++i) {
    if (!is_distinct_contact(chain, i)) continue;
    const double k = chain.eta_of(i) * chain.contact.stiffness(stretch(chain, y.data(), i));
    if (i > 0) h.diagonal[i - 1] += k;
    if (i < n || ring) h.diagonal[i % n] += k;
    if (chain.inside(i) || ring) h.off[i - 1] = -k;
  }
  return h;
}

}  // namespace lattice
