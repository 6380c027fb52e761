#include "sec5/travelling.hpp"

#include <stdexcept>
#include <utility>

namespace lattice {

// Reversible in time about a site at the start, about the next bond after half a period
Symmetry travelling_reversible(std::size_t half_length, bool free_period) {
  const std::size_t n0 = half_length, sites = 2 * half_length + 2;
  Symmetry s{.name = "travelling", .parts = 2, .free_period = free_period};
  for (std::size_t n = 1; n <= half_length; ++n) s.unknowns.push_back({{n0 + n, 1}, {n0 - n, -1}});
  s.unknowns.push_back({{sites + n0, 1}});
  for (std::size_t n = 1; n <= half_length; ++n)
    s.unknowns.push_back({{sites + n0 + n, 1}, {sites + n0 - n, 1}});
  // Odd positions and even velocities about the bond; a given period leaves one too many
  for (std::size_t n = 1; n <= half_length + 1; ++n) {
    if (n > 1 || free_period) s.equations.push_back({{{n0 + n, 1}, {n0 + 1 - n, 1}}});
    s.equations.push_back({{{sites + n0 + n, 1}, {sites + n0 + 1 - n, -1}}});
  }
  return s;
}

namespace {

// About its centre a travelling breather is odd in position and even in velocity
double asymmetry(const State<double>& z, std::size_t c) {
  double off = 0, size = 0;
  for (std::size_t j = 1; j <= 3; ++j) {
    const double y = z.y[c + j] + z.y[c - j], v = z.v[c + j] - z.v[c - j];
    off += y * y + v * v;
    size += z.y[c + j] * z.y[c + j] + z.v[c + j] * z.v[c + j] + z.y[c - j] * z.y[c - j] +
            z.v[c - j] * z.v[c - j];
  }
  return off / size;
}

// The half ahead of the centre determines the breather, the other one is its mirror image
Vector<double> front_half(const State<double>& z, std::size_t c, std::size_t half_length) {
  Vector<double> x(2 * Eigen::Index(half_length) + 1);
  for (std::size_t j = 0; j <= half_length; ++j) {
    if (j > 0) x[Eigen::Index(j) - 1] = z.y[c + j];
    x[Eigen::Index(half_length + j)] = z.v[c + j];
  }
  return x;
}

}  // namespace

State<double> between(const State<double>& a, const State<double>& b, double w) {
  State<double> z = a;
  for (std::size_t n = 0; n < z.y.size(); ++n) {
    z.y[n] += w * (b.y[n] - a.y[n]);
    z.v[n] += w * (b.v[n] - a.v[n]);
  }
  return z;
}

// Follow a packet and cut it out when it is most like a travelling breather
Vector<double> cut_packet(double velocity, double from, double to, int sign,
                          std::size_t half_length) {
  const Impact impact{.velocity = velocity,
                      .chain = {std::size_t(to) + 2 * half_length},
                      .time = 1e6,
                      .every = 0.1,
                      .until = to};
  State<double> before = struck(impact.chain.sites, velocity);
  Vector<double> best;
  double least = 1e300;
  strike(EventCorrected{0.1}, impact, [&](const State<double>& now, const std::vector<double>& e) {
    const auto c = front_packet(e);
    const double centre = c ? energy_centre(e, *c) : 0;
    // The largest site passes through zero in the right direction: how symmetrical is the packet?
    if (centre > from && before.y[*c] * now.y[*c] < 0 && sign * now.v[*c] > 0) {
      const State<double> z = between(before, now, before.y[*c] / (before.y[*c] - now.y[*c]));
      const double off = asymmetry(z, *c);
      if (off < least) least = off, best = front_half(z, *c, half_length);
    }
    before = now;
  });
  if (best.size() == 0) throw std::runtime_error("no packet passes between the sites");
  return best;
}

// Disturb the orbit, loosen the tolerance and find it again: the energies differ by their error
Estimate energy_of_type_one(std::size_t k, const Orbit<double>& orbit) {
  NewtonRule<double> coarse;
  coarse.events.tolerance *= 8;
  Orbit<double> off = orbit;
  off.x *= 1 + 1e-7;
  const auto problem = type_one<double>(k, orbit.start.y.size() / 2 - 1);
  return with_error(newton(problem, off, coarse).energy, orbit.energy);
}

// A straight line through two members predicts the next, but for the far tail
Orbit<double> next_member(const Orbit<double>& a, const Orbit<double>& b, double to,
                          std::size_t half_length, const NewtonRule<double>& rule) {
  Vector<double> x = b.x;
  const double ta = shift_time(a), tb = shift_time(b), top = sup(b.x);
  if (ta != tb)
    for (Eigen::Index i = 0; i < x.size(); ++i)
      if (std::abs(x[i]) > 1e-5 * top) x[i] += (b.x[i] - a.x[i]) * (to - tb) / (tb - ta);
  return newton(travelling_problem(to, 0, half_length), x, rule);
}

// Along the family in equal steps of the shift time
std::vector<Orbit<double>> follow_family(const Orbit<double>& start, double to, double step,
                                         const NewtonRule<double>& rule) {
  const std::size_t half_length = start.start.y.size() / 2 - 1;
  const double from = shift_time(start);
  const auto count = std::size_t(std::ceil(std::abs(to - from) / step));
  std::vector<Orbit<double>> members{start};
  Progress progress("members", count);
  for (std::size_t i = 1; i <= count; ++i) {
    const double t = from + (to - from) * double(i) / double(count);
    members.push_back(
        next_member(members[i > 1 ? i - 2 : 0], members.back(), t, half_length, rule));
    progress.tick();
  }
  return members;
}

// The secant method for the shift time at which V vanishes
Orbit<double> type_two(Orbit<double> a, Orbit<double> b, const NewtonRule<double>& rule) {
  const std::size_t half_length = a.start.y.size() / 2 - 1;
  for (int i = 0; i < 30 && std::abs(velocity_sum(b)) > 1e-12; ++i) {
    const double va = velocity_sum(a), vb = velocity_sum(b), ta = shift_time(a);
    const double t = shift_time(b) - vb * (shift_time(b) - ta) / (vb - va);
    if (t == shift_time(b)) break;
    Orbit<double> c = next_member(a, b, t, half_length, rule);
    a = std::move(b), b = std::move(c);
  }
  // An exact orbit satisfies all equations, with the shift time as one more unknown
  return newton(with_free_time(travelling_problem(shift_time(b), 0, half_length)),
                with_time(b.x, shift_time(b)), rule);
}

// The equations are all imposed, and the shift time is an unknown
Branch branch_in_s(const Orbit<double>& start, int direction, double longest) {
  const double time = shift_time(start);
  const auto problem = with_free_time(travelling_problem(time, 0, start.start.y.size() / 2 - 1));
  const Orbit<double> orbit = newton(problem, with_time(start.x, time));
  const Stride stride{.first = 0.02, .least = 1e-6, .most = longest};
  return {problem, along_s<double>(), orbit, direction, {}, stride};
}

}  // namespace lattice
