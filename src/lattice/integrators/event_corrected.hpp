#pragma once
/**
# Event-corrected steps

A Runge-Kutta step (schemes.hpp) replaces the impulse $\int_0^h F\,dt$ of a force by a weighted sum of stage forces.
Where a contact opens or closes at $t^*$ its force starts like $\eta\,[w\,(t-t^*)_+]^\alpha$, and the sum misses
$O(h^{\alpha+1})$ of the velocity, $h^{5/2}$ for spheres, however high the order. The motion that enters the force is
smoother by two integrations. So we take an ordinary step, look for contacts that have switched, and give each of them
the impulse that it really exerts (impulse.hpp) in place of the sum, from `reach` steps before to `reach` steps after it
switches. The measured order is then 5, until the steps that are farther away matter (secA_integrators). */

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lattice/integrators/impulse.hpp"
#include "lattice/integrators/integrate.hpp"

namespace lattice {

/// The terms of a row of coefficients that are not zero, times `scale`, filled up with zeros to a multiple of three.
struct StageSum {
  std::vector<double> weight{};
  std::vector<std::size_t> stage{};
  StageSum(const std::vector<double>& row, double scale);
};

/// The sums for steps of one length, and the bounds beyond which such a step does not resolve a contact.
struct StepSums {
  double length = 0;
  std::vector<StageSum> sums{};  ///< of the stages and, last, of the velocities
  double fast = 0,
         tight = 0;  ///< the square of a frequency, and the smallest overlap that may have it
};

/// Work space for a whole run of many short calls. Outside the window of moving sites it stays zero.
struct NystromMemory {
  std::vector<std::vector<double>> y{}, a{};  ///< of the stages; the first y is that of the state
  std::vector<double> v{}, shift{};           ///< new velocities; what the stages' positions lacked
  std::vector<double> shift_weight{};         ///< $\sum_i b_i a_{ij}$
  std::vector<StepSums> prepared{};     ///< for the latest steps, undivided, divided once and so on
  std::vector<const double*> row{};     ///< where the accelerations of the stages are
  std::vector<std::uint64_t> flag{};    ///< singular contacts,
  std::vector<std::size_t> contacts{};  ///< the list of them, ascending,
  std::vector<Impulse> correction{};    ///< and what each one needs, zero for all the others
  double small;                         ///< overlap that is not worth a correction
  /// `negligible` becomes `small`.
  NystromMemory(const Nystrom& base, std::size_t sites, double negligible);
};

/**
The exact impulse cures the contact, but the *stages* were spoilt too: their positions contain the sums
$h^2 \sum_j a_{ij} F_j$ of the same force and err by $O(h^{7/2})$. The other forces on a site, with
stiffness $K$, pass this on to its velocity. Summed over the stages the error is a second moment of $F$,
which the same quadrature gives. So we subtract
$$\frac{K h^3}{\mu}\Bigl[\int_0^1 \tfrac12 (1-s)^2 F\,ds
 - \sum_j \Bigl(\sum_i b_i a_{ij}\Bigr) F_j\Bigr] = O(h^{9/2}).$$
What remains are errors in $h^5$ per switching, mostly from the quintic, and those of the steps beyond the reach. A
contact that is corrected is left out of $K$, so that a longer reach makes the $O(h^{9/2})$ terms of neighbours return.
The scheme is neither symplectic nor reversible; its energy drifts by as much as its error.

Under a stiff contact, or one of light beads, the overlap vibrates with the frequency $\omega$,
$\omega^2 = \eta V''\,(1/\mu_n + 1/\mu_{n+1})$. Once $\omega h$ is of order one it may close, turn round and open
between two stages, and two resolutions can agree on a motion that does not happen. So a step in which a closed contact
has $\omega h > 1/2$ is divided into halves, again and again, until $\omega h < 1/8$ wherever a contact is closed. Both
numbers are halved with the steps of a refinement (`finer`), three times; every other resolution begins with thirds, so
that two of them have no steps in common. Beads of unit mass whose overlaps are below four do not know of all this. */
struct EventCorrected {
  double step;  ///< the largest that it may take
  Nystrom base = dormand_prince_6();
  double negligible = 1e-19;  ///< contact force lost in the rounding of a velocity: not corrected
  int finer = 0;              ///< how often the resolution of fast contacts is doubled
  int halvings = 0;  ///< how often a run halves the steps that `step` asks for (refinement.hpp)
  double reach = 2;  ///< so many steps from where a contact opens or closes it is still corrected

  NystromMemory memory(const Chain& chain) const;

  /// Advances `state` by `count` steps of length `h`; returns the number of site-force evaluations.
  double advance(const Chain& chain, State<double>& state, Window& window, double h,
                 std::size_t count, NystromMemory& at) const;
};
extern template Method::Method(const EventCorrected&);

}  // namespace lattice
