#include "sec5/driven_end.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lattice/model/dps.hpp"

namespace lattice {
namespace {

/// The first maximum of |u| (or |D|) on the way inward from a tail whose last bead has |u| = e^-depth.
double first_top(Drive::By by, double depth) {
  double u = std::exp(-depth), d = 0, last = 0;
  for (int k = 0; k < 200; ++k) {
    d += u;
    u -= d / std::cbrt(std::abs(d));
    const double now = by == Drive::By::piston ? std::abs(u) : std::abs(d);
    if (now < last) return last;
    last = now;
  }
  throw std::runtime_error("no maximum along the decaying solutions");
}

/// The highest of them among tails that begin at `depth` or deeper: the best of a grid, then by thirds. One step of the
/// map inward is one period of the curve in ln(depth).
double highest_top(Drive::By by, double depth) {
  constexpr int points = 256;
  const auto top = [&](double k) { return first_top(by, depth * std::pow(1.5, k / points)); };
  int best = 0;
  for (int k = 1; k < points; ++k)
    if (top(k) > top(best)) best = k;
  double low = best - 1, high = best + 1;
  for (int i = 0; i < 80; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (top(a) < top(b) ? low : high) = top(a) < top(b) ? a : b;
  }
  return top(low);
}

Estimate highest_top(Drive::By by) {
  return compare(highest_top(by, 90), highest_top(by, 60));
}

/// The amplitude is the last unknown.
State<double> state_of(const Vector<double>& x) {
  const std::size_t n = std::size_t(x.size()) / 2;
  State<double> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    out.y[i] = x[Eigen::Index(i)];
    out.v[i] = x[Eigen::Index(n + i)];
  }
  return out;
}

/// Counts the packets that pass a detector, from the highest energy in each period.
class PacketCounter {
 public:
  PacketCounter(double period, double floor) : period_(period), floor_(floor) {}

  void look(double t, double energy, std::vector<double>& passages) {
    highest_ = std::max(highest_, energy);
    if (t < next_) return;
    next_ += period_;
    const double now = highest_;
    highest_ = 0;
    if (inside_) {
      most_ = std::max(most_, now);
      if (now < most_ / 2) inside_ = false, least_ = now;
      return;
    }
    least_ = std::min(least_, now);
    if (now > 4 * least_ && now > floor_) inside_ = true, most_ = now, passages.push_back(t);
  }

 private:
  double period_, floor_, highest_ = 0, next_ = 0, least_ = 0, most_ = 0;
  bool inside_ = false;
};

}  // namespace

// The two numbers of the limit, and what they say of the array
Estimate dps_threshold(Drive::By by) {
  static const Estimate piston = highest_top(Drive::By::piston),
                        base = highest_top(Drive::By::base);
  return by == Drive::By::piston ? piston : base;
}

Estimate law_estimate(Drive::By by, double omega) {
  const double delta = omega - 1, root = 2 * tau_0() * delta;
  const double scale = (by == Drive::By::piston ? 2 : 4 * delta) * root * root;
  const Estimate top = dps_threshold(by);
  return {scale * top.value, scale * top.error};
}

double threshold_law(Drive::By by, double omega) {
  return law_estimate(by, omega).value;
}

// One period of the drive
Vector<double> DrivenOrbit::return_error(const Vector<double>& x) const {
  DrivenChain other = driven;
  other.drive.amplitude = x[x.size() - 1];
  State<double> state = state_of(x);
  const double period = 2 * std::numbers::pi / driven.drive.omega;
  const TimeGrid one{period, 1, steps};
  evolve(other, state, one);
  Vector<double> out(x.size() - 1);
  for (std::size_t i = 0; i < state.y.size(); ++i) {
    out[Eigen::Index(i)] = state.y[i] - x[Eigen::Index(i)];
    out[Eigen::Index(state.y.size() + i)] = state.v[i] - x[Eigen::Index(state.y.size() + i)];
  }
  return out;
}

// The last equation is that of the plane
Evaluation<double> DrivenOrbit::evaluate(const Vector<double>& x, bool with_jacobian) const {
  const Eigen::Index n = x.size();
  const auto error = [&](const Vector<double>& at) { return return_error(at); };
  Evaluation<double> out;
  out.residual.resize(n);
  out.residual.head(n - 1) = error(x);
  out.residual[n - 1] = (x - from).dot(along) - length * scale;
  if (!with_jacobian) return out;
  out.jacobian.resize(n, n);
  out.jacobian.topRows(n - 1) = central_differences<double>(error, x, 1e-6 * scale);
  out.jacobian.row(n - 1) = along.transpose();
  return out;
}

Equations<double> DrivenOrbit::equations() const {
  return {"the driven orbit",
          [*this](const Vector<double>& x, const EventTolerance<double>&, bool derivative) {
            return evaluate(x, derivative);
          },
          [size = scale](const Vector<double>& x, bool) {
            const Vector<double> all = Vector<double>::Constant(x.size(), size);
            return Sizes<double>{all, all};
          }};
}

// Steps along the curve, and a parabola through the three points about the largest amplitude
QuietOrbits quiet_orbits(const DrivenChain& driven, std::size_t steps, double apart,
                         double beyond) {
  const Eigen::Index n = Eigen::Index(2 * driven.chain.sites + 1);
  const double law = threshold_law(driven.drive.by, driven.drive.omega);
  const double size = threshold_law(Drive::By::piston, driven.drive.omega);
  DrivenOrbit problem{driven, steps};
  problem.scale = size;
  NewtonRule<double> rule;
  rule.events.tolerance = 1e-11;
  // Begin in the direction of the amplitude, from no motion at all
  Vector<double> at = Vector<double>::Zero(n);
  Vector<double> tangent = Vector<double>::Unit(n, n - 1);
  QuietOrbits out;
  std::vector<double> lengths;
  double gone = 0;
  problem.length = 0.2 * law / size;
  for (int k = 0; k < int(20 / apart); ++k) {
    problem.from = at, problem.along = tangent;
    const Vector<double> guess = at + problem.length * size * tangent;
    const Vector<double> next = newton(problem.equations(), guess, rule).x;
    const Vector<double> way = next - at;
    gone += way.norm() / size;
    tangent = way.normalized(), at = next;
    problem.length = apart;
    out.amplitude.push_back(at[n - 1]);
    out.response.push_back(std::hypot(at[0], at[n / 2]));
    lengths.push_back(gone);
    const std::size_t m = out.amplitude.size();
    if (m < 4 || out.amplitude[m - 1] > out.amplitude[m - 2]) continue;
    if (out.fold == 0) {
      // Newton's form of the parabola through three points
      const double s0 = lengths[m - 3], s1 = lengths[m - 2], s2 = lengths[m - 1];
      const double a0 = out.amplitude[m - 3], a1 = out.amplitude[m - 2], a2 = out.amplitude[m - 1];
      const double first = (a1 - a0) / (s1 - s0), second = (a2 - a1) / (s2 - s1);
      const double bend = (second - first) / (s2 - s0);
      const double top = (s0 + s1) / 2 - first / (2 * bend);
      out.fold = a0 + (top - s0) * (first + bend * (top - s1));
    }
    if (out.amplitude[m - 1] < beyond * out.fold) return out;
  }
  return out;
}

// Packets that pass in the second half of the run
double Emission::rate(double duration) const {
  const auto late =
      std::count_if(passages.begin(), passages.end(), [&](double t) { return t >= duration / 2; });
  return double(late) / (duration / 2);
}

double Emission::spread(double duration) const {
  std::vector<double> gaps;
  for (std::size_t k = 1; k < passages.size(); ++k)
    if (passages[k - 1] >= duration / 2) gaps.push_back(passages[k] - passages[k - 1]);
  if (gaps.size() < 3) return -1;
  double mean = 0, square = 0;
  for (double g : gaps) mean += g / double(gaps.size());
  for (double g : gaps) square += (g - mean) * (g - mean) / double(gaps.size());
  return std::sqrt(square) / mean;
}

bool Emission::lasts(double duration, double silence) const {
  return !passages.empty() && passages.back() + silence > duration;
}

/// The largest modulus in a step, in which the motion turns round once at most.
static double farthest(const Quintic& x) {
  const double ends = std::max(std::abs(x.x0), std::abs(x.x1));
  return (x.w0 > 0) != (x.w1 > 0) ? std::max(ends, std::abs(x(x.turn()))) : ends;
}

// What passes the detector, and what the drive gives
Emission drive_chain(const DrivenChain& driven, double duration, std::size_t detector, double step,
                     std::size_t enough, double silence) {
  const double a = std::max(driven.drive.amplitude, driven.drive.from);
  const double size = driven.drive.by == Drive::By::piston ? a : a / (driven.drive.omega - 1);
  PacketCounter counter(2 * std::numbers::pi / driven.drive.omega, 0.03 * size * size);
  Emission out;
  State<double> state(driven.chain.sites);
  double half = 0;
  // The middle of the run is a look. The looks of fine steps lie closer, because the maximum in a period depends on them
  TimeGrid grid = time_grid(duration / 2, std::min(0.4, 5 * step), step);
  grid.duration = duration, grid.samples *= 2;
  const double h = grid.interval();
  Quintic way{};
  out.budget = evolve(driven, state, grid, [&](const State<double>& now, const EnergyBudget& l) {
    const double y = now.y[detector - 1], v = now.v[detector - 1];
    const double density = (y * y + v * v) / 2;
    counter.look(now.t, density, out.passages);
    out.loudest = std::max(out.loudest, density / (size * size));
    const double a = acceleration(driven.chain, now.y.data(), 0) +
                     driven.drive.force(now.t, now.y[0]) - driven.losses.rate * now.v[0];
    way = {way.x1, way.w1, way.g1, now.y[0], h * now.v[0], h * h * a / 2};
    if (now.t < (duration + h) / 2)
      half = l.work;
    else
      out.response = std::max(out.response, farthest(way));
    out.power = (l.work - half) / (duration / 2);
    out.far = std::max(out.far, std::abs(now.y.back()));
    const double heard = out.passages.empty() ? 0 : out.passages.back();
    const bool lasting = std::isfinite(silence) && out.lasts(duration, silence);
    return out.passages.size() < enough && now.t < heard + silence && !lasting;
  });
  return out;
}

// The largest energy of every site in each of `bins` spans of time
std::vector<double> drive_map(const DrivenChain& driven, double duration, std::size_t bins,
                              double step) {
  const std::size_t sites = driven.chain.sites;
  std::vector<double> map(bins * sites, 0.0);
  State<double> state(sites);
  evolve(driven, state, time_grid(duration, 0.8, step),
         [&](const State<double>& now, const EnergyBudget&) {
           const std::size_t bin = std::min(bins - 1, std::size_t(now.t / duration * double(bins)));
           for (std::size_t n = 0; n < sites; ++n) {
             const double e = (now.y[n] * now.y[n] + now.v[n] * now.v[n]) / 2;
             map[bin * sites + n] = std::max(map[bin * sites + n], e);
           }
           return true;
         });
  return map;
}

// Halve the interval until it is short enough
Estimate bisect_threshold(double quiet, double emits, double accuracy,
                          const std::function<bool(double)>& does_emit) {
  if (does_emit(quiet) || !does_emit(emits))
    throw std::runtime_error("the threshold is not between " + std::to_string(quiet) + " and " +
                             std::to_string(emits));
  while (emits - quiet > accuracy * emits) {
    const double middle = (quiet + emits) / 2;
    (does_emit(middle) ? emits : quiet) = middle;
  }
  return {(quiet + emits) / 2, (emits - quiet) / 2};
}

// The lowest that emits and the highest that is quiet may lie on either side of each other
Estimate threshold_among(double centre, double apart, int side,
                         const std::function<bool(double)>& does_emit) {
  std::vector<double> quiet, loud;
  for (int k = -side; k <= side; ++k) {
    const double a = centre + k * apart;
    (does_emit(a) ? loud : quiet).push_back(a);
  }
  if (quiet.empty() || loud.empty() || loud.front() < quiet.front() || quiet.back() > loud.back())
    throw std::runtime_error("the threshold is not between " +
                             std::to_string(centre - side * apart) + " and " +
                             std::to_string(centre + side * apart));
  return {(quiet.back() + loud.front()) / 2, std::abs(quiet.back() - loud.front()) / 2};
}

}  // namespace lattice
