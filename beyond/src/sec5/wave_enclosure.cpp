#include "sec5/wave_enclosure.hpp"

#include <Eigen/LU>

#include "lattice/algebra/dense.hpp"
#include "sec5/fineness.hpp"
#include "sec5/kernel_wave.hpp"

namespace lattice {

namespace {

using Number = Interval<double>;
using Numbers = std::vector<Number>;

const Number one(1), two(2);

/// Times from -infinity to infinity: which cell is meant, whether it is mirrored, whether there is none.
struct Cell {
  std::size_t index;
  bool mirrored, none;
};

Cell cell_at(const CubicLine& d, long index) {
  const bool mirrored = index < 0;
  const auto i = std::size_t(mirrored ? -1 - index : index);
  return {i, mirrored, i >= d.cell.size()};
}

}  // namespace

void WaveFineness::check() const {
  demand_power("per_turn", per_turn, 4, 1 << 24);
  demand_within("turns", turns, 1, 64);
  demand_power("nodes", nodes, 4, per_turn);
  demand_within("window", window, 1, turns);
}

/**
The slopes at the nodes come from differences of the fourth order. */
CubicLine wave_guess(int sign, const WaveFineness& fineness) {
  fineness.check();
  const KernelWave wave = wave_of_type_one(1, sign, {1.5, 0}, {24, 0.4});
  CubicLine line{fineness.per_turn, std::vector<Cubic>(fineness.per_turn * fineness.turns)};
  const double h = line.step().middle();
  const long last = long(line.cell.size());
  std::vector<double> at;
  for (long i = -2; i <= last + 2; ++i) at.push_back(wave.line.at(wave.d, double(i) * h));
  const auto rise = [&](std::size_t i) {
    return (8 * (at[i + 3] - at[i + 1]) - (at[i + 4] - at[i])) / 12;
  };
  for (std::size_t i = 0; i < line.cell.size(); ++i) {
    const double apart = at[i + 3] - at[i + 2], left = rise(i), right = rise(i + 1);
    line.cell[i] = {at[i + 2], left, 3 * apart - 2 * left - right, left + right - 2 * apart};
  }
  return line;
}

namespace {

/// What the residual needs of the force on one cell.
struct Force {
  Number start{};   ///< f at the beginning of the cell
  Number change{};  ///< f' on the cell
};

Force force_on(const CubicLine& d, long index) {
  const Cell at = cell_at(d, index);
  if (at.none) return {};
  const Cubic& c = d.cell[at.index];
  const Number all(0, 1), by_t = first_derivative(c, all) / d.step();
  const Number change = 1.5 * root(value(c, all)) * by_t;
  return {hertz(value(c, Number(at.mirrored ? 1.0 : 0.0))), at.mirrored ? -change : change};
}

}  // namespace

std::vector<double> wave_residuals(const CubicLine& d, const ForceIntegrals& integrals) {
  const long turn = long(d.per_turn), cells = long(d.cell.size());
  const Number h = d.step(), all(0, 1);
  std::vector<Force> force;
  Number most{};
  for (long i = -turn; i < cells + turn; ++i) {
    force.push_back(force_on(d, i));
    const Cell at = cell_at(d, i);
    if (!at.none) most = Number(std::max(most.upper, hertz(value(d.cell[at.index], all)).upper));
  }
  // |K * f| <= 8 sup f and |(K * f)''| <= 12 sup f
  const Number curved = Number(0, 1) * h * Number(12) * Number(-most.upper, most.upper);
  std::vector<double> out;
  Number image = integrals.image(0);
  for (long i = 0; i < cells; ++i) {
    const Cubic& c = d.cell[i];
    const Force &before = force[i], &here = force[i + turn], &after = force[i + 2 * turn];
    const Number next = integrals.image(std::size_t(i) + 1);
    const Number left = value(c, Number(0)) - image, right = value(c, Number(1)) - next;
    const Number second =
        2 * c[2] / (h * h) + image - (after.start - two * here.start + before.start);
    const Number third =
        Number(6) * c[3] / (h * h * h) - ((after.change - two * here.change + before.change) -
                                          (integrals.image_slope(std::size_t(i)) + curved));
    const Number inside = h * h / Number(8) * (abs(second) + h * abs(third));
    out.push_back((Number(std::max(magnitude(left), magnitude(right))) + inside).upper);
    image = next;
  }
  Number behind{};
  for (long i = cells - turn; i < cells; ++i) behind += h * hertz(value(d.cell[i], all));
  out.push_back(behind.upper);
  return out;
}

WaveProof::WaveProof(const CubicLine& d, const WaveFineness& fineness)
    : fine_((fineness.check(), fineness)), angles_(fineness.per_turn) {
  demand(d.per_turn == fineness.per_turn, "per_turn", std::to_string(fineness.per_turn),
         std::to_string(d.per_turn) + ", as in the guess");
  demand(d.cell.size() >= fineness.window * fineness.per_turn, "window",
         std::to_string(fineness.window), "not beyond the end of the guess");
  const Number h = d.step();
  std::vector<double> area;
  for (std::size_t p = 0; p < d.cell.size(); ++p) {
    range_.push_back(value(d.cell[p], Number(0, 1)));
    const bool inside = p < fine_.window * fine_.per_turn;
    stiffness_.push_back(inside ? hertz_slope(range_[p]).middle() : 0);
    area.push_back((h * stiffness_[p]).upper);
  }
  a_.norm = widest(area, 0, 0);
  // (Bv)'' = -Bv + g(t+T) - 2 g(t) + g(t-T) with |g| <= stiffness
  const Number most(*std::max_element(stiffness_.begin(), stiffness_.end()));
  const Number apart = two * enclosed_pi() / double(fine_.nodes);
  a_.epsilon = (apart * apart / Number(8) * (Number(a_.norm) + Number(4) * most)).upper;
  invert();
}

/// The largest integral over two shifts around any time from the cell `first` on, given those over cells and,
/// for each cell behind them, `behind`.
double WaveProof::widest(const std::vector<double>& density, std::size_t first,
                         double behind) const {
  using Wide = Interval<long double>;
  std::vector<Wide> sum{Wide(0)};
  for (double x : density) sum.push_back(sum.back() + Wide(x));
  const auto up_to = [&](std::size_t cells) {
    const std::size_t known = std::min(cells, density.size());
    return sum[known] + Wide((long double)(cells - known)) * Wide(behind);
  };
  const std::size_t turn = fine_.per_turn;
  double most = 0;
  for (std::size_t p = first; p <= density.size() + turn; ++p) {
    const Wide all =
        p >= turn ? up_to(p + turn + 1) - up_to(p - turn) : up_to(p + turn + 1) + up_to(turn - p);
    most = std::max(most, above(double(all.upper)));
  }
  return most;
}

/// K at a difference of so many nodes.
Number WaveProof::kernel(long difference) const {
  const auto apart = std::size_t(std::abs(difference));
  return apart < fine_.nodes ? -angles_.sine(2 * apart * cells_between_nodes()) : Number(0);
}

namespace {

/// Integrals over the cells between two nodes of the stiffness times the falling or the rising half of a broken
/// line, times cos s and sin s.
struct Moments {
  std::array<Number, 2> cosine{}, sine{};
};

}  // namespace

WaveProof::Rows WaveProof::response() const {
  const std::size_t per = cells_between_nodes(), m = fine_.window * fine_.nodes;
  const Number h = two * enclosed_pi() / double(fine_.per_turn);
  // The rule of midpoints misses h^3/24 times the second derivative, at most 1 + 2 over the distance of nodes
  const Number missed = h * h / Number(24) * (one + two / (h * double(per)));
  std::vector<Moments> moments(m);
  for (std::size_t p = 0; p < m * per; ++p) {
    const double rising = (double(p % per) + 0.5) / double(per);  // exact: powers of two
    const Number c = angles_.cosine(2 * p + 1), s = angles_.sine(2 * p + 1);
    const Number error(-missed.upper, missed.upper), area = h * stiffness_[p];
    Moments& here = moments[p / per];
    for (int side : {0, 1}) {
      const double share = side ? rising : 1 - rising;
      here.cosine[side] += area * (share * c + error),
          here.sine[side] += area * (share * s + error);
    }
  }
  Rows matrix(m + 1, Numbers(m + 1));
  for (std::size_t j = 0; j <= m; ++j) {
    const Number c = angles_.cosine(2 * j * per), s = angles_.sine(2 * j * per);
    for (std::size_t l = 0; l < m; ++l)
      for (std::size_t side : {0, 1}) {
        const Number with = s * moments[l].cosine[side], against = c * moments[l].sine[side];
        Number sum{};
        // K(t - s), and K(t + s) for the mirror image
        if (l >= j && l < j + fine_.nodes) sum -= against - with;
        if (l < j && l + fine_.nodes >= j) sum -= with - against;
        if (l + j < fine_.nodes) sum -= with + against;
        matrix[j][l + side] += sum;
      }
  }
  return matrix;
}

/**
Products of matrices are computed in the plain way; their rounding is added once (circle.hpp). */
void WaveProof::invert() {
  const Rows matrix = response();
  const long size = long(matrix.size());
  Matrix<double> difference = Matrix<double>::Identity(size, size), kernels(size, size);
  std::vector<double> wrong, extent;  // of each row of 1 - B: its radii, its moduli
  double kernel_error = 0;
  for (long i = 0; i < size; ++i) {
    Number radii{}, moduli{};
    for (long j = 0; j < size; ++j) {
      const Number entry = (i == j ? one : Number(0)) - matrix[i][j];
      difference(i, j) = entry.middle();
      radii += Number(entry.radius()), moduli += Number(std::abs(difference(i, j)));
      const Number k = kernel(i - j) + kernel(i + j);
      kernels(i, j) = k.middle(), kernel_error = std::max(kernel_error, k.radius());
    }
    wrong.push_back(radii.upper), extent.push_back(moduli.upper);
  }
  const Matrix<double> inverse = difference.inverse();
  const Matrix<double> identity = inverse * difference, row = inverse * kernels;
  const Number gamma(rounding_of_sum(std::size_t(size)));
  const std::size_t per = cells_between_nodes();
  // Between two nodes the modulus is at most that of the ends, on sines: tan(x / 2) for each
  const Number x = enclosed_pi() / double(fine_.nodes), tangent = x / (one - x * x / two);
  for (long i = 0; i < size; ++i) {
    Number defect(underflow), weights{}, norm{};
    for (long j = 0; j < size; ++j) {
      const Number c(std::abs(inverse(i, j)));
      defect += abs(Number(identity(i, j)) - (i == j ? one : Number(0)));
      defect += c * (gamma * extent[j] + wrong[j]);
      weights += c;
    }
    // |K(t - s) + K(t + s)| <= 2
    const Number rounding = weights * ((two + kernel_error) * gamma + kernel_error) + underflow;
    for (long l = 0; l + 1 < size; ++l) {
      const auto* a = stiffness_.data() + std::size_t(l) * per;
      norm += *std::max_element(a, a + per) * tangent *
              (Number(std::abs(row(i, l))) + std::abs(row(i, l + 1)) + two * rounding);
    }
    a_.delta = std::max(a_.delta, defect.upper), a_.beta = std::max(a_.beta, norm.upper);
  }
}

double WaveProof::eta(const std::vector<double>& residuals) const {
  const auto behind = residuals.begin() + long(fine_.window * fine_.per_turn);
  const double inside = *std::max_element(residuals.begin(), behind);
  return a_.eta(inside, *std::max_element(behind, residuals.end()));
}

double WaveProof::q(double radius) const {
  const Number ball(-radius, radius), h = two * enclosed_pi() / double(fine_.per_turn);
  std::vector<double> change, whole;
  for (std::size_t p = 0; p < range_.size(); ++p) {
    const Number a = hertz_slope(range_[p] + ball);
    change.push_back((h * magnitude(a - stiffness_[p])).upper);
    whole.push_back((h * a.upper).upper);
  }
  const double behind = (h * hertz_slope(Number(radius))).upper;
  return a_.q(widest(change, 0, behind), widest(whole, fine_.window * fine_.per_turn, behind));
}

namespace {

/// The largest value of a guess, by dividing the cells on which it may be.
Number largest(const CubicLine& d) {
  constexpr int parts = 1024;
  Number most{};
  for (const Cubic& c : d.cell) most = Number(std::max(most.lower, c[0]));
  for (const Cubic& c : d.cell) {
    const Number all(0, 1), bulge = abs(second_derivative(c, all)) / Number(8.0 * parts * parts);
    if (value(c, all).upper < most.lower) continue;
    for (int i = 0; i <= parts; ++i) {
      const Number at = value(c, Number(double(i) / parts));
      most = {std::max(most.lower, at.lower), std::max(most.upper, (at + bulge).upper)};
    }
  }
  return most;
}

/// What is true of every wave in the ball.
class BallBounds {
 public:
  BallBounds(const CubicLine& d, const ForceIntegrals& integrals, double residual, double radius)
      : d_(d), integrals_(integrals), residual_(residual), r_(radius) {
    const Number h = d.step();
    for (std::size_t p = 0; p < d.cell.size(); ++p) {
      const Number range = value(d.cell[p], Number(0, 1));
      if (p % d.per_turn == 0) stiffness_.emplace_back();
      stiffness_.back() += h * hertz_slope(range + Number(-radius, radius)).upper;
      mass_ += h * hertz(range).upper;
    }
  }

  /// The integral of f cos t over the shift after n, or of f sin t.
  Number cosine(std::size_t n) const { return integrals_.cosine(node(n), node(n + 1)) + shift(n); }
  Number sine(std::size_t n) const { return integrals_.sine(node(n), node(n + 1)) + shift(n); }

  Number energy() const {
    Number sum{};
    for (std::size_t n = 0; n < stiffness_.size(); ++n) {
      const Number c = cosine(n), s = sine(n);
      const Number at = value(d_.cell[node(n)], Number(0)) + Number(-r_, r_);
      const Number contact = two / Number(5) * hertz(at) * positive_part(at);
      sum += c * c + s * s + (n == 0 ? contact : two * contact);
    }
    // Behind: (T M^(3/2))^2 a shift and 2/5 M^(5/2) a contact, twice the first
    const Number turn = two * enclosed_pi(),
                 tail = two * turn * turn * Number(r_) * r_ * r_ + two * hertz(Number(r_)) * r_;
    return sum + Number(0, tail.upper);
  }

  Number action() const {
    // Behind: 3/2 M^(1/2) times T, twice the first, on both sides
    Number all = two * Number(6) * enclosed_pi() * root(Number(r_));
    for (const Number& x : stiffness_) all += two * x;
    const Number wrong = Number(5) * residual_ * (two * mass_) +
                         Number(10) * r_ * r_ * all * (Number(3) / two + all / two);
    return integrals_.action() + Number(-wrong.upper, wrong.upper);
  }

  Number peak() const { return largest(d_) + Number(-r_, r_); }

  /// Minus the central velocity, the integral of f cos t over a shift about zero.
  Number minus_velocity() const { return two * (integrals_.cosine(0, d_.per_turn / 2) + shift(0)); }

 private:
  std::size_t node(std::size_t n) const { return n * d_.per_turn; }
  /// By how much f of the ball differs from that of the guess, integrated over the shift after n.
  Number shift(std::size_t n) const {
    const double most = (Number(r_) * stiffness_[n]).upper;
    return {-most, most};
  }

  const CubicLine& d_;
  const ForceIntegrals& integrals_;
  double residual_, r_;
  Numbers stiffness_{};  ///< largest integral of the stiffness over each shift
  Number mass_{};        ///< integral of the force from zero
};

}  // namespace

EnclosedWave enclose_wave(int sign, const WaveFineness& fineness) {
  const CubicLine guess = wave_guess(sign, fineness);
  const Angles angles(fineness.per_turn);
  const ForceIntegrals integrals(guess, angles);
  const std::vector<double> residuals = wave_residuals(guess, integrals);
  const double residual = *std::max_element(residuals.begin(), residuals.end());
  const WaveProof proof(guess, fineness);
  const auto [unique, exists] =
      two_balls(proof.eta(residuals), 0x1p-14, [&](double radius) { return proof.q(radius); });
  if (!(Number(16) * root(Number(exists.radius)) <= one))
    throw NotProved("the tail cannot be shown to decay");
  const BallBounds wave(guess, integrals, residual, exists.radius);
  if (!(Number(-sign) * wave.minus_velocity() > Number(0)))
    throw NotProved("the sign of the wave cannot be shown");
  return {{unique, exists, proof.inverse(), residual}, wave.energy(), wave.peak(), wave.action()};
}

}  // namespace lattice
