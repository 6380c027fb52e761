#include "sec5/packet_members.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>

#include "lattice/diagnostics/observe.hpp"
#include "lattice/numerics/parallel.hpp"
#include "sec5/travelling.hpp"

namespace lattice {
namespace {

/// The value at x of Lagrange's polynomial through the points, but for the farthest.
double interpolated(double x, const std::vector<double>& xs, const std::vector<double>& ys,
                    std::size_t left_out) {
  std::vector<std::size_t> order(xs.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(xs[a] - x) < std::abs(xs[b] - x);
  });
  order.resize(order.size() - left_out);
  double sum = 0;
  for (std::size_t i : order) {
    double w = ys[i];
    for (std::size_t j : order)
      if (j != i) w *= (x - xs[j]) / (xs[i] - xs[j]);
    sum += w;
  }
  return sum;
}

/// A member, set free in a resting chain and seen over two sites; its own T and phase are known.
Traveller run_member(const Orbit<double>& member, double phase) {
  const DrivenChain driven{Chain{32}};
  const double T = shift_time(member);
  const WatchedBeads two{usual_half_length + 3, usual_half_length + 5, 1};
  const Traveller seen =
      traveller_on(driven, embed(member.start, driven.chain.sites, 0), 8 * T, 0.1, two);
  return {T, phase, seen.energy, seen.width};
}

}  // namespace

TravellerWatch::TravellerWatch(const Chain& chain, std::size_t from, std::size_t to,
                               std::size_t which)
    : chain_(chain), from_(from - 1), to_(to - 1), which_(which), wanted_(which) {
  if (from <= half_width || to <= from || to + 2 * half_width > chain.sites || which == 0)
    throw std::invalid_argument("no packet can be followed from bead " + std::to_string(from) +
                                " to " + std::to_string(to));
}

// A packet arrives when the largest density nearby moves up to the site. Where two are nearby, the largest density may
// be now in one and now in the other, and only one that passes the site itself has come
bool TravellerWatch::arrives(const std::vector<double>& density) {
  const auto first = density.begin() + std::ptrdiff_t(from_ - half_width);
  const auto most = std::size_t(std::max_element(first, first + 2 * half_width + 1) - first);
  const bool here = most == half_width || most == half_width + 1, came = before_ && here;
  if (most + 2 <= half_width)
    before_ = true;
  else if (most >= half_width)
    before_ = false;
  return came && --wanted_ == 0;
}

TravellerWatch::Crossing TravellerWatch::seen(const State<double>& now) const {
  Crossing out{now.t, {}};
  for (std::size_t n = next_ - half_width; n <= next_ + half_width; ++n)
    out.z.push_back(std::polar(1.0, now.t) * std::complex<double>(now.y[n], now.v[n]));
  return out;
}

bool TravellerWatch::look(const State<double>& now) {
  const std::vector<double> density = energy_density(chain_, now);
  const bool begins = wanted_ > 0 && arrives(density);
  if (wanted_ > 0) return true;
  // The peak moves on by two sites at most
  const auto first = density.begin() + std::ptrdiff_t(begins ? from_ : peak_ - 1);
  peak_ = std::size_t(std::max_element(first, first + (begins ? 1 : 4)) - density.begin());
  const double centre = energy_centre(density, peak_, half_width) - 1;
  if (begins) next_ = std::size_t(std::ceil(centre));
  // What it was when the centre passed the next bead
  while (!begins && centre >= double(next_)) {
    const double w = (double(next_) - centre_) / (centre - centre_);
    Crossing crossing = seen(last_);
    const Crossing after = seen(now);
    crossing.t += w * (after.t - crossing.t);
    for (std::size_t i = 0; i < crossing.z.size(); ++i)
      crossing.z[i] += w * (after.z[i] - crossing.z[i]);
    crossings_.push_back(std::move(crossing));
    if (next_++ == to_) return false;
  }
  if (!crossings_.empty()) {
    const auto near = density.begin() + std::ptrdiff_t(peak_ - half_width);
    log_energy_ += std::log(window_sum(density, peak_, half_width));
    width_ += participation({near, near + 2 * half_width + 1});
    ++samples_;
  }
  centre_ = centre, last_ = now;
  return true;
}

// Means over the beads that were passed: of time and phase from one to the next, of energy and width
Traveller TravellerWatch::traveller() const {
  if (next_ <= to_ || crossings_.size() < 2)
    throw std::runtime_error("packet " + std::to_string(which_) + " has not passed the beads " +
                             std::to_string(from_ + 1) + " to " + std::to_string(to_ + 1) +
                             " by the end of the run");
  const double steps = double(crossings_.size() - 1);
  double phase = 0;
  for (std::size_t i = 1; i < crossings_.size(); ++i) {
    std::complex<double> turn = 0;
    for (std::size_t j = 0; j < crossings_[i].z.size(); ++j)
      turn += crossings_[i - 1].z[j] * std::conj(crossings_[i].z[j]);
    phase += std::arg(turn) / steps;
  }
  return {(crossings_.back().t - crossings_.front().t) / steps, phase,
          std::exp(log_energy_ / samples_), width_ / samples_};
}

Traveller traveller_on(const DrivenChain& driven, State<double> start, double duration, double step,
                       const WatchedBeads& stretch) {
  TravellerWatch watch(driven.chain, stretch.from, stretch.to, stretch.which);
  evolve(driven, start, time_grid(duration, 2 * step, step),
         [&](const State<double>& now, const EnergyBudget&) { return watch.look(now); });
  return watch.traveller();
}

// Each family from its orbit of type I, once to the larger phases and once to the smaller ones
MemberGrid member_grid(std::size_t fastest, std::size_t slowest,
                       const std::vector<double>& phases) {
  NewtonRule<double> rule;
  rule.events.tolerance = 1e-9;
  TypeOneOrbits orbits(1, usual_half_length, rule);
  std::vector<Orbit<double>> starts;
  for (std::size_t k = slowest; k >= fastest; --k) starts.push_back(orbits.orbit_at(k));
  const auto zero = std::size_t(std::find(phases.begin(), phases.end(), 0) - phases.begin());
  if (zero == phases.size()) throw std::invalid_argument("the list of phases must contain 0");
  MemberGrid grid{phases, std::vector(phases.size(), std::vector<Traveller>(starts.size()))};
  parallel_for(2 * starts.size(), [&](std::size_t i) {
    const std::size_t family = i / 2;
    Orbit<double> last = starts[family], now = last;
    const double from = shift_time(now);
    for (std::size_t p = zero; p < phases.size(); i % 2 ? ++p : --p) {
      const double T = from - phases[p];
      if (p != zero) {
        const Orbit<double> next = next_member(last, now, T, usual_half_length, rule);
        last = now, now = next;
      }
      if (p != zero || i % 2) grid.members[p][family] = run_member(now, phases[p]);
    }
  });
  return grid;
}

// Along the families first, then from phase to phase
Traveller member_like(const MemberGrid& grid, const Traveller& p, std::size_t left_out) {
  std::vector<double> log_scaled, width;
  for (const auto& row : grid.members) {
    std::vector<double> speed, logs, widths;
    for (const Traveller& m : row) {
      speed.push_back(1 / m.shift_time), widths.push_back(m.width);
      logs.push_back(std::log(m.energy) + 4 * std::log(m.shift_time));
    }
    log_scaled.push_back(interpolated(1 / p.shift_time, speed, logs, left_out));
    width.push_back(interpolated(1 / p.shift_time, speed, widths, left_out));
  }
  const double e = interpolated(p.phase, grid.phases, log_scaled, left_out);
  return {p.shift_time, p.phase, std::exp(e - 4 * std::log(p.shift_time)),
          interpolated(p.phase, grid.phases, width, left_out)};
}

double family_of(const Traveller& p) {
  return (p.shift_time + p.phase) / (2 * std::numbers::pi);
}

double Families::over(const Traveller& p, double Traveller::*of, std::size_t left_out) const {
  const double k = family_of(p);
  const bool between =
      k >= 2 && k <= 5 && p.phase >= grid.phases.front() && p.phase <= grid.phases.back();
  return between ? p.*of / (member_like(grid, p, left_out).*of)
                 : std::numeric_limits<double>::quiet_NaN();
}

Estimate Families::ratio(const Looks& looks, double Traveller::*of) const {
  Estimate e = looks([&](const Traveller& p) { return over(p, of); });
  e.error += std::abs(over(looks.fine, of, 1) - e.value);
  return e;
}

}  // namespace lattice
