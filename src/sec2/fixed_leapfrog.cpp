#include "sec2/fixed_leapfrog.hpp"

#include <cstddef>
#include <vector>

#include "lattice/events/columns.hpp"

namespace lattice {

/**
The derivative of a drift is the drift itself; that of a kick is the linearisation (chain.hpp) about the
positions at which the kick is given. */
static void kick_tangent(const Chain& chain, const std::vector<double>& y, double h,
                         Tangent<double>& tangent) {
  const Hessian<double> bend = linearise(chain, y);
  const std::size_t sites = chain.sites, columns = tangent.columns;
  const bool ring = chain.ends == Ends::periodic;
  for (std::size_t n = 0; n < sites; ++n) {
    const double push = -h * inverse_mass<double>(chain, n);
    const std::size_t before = n > 0 ? n - 1 : sites - 1, after = n + 1 < sites ? n + 1 : 0;
    double* row = tangent.row(sites + n);
    add_scaled(row, tangent.row(n), push * bend.diagonal[n], columns);
    if (n > 0 || ring) add_scaled(row, tangent.row(before), push * bend.off[before], columns);
    if (after > 0 || ring) add_scaled(row, tangent.row(after), push * bend.off[n], columns);
  }
}

/**
Since both are cheap here, the tangent simply follows its orbit step by step. */
void LeapfrogShooting::advance(State<double>& z, Tangent<double>* tangent, int count,
                               const std::function<void(const State<double>&)>& watch) const {
  const std::size_t sites = this->chain.sites;
  const double h = this->period() / steps;
  const auto drift = [&](double by) {
    add_scaled(z.y.data(), z.v.data(), by, sites);
    if (tangent) add_scaled(tangent->row(0), tangent->row(sites), by, sites * tangent->columns);
  };
  for (int k = 0; k < count; ++k) {
    drift(h / 2);
    const std::vector<double> a = accelerations(this->chain, z.y);
    add_scaled(z.v.data(), a.data(), h, sites);
    if (tangent) kick_tangent(this->chain, z.y, h, *tangent);
    drift(h / 2);
    watch(z);
  }
}

/**
An evaluation differs from that of shooting.hpp only in how the chain is run: residuals and derivatives follow from the
lists of the symmetry as they do there. */
Evaluation<double> LeapfrogShooting::evaluate(const Vector<double>& x, bool with_jacobian) const {
  const State<double> start = this->expand(x);
  State<double> z = start;
  const Tangent<double> first = tangent_of<double>(this->symmetry.unknowns, this->chain.sites);
  Tangent<double> tangent = first;
  advance(z, with_jacobian ? &tangent : nullptr, steps / this->symmetry.parts,
          [](const State<double>&) {});
  Evaluation<double> out;
  out.residual = this->residuals(start, z);
  if (with_jacobian) out.jacobian = this->slopes(first, tangent);
  return out;
}

Equations<double> LeapfrogShooting::equations() const {
  const auto rows = Eigen::Index(this->symmetry.equations.size());
  return {name(),
          [*this](const Vector<double>& x, const EventTolerance<double>&, bool derivative) {
            return evaluate(x, derivative);
          },
          [rows, size = scale](const Vector<double>& x, bool) {
            return Sizes<double>{Vector<double>::Constant(x.size(), size),
                                 Vector<double>::Constant(rows, size)};
          }};
}

}  // namespace lattice
