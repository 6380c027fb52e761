#include "sec5/driven_array.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
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
  throw std::runtime_error("no maximum is found along the decaying solutions");
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
  return with_error(highest_top(by, 90), highest_top(by, 60));
}

}  // namespace

// The two numbers of the limit, and what they say of the array
Estimate dps_threshold(Drive::By by) {
  static const Estimate piston = highest_top(Drive::By::piston),
                        base = highest_top(Drive::By::base);
  return by == Drive::By::piston ? piston : base;
}

Estimate threshold_law(Drive::By by, double omega) {
  const double delta = omega - 1, root = 2 * tau_0() * delta;
  const double scale = (by == Drive::By::piston ? 2 : 4 * delta) * root * root;
  const Estimate top = dps_threshold(by);
  return {scale * top.value, scale * top.error};
}

Estimate asymptotic_threshold(Drive::By by, double omega, double nu) {
  const double delta = omega - 1, law = threshold_law(by, omega).value;
  return {law, law * ((by == Drive::By::piston ? 1.3 : 3.5) * delta + std::pow(nu / delta, 2))};
}

double drive_size(const Drive& drive) {
  const double a = std::max(drive.amplitude, drive.from);
  return drive.by == Drive::By::piston ? a : a / (drive.omega - 1);
}

PacketCounter::PacketCounter(const Drive& drive)
    : period_(2 * std::numbers::pi / drive.omega),
      floor_(0.03 * drive_size(drive) * drive_size(drive)) {}

// Once in a period
bool PacketCounter::passes(double t, double energy) {
  highest_ = std::max(highest_, energy);
  if (t < next_) return false;
  next_ += period_;
  const double now = highest_;
  highest_ = 0;
  if (inside_) {
    most_ = std::max(most_, now);
    if (now < most_ / 2) inside_ = false, least_ = now;
    return false;
  }
  least_ = std::min(least_, now);
  if (!(now > 4 * least_ && now > floor_)) return false;
  inside_ = true, most_ = now;
  return true;
}

TimeGrid two_halves(double duration, double step) {
  TimeGrid grid = time_grid(duration / 2, std::min(0.4, 5 * step), step);
  grid.duration = duration, grid.samples *= 2;
  return grid;
}

// Packets that pass in the second half of the run
double Emission::rate(double duration) const {
  const auto late =
      std::count_if(passages.begin(), passages.end(), [&](double t) { return t >= duration / 2; });
  return double(late) / (duration / 2);
}

namespace {

/// The largest modulus in a step, in which a bead turns round once at most.
double farthest(const Quintic& x) {
  const double ends = std::max(std::abs(x.x0), std::abs(x.x1));
  return (x.w0 > 0) != (x.w1 > 0) ? std::max(ends, std::abs(x(x.turn()))) : ends;
}

}  // namespace

// What passes the detector, and what the drive gives
Emission drive_chain(const DrivenChain& driven, double duration, std::size_t detector, double step,
                     const Enough& enough) {
  PacketCounter counter(driven.drive);
  Emission out;
  State<double> state(driven.chain.sites);
  double half = 0;
  const TimeGrid grid = two_halves(duration, step);
  const double h = grid.interval();
  Quintic way{};
  out.budget = evolve(driven, state, grid, [&](const State<double>& now, const EnergyBudget& l) {
    const double y = now.y[detector - 1], v = now.v[detector - 1];
    if (counter.passes(now.t, (y * y + v * v) / 2)) out.passages.push_back(now.t);
    const double a = acceleration(driven.chain, now.y.data(), 0) +
                     driven.drive.force(now.t, now.y[0]) - driven.losses.rate * now.v[0];
    way = {way.x1, way.w1, way.g1, now.y[0], h * now.v[0], h * h * a / 2};
    if (now.t < (duration + h) / 2)
      half = l.work;
    else
      out.response = std::max(out.response, farthest(way));
    out.power = (l.work - half) / (duration / 2);
    out.far = std::max(out.far, std::abs(now.y.back()));
    return !enough || !enough(out, now.t);
  });
  return out;
}

DrivenChain DrivenArray::driven() const {
  return {Chain{beads},
          {rate(lifetime), 0},
          {by, omega(frequency), amplitude / micrometres(1), 0, horizon() / 6}};
}

Emission DrivenArray::run(double h) const {
  return drive_chain(driven(), horizon(), detector, h);
}

// What comes back from the far end is no answer to the drive, and such an array is too short
std::vector<DrivenQuantity> DrivenArray::quantities() const {
  DrivenArray array = *this;
  Emission coarse = array.run(2 * step);
  for (; coarse.far > 1e-9 * amplitude / micrometres(1); coarse = array.run(2 * step))
    array.beads *= 2;
  const Emission fine = array.run(step), between = array.run(1.65 * step);
  // What steps leave depends on where in a step a contact opens or closes, and two runs may agree by chance
  const auto of = [&](auto what) {
    Estimate e = with_error(double(what(coarse)), double(what(fine)));
    e.error = std::max(e.error, std::abs(what(between) - e.value));
    return e;
  };
  std::vector<DrivenQuantity> out{
      {"outcome", of([](const Emission& e) { return int(!e.passages.empty()); }), "",
       "1 if a packet passes bead 20, otherwise 0"},
      {"emitted_per_second",
       of([&](const Emission& e) { return e.rate(horizon()) * per_second(1); }), "1/s",
       "packets per second that pass bead 20 in the second half of the run"},
      {"power", of([&](const Emission& e) { return watts(e.power); }), "W",
       "mean power of the drive in the second half of the run"},
      {"response", of([&](const Emission& e) { return micrometres(e.response); }), "um",
       "largest displacement of the first bead in the second half of the run"},
      {"budget", of([](const Emission& e) { return e.budget; }), "",
       "energy plus losses minus work, divided by the largest energy present or supplied; zero up "
       "to numerical errors"}};
  if (omega(frequency) <= 1) return out;
  const Estimate law = asymptotic_threshold(by, omega(frequency), rate(lifetime));
  out.push_back({"threshold_law",
                 {micrometres(law.value), micrometres(law.error)},
                 "um",
                 "amplitude at the fold of the non-emitting motion, by the asymptotic law of small "
                 "amplitudes; the error is that of the law"});
  return out;
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
