#pragma once
/**
# Contact-aware stepping

A Runge-Kutta step (schemes.hpp) replaces the impulse $\int_0^h F\,dt$ of every force by a weighted sum of
stage forces, and with weights of order $p$ the error is $O(h^{p+1})$ as long as $F$ has $p$ derivatives.
The force of a contact that opens or closes does not. Its overlap $x$ passes through zero with a finite
speed $w$ at some $t^*$, and the force $F = \eta\,x_+^\alpha$ starts like $\eta\,[w\,(t-t^*)_+]^\alpha$.
Scaled to one step this function looks the same for every $h$, so the weights miss a fraction of its
size that depends only on where in the step the event falls: $h^\alpha$ in the force, $h^{\alpha+1}$ in
the velocity, which is $h^{5/2}$ for spheres.

The remedy is cheap, because only the sum over one contact force is wrong; the motion that enters it is
smoother by two integrations and well known. So we take an ordinary step, look for contacts that have
switched, and give each of them the impulse that it really exerts (impulse.hpp) in place of the sum that
the scheme used. The measured order is then about 4.5. */

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lattice/integrators/impulse.hpp"
#include "lattice/integrators/integrate.hpp"

namespace lattice {

/**
The few singular contacts get their impulses from impulse.hpp. The ordinary step concerns all sites and
takes most of the time, so its sums are prepared for the sweep over a stage: coefficients of the scheme
that vanish are dropped, and each sum is filled up with zeros to a multiple of three terms. */
template <class T>
struct StageSum {
  std::vector<T> weight{};
  std::vector<std::size_t> stage{};
  /// The terms of a row of coefficients that are not zero, times `scale`.
  StageSum(const std::vector<double>& row, double scale);
};

/// The sums for steps of one length, and the bounds beyond which such a step does not resolve a contact.
template <class T>
struct StepSums {
  double length = 0;
  std::vector<StageSum<T>> sums{};  ///< of the stages and, last, of the velocities
  T fast{}, tight{};  ///< the square of a frequency, and the smallest overlap that may have it
};

/**
A run consists of many short calls of the method, and allocating the stages anew in each would cost more
than the steps. So the memory is set up once and serves the whole run; outside the window of moving sites
it stays zero. It also keeps the weights $\sum_i b_i a_{ij}$ with which an error in the force reaches the
velocity through the stages, and the sums for the latest step lengths. */
template <class T>
struct NystromMemory {
  std::vector<std::vector<T>> y{}, a{};  ///< of the stages; the first y is that of the state
  std::vector<T> v{}, shift{};           ///< new velocities; what the stages' positions lacked
  std::vector<T> shift_weight{};         ///< $\sum_i b_i a_{ij}$
  std::vector<StepSums<T>> prepared{};  ///< for the latest steps, undivided, divided once and so on
  std::vector<const T*> row{};          ///< where the accelerations of the stages are
  std::vector<std::uint64_t> flag{};    ///< singular contacts,
  std::vector<std::size_t> contacts{};  ///< the list of them, ascending,
  std::vector<Impulse<T>> correction{};  ///< and what each one needs, zero for all the others
  T small;                               ///< overlap that is not worth a correction
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
What remains are errors in $h^5$ per switching, mostly from the quintic. The scheme is neither symplectic
nor reversible; its energy drifts by as much as its error.

All this takes the overlap within a step from the motion that the stages saw. Under a stiff contact, or one of
light beads, the overlap vibrates with the frequency $\omega$, $\omega^2 = \eta V''\,(1/\mu_n + 1/\mu_{n+1})$,
and once $\omega h$ is of order one it may close, turn round and open between two stages. The impulse is then that of a
motion which does not happen, and since the contact may be as short in half the step two resolutions can agree on it.
So a step in which a closed contact has $\omega h > 1/2$ is divided into halves, again and again, until
$\omega h < 1/8$ wherever a contact is closed. Both numbers are halved with the steps of a refinement (`finer`),
three times; then the contacts are as exact as rounding allows. Every other resolution begins with thirds, so that
two of them have no steps in common. Beads of unit mass whose overlaps are below four do not know of all this. */
struct EventCorrected {
  double step;  ///< the largest that it may take
  Nystrom base = dormand_prince_6();
  double negligible = 1e-19;  ///< contact force that is not worth a correction
  int finer = 0;              ///< how often the resolution of fast contacts is doubled
  int halvings = 0;  ///< how often a run halves the steps that `step` asks for (refinement.hpp)

  /**
  Ahead of a front one contact after the other closes with overlaps such as $10^{-10}$, $10^{-15}$,
  $10^{-23}$. A force below `negligible` is lost in the rounding of a velocity of $10^{-3}$, and such
  contacts are left alone. The memory knows the overlap at which the force is that small. */
  template <class T>
  NystromMemory<T> memory(const Chain& chain) const;

  /// Advances `state` by `count` steps of length `h`; returns the number of site-force evaluations.
  template <class T>
  double advance(const Chain& chain, State<T>& state, Window& window, double h, std::size_t count,
                 NystromMemory<T>& at) const;

  /// As the last function, with a memory of its own; enough for a run of a few steps.
  template <class T>
  double advance(const Chain& chain, State<T>& state, Window& window, double h,
                 std::size_t count) const {
    NystromMemory<T> at = memory<T>(chain);
    return advance(chain, state, window, h, count, at);
  }
};

}  // namespace lattice
