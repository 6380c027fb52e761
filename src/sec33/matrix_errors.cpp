#include "sec33/matrix_errors.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "lattice/algebra/eigenvalues.hpp"
#include "lattice/gsl/random.hpp"
#include "sec33/exchange.hpp"

namespace lattice {

// The eigenvalues of M, the nearest to +1 first
Displaced displaced(const Matrix<double>& M, double kappa) {
  std::vector<std::complex<double>> all = eigenvalues_of(M);
  std::stable_sort(all.begin(), all.end(),
                   [](auto a, auto b) { return std::norm(a - 1.0) < std::norm(b - 1.0); });
  const auto up = multiplier(kappa, 1), down = multiplier(kappa, -1);
  Displaced out;
  std::complex<double> sum = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::complex<double> z = all[k];
    const double apart = std::min({std::abs(z - 1.0), std::abs(z - up), std::abs(z - down)});
    out.multipliers = std::max(out.multipliers, apart);
    out.modulus = std::max(out.modulus, std::abs(std::abs(z) - 1));
    sum += (z - 1.0) * (z - 1.0) / z;
  }
  out.kappa = std::abs(sum.real() / 8 - kappa);
  return out;
}

// Over several draws of noise
static Displaced displaced_by_noise(const Matrix<double>& M, double eta, double kappa) {
  constexpr unsigned long draws = 8;
  Displaced out;
  for (unsigned long seed = 1; seed <= draws; ++seed) {
    Random random(seed);
    Matrix<double> noisy = M;
    for (Eigen::Index i = 0; i < M.size(); ++i) noisy.data()[i] += eta * random.uniform(-1, 1);
    const Displaced one = displaced(noisy, kappa);
    out.multipliers += std::log(one.multipliers) / double(draws);
    out.kappa += std::log(one.kappa) / double(draws);
    out.modulus = std::max(out.modulus, one.modulus);
  }
  return {std::exp(out.multipliers), out.modulus, std::exp(out.kappa)};
}

// With the finest M, and with a coarser one that tells the error
void add_noise(Table& table, const Shooting<double>& problem, const Orbit<double>& breather,
               const Estimate& slope) {
  const double kappa = spectrum<double>(problem, breather).kappa().value;
  const auto matrix = [&](const EventTolerance<double>& tolerance) {
    return monodromy(problem.chain, breather.start, breather.period(), tolerance);
  };
  const Matrix<double> M = matrix({}), coarser = matrix(rule<double>(1).events);
  const char* how = "from two matrices";
  for (const double eta : {1e-6, 1e-7, 1e-8}) {
    const Displaced coarse = displaced_by_noise(coarser, eta, kappa),
                    fine = displaced_by_noise(M, eta, kappa);
    const Estimate change = compare(coarse.kappa, fine.kappa);
    table.add({{"source", "source of the error", "noise"},
               {"delta", "eta, size of the change of the matrix", eta},
               {"displacement", "largest displacement among the four multipliers next to +1",
                compare(coarse.multipliers, fine.multipliers), "", how},
               {"modulus", "largest distance of a modulus from one, among the four",
                compare(coarse.modulus, fine.modulus), "", how},
               {"kappa_change", "change of kappa", change, "", how},
               {"in_s", "change of s that changes kappa by as much", quotient(change, slope), "",
                "from two matrices and that of the slope"}});
  }
}

}  // namespace lattice
