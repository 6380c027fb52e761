#include "sec5/driven_packets.hpp"

#include <cmath>
#include <numbers>

namespace lattice {

// The piston begins at once, at a tenth above the beams' frequency
static Traveller packet_seen(const DrivenPacket& p, double step, const WatchedBeads& stretch) {
  const double delta = 0.1, omega = 1 + delta;
  ArraySetup setup;
  setup.lifetime = p.lifetime;
  const auto by = p.strength > 0 ? Drive::By::piston : Drive::By::nothing;
  const double a = p.strength * threshold_law(Drive::By::piston, omega);
  // So long that earlier packets are not back from the far end before the fifth has passed
  State<double> start(2 * ArraySetup::sites);
  if (p.strength == 0) start.v[0] = setup.velocity(1);
  return traveller_on(setup.driven(by, omega, a, 0, 0, start.y.size()), start, 300 / delta, step,
                      stretch);
}

Looks look_at(const DrivenPacket& p) {
  const auto [from, to, which] = p.stretch;
  const std::size_t middle = (from + to) / 2;
  return {packet_seen(p, 0.1, p.stretch), packet_seen(p, 0.2, {from + 2, to, which}),
          packet_seen(p, 0.1, {from, middle, which}), packet_seen(p, 0.1, {middle, to, which})};
}

double family_of(const Traveller& p) {
  return (p.shift_time + p.phase) / (2 * std::numbers::pi);
}

bool Families::cover(const Traveller& p) const {
  const double k = family_of(p);
  return k >= fastest && k <= slowest && p.phase >= phases.front() && p.phase <= phases.back();
}

std::string Families::range() const {
  const auto between = [](const char* name, double a, double b) {
    return name + short_text(a) + " to " + short_text(b);
  };
  return between("the members that we have: family ", fastest, slowest) +
         between(", phase ", phases.front(), phases.back());
}

double Families::over(const Traveller& p, double Traveller::*of, std::size_t left_out) const {
  if (!cover(p)) return std::numeric_limits<double>::quiet_NaN();
  return p.*of / (member_like(members_, p, left_out).*of);
}

Estimate Families::ratio(const Looks& looks, double Traveller::*of) const {
  Estimate e = looks([&](const Traveller& p) { return over(p, of); });
  e.error += std::abs(over(looks.fine, of, 1) - e.value);
  return e;
}

Estimate Families::mistimed(const Looks& looks, double Traveller::*of, double wrong) const {
  return looks([&](const Traveller& p) {
    Traveller later = p;
    later.phase += wrong;
    return over(later, of) / over(p, of);
  });
}

void OnePacket::parameters(Parameters& p) {
  p.add("strength", strength,
        "amplitude of the piston over the asymptotic threshold; 0: an impact of 1 m/s", {0, 2.4});
  p.add("lifetime", lifetime, "of the energy of a beam, in ms; 0: no losses", {0, 1e6, "ms"});
  p.add("which", which, "packet that comes to the first bead", {1, 5});
  p.add("from", from, "first bead of the stretch on which it is measured", {5, 70});
  p.add("beads", beads, "length of the stretch", {8, 40});
}

Table OnePacket::table() const {
  const Looks looks = look_at({strength, lifetime, {from, from + beads, which}});
  const Families families;
  const std::string beyond = "at least one of four looks lies outside of " + families.range();
  Answers q;
  q.add("shift_time", looks([](const Traveller& p) { return p.shift_time; }), "tau_c",
        "time from site to site");
  q.add_small("phase", looks([](const Traveller& p) { return p.phase; }), "",
              "phase from site to site, in the frame of a free bead");
  q.add("family", looks(family_of), "",
        "shift time and phase over 2 pi, a whole number for an exact breather");
  q.add("energy", looks([](const Traveller& p) { return p.energy; }), "units of the chain",
        "geometric mean in time of the energy on the seven sites about the peak");
  q.add("energy_ratio", families.ratio(looks, &Traveller::energy), "",
        "energy over that of the family's member with this shift time and phase", beyond);
  q.add("width_ratio", families.ratio(looks, &Traveller::width), "",
        "mean participation number of these sites over that of the same member", beyond);
  return q.table;
}

}  // namespace lattice
