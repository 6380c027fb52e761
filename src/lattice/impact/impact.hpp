#pragma once
/**
# Striking a chain

Several sections of the article strike the first bead of a resting chain, Eq. (26),
$$y_n(0) = 0,\qquad \dot y_1(0) = v_0,\qquad \dot y_n(0) = 0 \text{ for } n \ge 2,$$
and ask what travels away. All of them use the loop in time of this file. It watches the energy and the packet, and it sees
to it that nothing comes back from the far end. */

#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "lattice/diagnostics/path.hpp"
#include "lattice/integrators/refinement.hpp"
#include "lattice/model/chain.hpp"

namespace lattice {

/**
A far end that the motion reaches sends it back, and what comes back is no property of the impact. In front of
everything else run linear waves or, if the contacts are not compressed, strongly nonlinear pulses. Wells of stiffness
$k$ and contacts of stiffness $K$ let phonons travel at half the width of their band at most,
$c = \frac12(\sqrt{k+4K}-\sqrt k)$ sites per unit of time. The strongest pulse of an impact has the overlap $x$ at most
whose energy is $x^{\alpha+1}/(\alpha+1) = \frac25 v_0^2$, and the speed of the sound for which $K = \frac45 v_0^2/x^2$.
We insert the larger of this and the stiffness at rest, and add 15 per cent and a hundred sites. This is an estimate and
not a bound: a run refuses to give a result if the velocity of its last bead exceeds `far_end` times the impact's. */
/// For `far_end`: the far end may move, as part of the experiment.
inline constexpr double may_move = std::numeric_limits<double>::infinity();

/// Thrown if the motion reaches the far end; the message says when and by how much.
struct FarEndReached : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Which packet is followed: the one that is ahead of all others, or the one around the strongest site.
enum class WhichPacket { foremost, strongest };

/// What is struck, and how it is watched; dimensionless, as in Eqs. (9), (10) and (26). By default the
/// impact of the article's section 3.4.
struct Impact {
  double velocity = 1.87;
  Chain chain{100};
  double time = 600;
  double every = 0.2;     ///< time between two looks, at most
  double far_end = 1e-9;  ///< the last bead's largest velocity allowed, over `velocity`
  bool denser = true;     ///< a refinement (refinement.hpp) also takes more samples
  /// The site at which the run ends, once the packet's centre has passed it.
  std::optional<double> until{};
  WhichPacket packet = WhichPacket::foremost;
};

/// The same impact on a chain so long that, by estimate, nothing crosses it in that time; its own length is ignored.
/// Throws std::invalid_argument for a chain with masses and stiffnesses, since how they go on is not known.
Impact on_long_chain(Impact impact);

/// The chain at rest but for its first bead, Eq. (26). Throws std::invalid_argument without sites.
State<double> struck(std::size_t sites, double velocity);

/// What comes out of a run.
struct ImpactRun {
  State<double> end{};
  Path path{};
  std::vector<double> density{};  ///< energy density at the end
  Run run{};
  double largest_displacement = 0;  ///< of all that were seen, to be compared with the well's rim
  double far_end = 0;               ///< largest velocity of the last bead
};

/// Whether the last bead has moved no more than `impact` allows: nothing can have come back from it.
bool is_quiet(const Impact& impact, const ImpactRun& run);

/// Sees every sample: the state and its energy density, Eq. (23). It may return false to end the run.
using ImpactLook = Observer<State<double>, std::vector<double>>;

/**
Samples become denser together with the steps of a refinement, so that the error of a maximum between two samples shows in
the difference of two runs. Then a run may only stop at instants that the coarser one samples as well. */
/// The whole run from the impact on, Eq. (26) followed by `evolve`. Throws FarEndReached if the far end moves.
ImpactRun strike(const Method& method, const Impact& impact, const ImpactLook& watch = {});

/// Carries a run on from where it is to `time`; in between the chain or the method may have been changed.
void continue_strike(const Method& method, const Impact& impact, ImpactRun& run, double time,
                     const ImpactLook& watch = {});

/// The sum of a density.
double total(const std::vector<double>& e);

/// Share of the first `sites` sites in a density: what an impact leaves at the boundary.
double boundary_share(const std::vector<double>& e, std::size_t sites = 5);

/// The site, from one, of the largest entry of a density behind the first `sites`; nothing where all are zero.
std::optional<std::size_t> strongest_site(const std::vector<double>& e, std::size_t sites = 5);

}  // namespace lattice
