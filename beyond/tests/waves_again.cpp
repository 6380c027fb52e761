// Waves of the kernel equation once more: where their panels end, and how one wave leads to another.

#include <algorithm>

#include "check.hpp"
#include "lattice/orbits/shooting.hpp"
#include "sec5/kernel_wave.hpp"
#include "sec5/wave_zeros.hpp"

namespace waves_again {

using namespace lattice;

namespace {

const PowerContact hertz{1.5, 0};

/// The ends of the panels of a grid, from the first and last node of each.
std::vector<double> ends_of(const HalfLine& line, const Panel& panel) {
  const auto n = Eigen::Index(panel.nodes);
  const double first = panel.map(panel.x[0]), last = panel.map(panel.x[n - 1]);
  std::vector<double> ends;
  for (Eigen::Index i = 0; i < line.size(); i += n) {
    const double length = (line.t()[i + n - 1] - line.t()[i]) / (last - first);
    ends.push_back(line.t()[i] - first * length);
    if (i + n == line.size()) ends.push_back(ends.back() + length);
  }
  return ends;
}

/// Zeros of the wave, each folded to its distance from the nearest shift, half a shift, and equal parts between.
std::vector<double> expected_cuts(const KernelWave& w, double longest) {
  const double shift = w.shift_time();
  std::vector<double> zeros{0, shift / 2}, cuts{0};
  for (const Closed& c : w.closed(1e-8))
    for (double t : {c.from, c.to}) zeros.push_back(std::abs(t - shift * std::round(t / shift)));
  std::sort(zeros.begin(), zeros.end());
  zeros.erase(
      std::unique(zeros.begin(), zeros.end(), [](double a, double b) { return b - a < 1e-6; }),
      zeros.end());
  for (std::size_t i = 1; i < zeros.size(); ++i) {
    const double from = zeros[i - 1], parts = std::ceil((zeros[i] - from) / longest);
    for (double k = 1; k <= parts; ++k) cuts.push_back(from + (zeros[i] - from) / parts * k);
  }
  return cuts;
}

}  // namespace

TEST_CASE("panels end where the contacts of a wave open", "[unit][kernel]") {
  CHECK((WaveGrid{}.nodes == 20 && WaveGrid{}.longest == 0.5));
  const struct {
    double alpha;
    std::size_t k;
    int sign;
    std::size_t order, periods;  // it dies out in that many shifts, less one
  } all[] = {{1.5, 3, 1, 2, 9},
             {1.5, 1, -1, 2, 10},
             {1.5, 1, 1, 2, 10},
             {4. / 3, 2, -1, 3, 11},
             {4. / 3, 2, 1, 3, 12}};
  for (const auto& [alpha, k, sign, order, periods] : all) {
    const WaveGrid grid{10, 0.8};
    const KernelWave w = wave_of_type_one(k, sign, {alpha, 0}, grid);
    CAPTURE(alpha, k, sign);
    CHECK(w.central_velocity() * sign > 0);
    CHECK(w.residual() < 1e-14);
    check_close(w.shift_time(), 2 * pi<double>() * double(k), 1e-13);
    // The grid ends one shift after the last value that is 1e-17 of the largest
    double last = 0;
    for (Eigen::Index i = 0; i < w.d.size(); ++i)
      if (std::abs(w.d[i]) >= 1e-17 * w.d.cwiseAbs().maxCoeff()) last = w.line.t()[i];
    CHECK(w.line.periods() == std::size_t(std::ceil(last / w.shift_time())) + 1);
    CHECK(w.line.periods() == periods);
    const auto ends = ends_of(w.line, Panel(10, order)), cuts = expected_cuts(w, 0.8);
    REQUIRE(ends.size() == 2 * (cuts.size() - 1) * periods + 1);
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      check_close(ends[i], cuts[i], 1e-4);
      check_close(ends[2 * (cuts.size() - 1) - i], w.shift_time() - cuts[i], 1e-4);
    }
    // The tail has all its digits: d = K * f to a small part of each value
    const Vector<double> image = w.line.convolve(w.force());
    double worst = 0;
    for (Eigen::Index i = 0; i < w.d.size(); ++i)
      if (const double d = std::abs(w.d[i]); d > 1e-40 && d < 1e-5 * w.d.maxCoeff())
        worst = std::max(worst, std::abs(image[i] - w.d[i]) / d);
    CHECK(worst < 1e-4);
  }
}

TEST_CASE("a wave is followed from one exponent to the next, or lost", "[unit][kernel]") {
  const WaveGrid grid{10, 0.8};
  const KernelWave w = wave_of_type_one(1, 1, hertz, grid),
                   other = wave_of_type_one(1, 1, {1.45, 0}, grid);
  Follow follow{w, grid};
  const KernelWave& there = follow(1.45);
  check_close(there.peak(), other.peak(), 1e-9);
  check_close(follow.now.law.exponent, 1.45, 1e-15);
  CHECK(follow.now.law.d == 0);
  KernelWave wrong = w;
  wrong.d *= 1e6;
  check_line(refusal<std::runtime_error>([&] { newton_wave(wrong, w.shift_time(), hertz, grid); }),
             "does not converge at T = 6.283185, alpha = 1.5");
  // A grid that is too short grows by a quarter and one shift until the wave has died out
  const HalfLine line(w.shift_time(), {0, 0.5, 1, 1.5, 2, 2.5, pi<double>()}, 7, Panel(10, 2));
  const KernelWave grown =
      newton_wave({hertz, line, w.line.onto(line, w.d)}, w.shift_time(), hertz, grid);
  CHECK(grown.line.periods() == 12);  // after 7 and 9
  check_close(grown.peak(), w.peak(), 1e-9);
  // A guess that is twice too large leads to the same wave, and to the zeros of that wave
  wrong = w;
  wrong.d *= 2;
  const KernelWave same = newton_wave(wrong, w.shift_time(), hertz, grid);
  check_close(same.peak(), w.peak(), 1e-12);
  const auto ends = ends_of(same.line, Panel(10, 2)), cuts = expected_cuts(same, 0.8);
  for (std::size_t i = 0; i < cuts.size(); ++i) check_close(ends[i], cuts[i], 1e-4);
}

}  // namespace waves_again
