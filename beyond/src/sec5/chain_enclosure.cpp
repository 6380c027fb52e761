#include "sec5/chain_enclosure.hpp"

#include <Eigen/LU>

#include "lattice/algebra/dense.hpp"
#include "lattice/orbits/breather.hpp"
#include "sec5/fineness.hpp"

namespace lattice {

namespace {

using Number = Interval<double>;
using Numbers = std::vector<Number>;
using Rows = std::vector<Numbers>;

const Number one(1), two(2);

constexpr std::size_t guess_samples = 1024;  ///< of the guess, on the half circle

/// sin(pi / omega), which is positive for 1 < omega < 2.
Number sine(const Number& omega) {
  return enclosed_cosine(enclosed_pi() / omega - enclosed_pi() / two);
}

enum class Weight { one, square };

/// Sum of the moduli of coefficients, the k-th weighted with 1 or, for the second derivative, k^2.
Number weighted_sum(const std::vector<double>& c, Weight weight) {
  Number sum{};
  for (std::size_t k = 0; k < c.size(); ++k)
    sum += Number(std::abs(c[k])) * double(weight == Weight::one ? 1 : k * k);
  return sum;
}

/// 1 / (1 - omega^2 k^2).
Number transfer(const Number& omega, std::size_t k) {
  return one / (one - omega * omega * double(k) * double(k));
}

/// How much contact j acts on contact n, and whether half a period later.
struct Link {
  std::size_t contact;
  double factor;
  bool later;
};

std::vector<Link> links(Centre centre, std::size_t n) {
  std::vector<Link> out{{n, -2, false}, {n + 1, 1, false}};
  if (n > 0)
    out.push_back({n - 1, 1, false});
  else if (centre == Centre::bond)
    out.push_back({1, 1, false});
  else
    out.push_back({0, 1, true});
  return out;
}

}  // namespace

// What the proof takes from analysis

Number mean_of_kernel(const Number& omega) {
  return two / sine(omega) - one;
}

Number largest_of_kernel(const Number& omega) {
  return enclosed_pi() / (omega * sine(omega));
}

Number variation_of_force(const std::vector<double>& c) {
  return Number(3) * root(weighted_sum(c, Weight::one)) * weighted_sum(c, Weight::square);
}

Number folded_back(std::size_t samples, std::size_t harmonics) {
  const Number gap = Number(double(samples)) - double(harmonics);
  return two * enclosed_pi() * enclosed_pi() / Number(3) / (gap * gap);
}

Number left_out(const Number& omega, std::size_t harmonics) {
  const double last = double(harmonics - 1);
  return two / (Number(3) * (omega * omega - one / (Number(last) * last)) * last * last * last);
}

std::vector<Number> ranges(const std::vector<double>& c, std::size_t cells) {
  const Sampled values = sample(c, CosineTable(2 * cells));
  const Number h = enclosed_pi() / double(cells);
  const Number bend = h * h / Number(8) * weighted_sum(c, Weight::square) + Number(values.error);
  std::vector<Number> out;
  for (std::size_t p = 0; p < cells; ++p)
    out.push_back(hull(Number(values.value[p]), Number(values.value[p + 1])) +
                  Number(-bend.upper, bend.upper));
  return out;
}

// The guess, from an orbit that Newton's method found

void Fineness::check() const {
  demand_within("contacts", contacts, 2, 15);
  demand_within("harmonics", harmonics, 2, guess_samples);
  demand_power("samples", samples, std::bit_ceil(2 * harmonics), 1 << 24);
  demand_power("cells", cells, 2, 1 << 20);
  demand_power("nodes", nodes, 2, cells);
}

ChainGuess chain_guess(Centre centre, int numerator, int denominator, const Fineness& fineness) {
  fineness.check();
  demand(denominator > 0 && numerator > denominator && numerator - denominator < denominator,
         "omega", std::to_string(numerator) + "/" + std::to_string(denominator), "1 < omega < 2");
  const std::size_t sites = centre == Centre::site ? 31 : 32;  // more than the proof looks at
  const auto problem = breather_problem(centre, double(numerator) / denominator, 0, sites);
  const Orbit<double> orbit = find_breather(problem);
  const std::size_t half = guess_samples;
  // The compressions on half a period
  State<double> state = orbit.start;
  Matrix<double> d(half + 1, fineness.contacts);
  for (std::size_t j = 0; j <= half; ++j) {
    for (std::size_t n = 0; n < fineness.contacts; ++n) {
      const std::size_t i = site_index(long(n), sites);
      d(j, n) = state.y[i] - state.y[i + 1];
    }
    if (j < half) flow(problem.chain, state, problem.period() / (2.0 * half));
  }
  ChainGuess guess{centre, Number(numerator) / Number(denominator), {}};
  const CosineTable table(2 * half);
  for (std::size_t n = 0; n < fineness.contacts; ++n) {
    Numbers values;
    for (std::size_t j = 0; j <= half; ++j) values.emplace_back(d(j, n));
    guess.c.emplace_back();
    for (const Number& x : discrete_coefficients(values, fineness.harmonics, table))
      guess.c.back().push_back(x.middle());
  }
  return guess;
}

// The force of each contact from its samples, and what its variation may hide
std::vector<double> chain_residuals(const ChainGuess& guess, const Fineness& fineness) {
  fineness.check();
  const std::size_t window = guess.c.size(), harmonics = fineness.harmonics;
  const CosineTable table(fineness.samples);
  Rows force;
  Numbers spread;
  for (const auto& c : guess.c) {
    const Sampled values = sample(c, table);
    Numbers f;
    for (double x : values.value)
      f.push_back(hertz(Number(x) + Number(-values.error, values.error)));
    force.push_back(discrete_coefficients(f, harmonics, table));
    spread.push_back(variation_of_force(c));
  }
  const Number& w = guess.omega;
  Number response{};
  for (std::size_t k = 0; k < harmonics; ++k) response += abs(transfer(w, k));
  const Number per_variation =
      response * folded_back(fineness.samples, harmonics) + left_out(w, harmonics);

  // What each equation leaves, the one beyond the window included
  std::vector<double> out;
  for (std::size_t n = 0; n <= window; ++n) {
    Number sum{}, varied{};
    for (std::size_t k = 0; k < harmonics; ++k) {
      Number pull{};
      for (const Link& l : links(guess.centre, n))
        if (l.contact < window)
          pull += force[l.contact][k] * (l.later && k % 2 ? -l.factor : l.factor);
      const Number c = n < window ? Number(guess.c[n][k]) : Number(0);
      sum += abs(c - transfer(w, k) * pull);
    }
    for (const Link& l : links(guess.centre, n))
      if (l.contact < window) varied += Number(std::abs(l.factor)) * spread[l.contact];
    out.push_back((sum + varied * per_variation).upper);
  }
  return out;
}

namespace {

/// 1 / (1 - matrix), approximately.
std::vector<std::vector<double>> resolvent(const Rows& matrix) {
  const long size = long(matrix.size());
  Matrix<double> middle = Matrix<double>::Identity(size, size);
  for (long i = 0; i < size; ++i)
    for (long j = 0; j < size; ++j) middle(i, j) -= matrix[i][j].middle();
  middle = middle.inverse().eval();
  std::vector<std::vector<double>> out(matrix.size());
  for (long i = 0; i < size; ++i)
    for (long j = 0; j < size; ++j) out[i].push_back(middle(i, j));
  return out;
}

/// Norm of 1 - inverse (1 - matrix).
double defect(const std::vector<std::vector<double>>& inverse, const Rows& matrix) {
  double worst = 0;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    Numbers left(matrix.size());
    left[i] = one;
    for (std::size_t k = 0; k < matrix.size(); ++k) {
      const double c = inverse[i][k];
      left[k] -= Number(c);
      for (std::size_t j = 0; j < matrix.size(); ++j) left[j] += c * matrix[k][j];
    }
    Number sum{};
    for (const Number& x : left) sum += abs(x);
    worst = std::max(worst, sum.upper);
  }
  return worst;
}

/// g(theta_j, theta_l) on even functions, at the nodes.
Rows kernel_at_nodes(const Number& omega, const Number& largest, std::size_t m) {
  Rows kernel(m + 1, Numbers(m + 1));
  for (std::size_t j = 0; j <= m; ++j)
    for (std::size_t l = 0; l <= m; ++l) {
      const double early = double(std::min(j, l)), late = double(m - std::max(j, l));
      const Number step = enclosed_pi() / double(m) / omega;
      kernel[j][l] = largest * enclosed_cosine(early * step) * enclosed_cosine(late * step);
    }
  return kernel;
}

}  // namespace

double ChainProof::row(const std::vector<double>& of_contact, std::size_t n) const {
  Number sum{};
  for (const Link& l : links(centre_, n))
    if (l.contact < of_contact.size()) sum += Number(std::abs(l.factor)) * of_contact[l.contact];
  return sum.upper;
}

/// (1/pi) int g(theta_j, s) a(s) hat_l(s) ds over the half circle, for nodes j and l.
Rows ChainProof::integrals(std::size_t contact) const {
  const std::size_t m = fine_.nodes, per = fine_.cells / m;
  const Number h = enclosed_pi() / double(fine_.cells), w = one / omega_;
  // The rule of midpoints misses h^3/24 times the second derivative of g times hat
  const Number curved = largest_g_ * (w * w + two * double(m) / enclosed_pi() * w);
  const double missed = (h * h / Number(24) * curved).upper;
  const Number weight = one / double(fine_.cells);
  Numbers early, late;  // cos(s / omega) and cos((pi - s) / omega) in the middle of cells
  for (std::size_t p = 0; p < fine_.cells; ++p) {
    early.push_back(enclosed_cosine(h * (double(p) + 0.5) * w));
    late.push_back(enclosed_cosine(h * (double(fine_.cells - p) - 0.5) * w));
  }
  Rows out(m + 1, Numbers(m + 1));
  for (std::size_t j = 0; j <= m; ++j) {
    const Number node = enclosed_pi() * double(j) / double(m);
    const Number left = largest_g_ * enclosed_cosine((enclosed_pi() - node) * w) * weight;
    const Number right = largest_g_ * enclosed_cosine(node * w) * weight;
    for (std::size_t p = 0; p < fine_.cells; ++p) {
      const Number g = p < j * per ? left * early[p] : right * late[p];
      const std::size_t l = p / per;
      const double share = (double(p - l * per) + 0.5) / double(per);  // exact: powers of two
      const double a = stiffness_[contact][p];
      const Number error = Number(-missed, missed) * weight;
      out[j][l] += a * (g * (1 - share) + error);
      out[j][l + 1] += a * (g * share + error);
    }
  }
  return out;
}

ChainProof::ChainProof(const ChainGuess& guess, const Fineness& fineness)
    : centre_(guess.centre),
      omega_(guess.omega),
      gamma_(mean_of_kernel(guess.omega)),
      largest_g_(largest_of_kernel(guess.omega)),
      fine_((fineness.check(), fineness)),
      kernel_(kernel_at_nodes(omega_, largest_g_, fineness.nodes)) {
  demand(omega_ > one && omega_ < two, "omega", std::to_string(omega_.middle()), "1 < omega < 2");
  bound_operator(guess);
  const Rows matrix = matrix_of_nodes();
  const auto inverse = resolvent(matrix);
  a_.delta = defect(inverse, matrix);
  for (const auto& row : inverse) a_.beta = std::max(a_.beta, norm_of_row(row));
}

/// Stiffness on the cells, |B| and epsilon.
void ChainProof::bound_operator(const ChainGuess& guess) {
  std::vector<double> largest, response;
  for (const auto& c : guess.c) {
    c_.push_back(ranges(c, fine_.cells));
    stiffness_.emplace_back();
    Number mean{};
    double most = 0;
    for (const Number& range : c_.back()) {
      stiffness_.back().push_back(hertz_slope(range).middle());
      mean += Number(stiffness_.back().back()) / double(fine_.cells);
      most = std::max(most, stiffness_.back().back());
    }
    largest.push_back(most);
    response.push_back(std::min((largest_g_ * mean).upper, (gamma_ * most).upper));
  }
  double source = 0;
  for (std::size_t n = 0; n < window(); ++n) {
    a_.norm = std::max(a_.norm, row(response, n));
    source = std::max(source, row(largest, n));
  }
  // omega^2 (Bv)'' = source - Bv
  const Number h = enclosed_pi() / double(fine_.nodes);
  a_.epsilon = (h * h / Number(8) * (Number(source) + a_.norm) / (omega_ * omega_)).upper;
}

/// NBE, the response of nodes to nodes.
Rows ChainProof::matrix_of_nodes() const {
  const std::size_t block = fine_.nodes + 1;
  Rows matrix(window() * block, Numbers(window() * block));
  std::vector<Rows> integral;
  for (std::size_t n = 0; n < window(); ++n) integral.push_back(integrals(n));
  for (std::size_t n = 0; n < window(); ++n)
    for (const Link& l : links(centre_, n))
      for (std::size_t j = 0; j < block && l.contact < window(); ++j)
        for (std::size_t i = 0; i < block; ++i)
          matrix[n * block + j][l.contact * block + i] +=
              l.factor * integral[l.contact][l.later ? fine_.nodes - j : j][i];
  return matrix;
}

/// An upper bound of the integral of the modulus of a row of CNB, from that of C.
double ChainProof::norm_of_row(const std::vector<double>& inverse) const {
  const std::size_t m = fine_.nodes, block = m + 1, per = fine_.cells / m;
  // What the values of g at each node are multiplied with
  Rows weight(window(), Numbers(block));
  for (std::size_t n = 0; n < window(); ++n)
    for (const Link& l : links(centre_, n))
      for (std::size_t j = 0; j < block && l.contact < window(); ++j)
        weight[l.contact][l.later ? m - j : j] += l.factor * Number(inverse[n * block + j]);
  // Between two nodes the modulus is at most that of the ends, on sines: omega tan(h / (2 omega)) for each
  const Number x = enclosed_pi() / double(m) / (two * omega_);
  const Number cell = one / double(m) / two / (one - x * x / two);
  Number sum{};
  for (std::size_t n = 0; n < window(); ++n) {
    Number before{};
    for (std::size_t l = 0; l < block; ++l) {
      Number value{};
      for (std::size_t j = 0; j < block; ++j) value += weight[n][j] * kernel_[j][l];
      if (l > 0) {
        const double* a = stiffness_[n].data() + (l - 1) * per;
        sum += *std::max_element(a, a + per) * (before + abs(value)) * cell;
      }
      before = abs(value);
    }
  }
  return sum.upper;
}

double ChainProof::eta(const std::vector<double>& residuals) const {
  const double window = *std::max_element(residuals.begin(), residuals.end() - 1);
  return a_.eta(window, residuals.back());
}

double ChainProof::q(double radius) const {
  const Number ball(-radius, radius), slack = gamma_ * hertz_slope(Number(radius));
  std::vector<double> change;
  for (std::size_t n = 0; n < window(); ++n) {
    Number mean{};
    double most = 0;
    for (std::size_t p = 0; p < fine_.cells; ++p) {
      const double apart = magnitude(hertz_slope(c_[n][p] + ball) - Number(stiffness_[n][p]));
      mean += Number(apart);
      most = std::max(most, apart);
    }
    change.push_back(
        std::min((largest_g_ * mean / double(fine_.cells)).upper, (gamma_ * most).upper));
  }
  change.push_back(slack.upper);
  double worst = 0;
  for (std::size_t n = 0; n < window(); ++n) worst = std::max(worst, row(change, n));
  // The first contact behind the window sees the last inside it
  double last = 0;
  for (const Number& range : c_.back()) last = std::max(last, hertz_slope(range + ball).upper);
  const Number behind = gamma_ * last + Number(3) * slack;
  return a_.q(worst, std::max(behind.upper, (Number(4) * slack).upper));
}

namespace {

/// Values of the compressions at theta = 0 or pi, in the window.
Numbers compressions_at_rest(const ChainGuess& guess, bool later, double radius) {
  Numbers d;
  for (const auto& c : guess.c) {
    Number sum(-radius, radius);
    for (std::size_t k = 0; k < c.size(); ++k) sum += Number(later && k % 2 ? -c[k] : c[k]);
    d.push_back(sum);
  }
  return d;
}

/// Positions of the beads in front of the contacts: all compressions from there on, those behind the window
/// being less than twice the first of them together. Around a bond the central contact alone tells its beads.
Numbers positions(Centre centre, const Numbers& d, double radius) {
  Numbers y(d.size());
  Number sum = two * Number(-radius, radius);
  for (std::size_t n = d.size(); n-- > 0;) y[n] = sum += d[n];
  if (centre == Centre::bond) y[0] = d[0] / two, y[1] = -y[0];
  return y;
}

/// Energy of the contacts, and of the beads from the first that is not shared with the mirror image.
Number half_energy(Centre centre, const Numbers& d, const Numbers& y) {
  Number sum{};
  for (std::size_t n = 0; n < d.size(); ++n) {
    const Number contact = two / Number(5) * hertz(d[n]) * positive_part(d[n]);
    sum += centre == Centre::bond && n == 0 ? contact / two : contact;
    if (n > 0) sum += y[n] * y[n] / two;
  }
  return sum;
}

}  // namespace

ChainBreather enclose_chain(Centre centre, int numerator, int denominator,
                            const Fineness& fineness) {
  const ChainGuess guess = chain_guess(centre, numerator, denominator, fineness);
  const std::vector<double> residuals = chain_residuals(guess, fineness);
  const ChainProof proof(guess, fineness);
  const double residual = *std::max_element(residuals.begin(), residuals.end());
  const auto [unique, exists] =
      two_balls(proof.eta(residuals), 0x1p-10, [&](double radius) { return proof.q(radius); });
  const double r = exists.radius;
  if (!(Number(6) * mean_of_kernel(guess.omega) * root(Number(r)) < one))
    throw NotProved("the tail cannot be shown to decay");

  // The right half now, and the left half: the same, or what the right half is half a period later
  const Numbers d = compressions_at_rest(guess, false, r), y = positions(centre, d, r);
  const Numbers d_left = compressions_at_rest(guess, centre == Centre::site, r),
                y_left = positions(centre, d_left, r);
  Number energy = half_energy(centre, d, y) + half_energy(centre, d_left, y_left);
  if (centre == Centre::site) energy += y[0] * y[0] / two;
  energy += Number(0, ((Number(8) * r + two * root(Number(r)) * r) * r).upper);
  Number amplitude{};
  for (const Numbers* side : {&y, &y_left})
    for (std::size_t n = side == &y ? 0 : 1; n < y.size(); ++n) {
      const Number one_bead = abs((*side)[n]);
      amplitude = {std::max(amplitude.lower, one_bead.lower),
                   std::max(amplitude.upper, one_bead.upper)};
    }
  return {{unique, exists, proof.inverse(), residual}, amplitude, energy};
}

}  // namespace lattice
