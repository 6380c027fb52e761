#pragma once
/**
# A kick with your own parameters

`sec33_mobility kick --centre bond --omega 1.1 --c 2e-4` kicks one breather along its discrete gradient (kick.hpp). The
run ends early if the breather comes within eight sites of an end of its chain. If less than nine tenths of the energy
stays together, the breather has broken up, and that is an error; so is a chain too short for the breather. Errors come
from two step sizes and, unless `--sites` is given, from two chains, of which the longer one has the smaller step. A
breather that has moved less than one site has no speed: it is `nan`.

`sec33_mobility threshold --centre bond --omega 1.1` finds the least kick that frees it (kick_threshold.hpp), takes some
seconds and refuses an unstable centre. */

#include "sec3/breather_options.hpp"
#include "sec33/kick_threshold.hpp"

namespace lattice {

/// Which breather is kicked, on which chain.
struct KickedBreather : ChosenBreather {
  KickedBreather() { centre = Centre::bond; }
  /// Declares them.
  void parameters(Parameters& p);
  /// The breather before the kick. Throws UsageError, NewtonFailed.
  RestingBreather at_rest() const;
};

/// The command `kick`.
struct OneKick : KickedBreather {
  static constexpr Title title{"kick", "speed of a breather after a kick"};
  double c = 2e-4, time = 20000;

  /// Declares size and duration too.
  void parameters(Parameters& p);
  /// What the program prints.
  Table table() const;
};

/// The command `threshold`.
struct OneThreshold : KickedBreather {
  static constexpr Title title{"threshold", "the kick that frees a pinned breather"};
  /// What the program prints.
  Table table() const;
};

}  // namespace lattice
