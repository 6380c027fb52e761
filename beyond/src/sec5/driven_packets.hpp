#pragma once
/**
# What the packets of a drive are

Are the packets of an array that is shaken or struck travelling breathers? Such a breather has a shift time $T$ and a phase
$\varphi$ from site to site, and these determine all else (packet_members.hpp). The families of the chain are one curve
$\varphi = 2\pi k-T$ for each $k$; a packet may lie between these curves, where energy and width are interpolated. $T$ is
measured as the mean time from one bead to the next, $\varphi$ as the mean angle by which the seven $z_n$ about the centre
have turned back. */

#include <limits>
#include <string>
#include <vector>

#include "report/program.hpp"
#include "sec5/driven_array.hpp"
#include "sec5/packet_members.hpp"

namespace lattice {

/// Whose packet is looked at: a piston that begins at once, or an impact of 1 m/s.
struct DrivenPacket {
  double strength =
      1.3;              ///< amplitude of the piston over the asymptotic threshold; 0 for an impact
  double lifetime = 0;  ///< ms; 0 without losses
  WatchedBeads stretch{};
};

/**
The oscillation within a packet makes all means fluctuate, and a packet changes on its way. So each packet is measured
four times, in four *looks*: on the whole stretch; on a stretch that begins two beads later, with twice the step; and on
either half of the stretch. The first look gives the value. Its error is the larger of two
numbers, the difference between the first two looks, and half of the difference between the last two. */
/// Four looks at a packet.
struct Looks {
  Traveller fine, coarse, before, after;

  /// A function of the packet, with the larger of the two differences.
  template <class Of>
  Estimate operator()(Of of) const {
    Estimate e = compare(of(coarse), of(fine));
    const double halves = std::abs(of(after) - of(before)) / 2;
    if (std::isnan(halves) || halves > e.error) e.error = halves;
    return e;
  }
};

/// Throws std::runtime_error if the packet has not passed.
Looks look_at(const DrivenPacket& p);

/// Whole for a breather that repeats itself one site further on.
double family_of(const Traveller& p);

/**
If the packet is a travelling breather its energy and width are no longer free: they must be those that the families have
at its shift time and phase. So the ratios of both have to be one, and nothing is fitted. For $(T+\varphi)/2\pi$ from 2 to
5 and $\varphi$ from -0.4 to 0.75 the members of the families are joined by polynomials; beyond there is no ratio. The
errors contain the change that is made by leaving out the farthest members. */
/// Members of the families, and what a packet has over them.
class Families {
 public:
  /// Whether the packet lies between the members that we have.
  bool cover(const Traveller& p) const;
  /// What they cover, in words.
  std::string range() const;
  /// Energy or width of a packet over that of the breather with its shift time and phase, from all looks.
  Estimate ratio(const Looks& looks, double Traveller::*of) const;
  /// By what a ratio would be multiplied if the phase were larger by `wrong`.
  Estimate mistimed(const Looks& looks, double Traveller::*of, double wrong) const;

 private:
  double over(const Traveller& p, double Traveller::*of, std::size_t left_out = 0) const;
  static constexpr std::size_t fastest = 2, slowest = 5;
  const std::vector<double> phases{-0.4, -0.2, 0, 0.25, 0.5, 0.75};
  MemberGrid members_ = member_grid(fastest, slowest, phases);
};

/// `sec5_driving packet --strength 1.3` tells what the first packet of a drive is.
struct OnePacket {
  static constexpr Title title{"packet", "what a packet of a driven or struck array is"};
  double strength = 1.3, lifetime = 0;
  std::size_t which = 1, from = 12, beads = 16;

  void parameters(Parameters& p);
  Table table() const;
};

}  // namespace lattice
