#include "sec5/drive_chart.hpp"

#include <string>
#include <vector>

namespace lattice {
namespace {

struct ChartPoint {
  double delta, ratio;
};

std::vector<ChartPoint> chart_points(bool quick) {
  std::vector<ChartPoint> out;
  for (int i = 0; i < (quick ? 2 : 7); ++i)
    for (int k = 0; k < (quick ? 3 : 10); ++k)
      out.push_back({0.1 + 0.05 * i, quick ? 0.7 + 0.6 * k : 0.6 + 0.25 * k});
  return out;
}

int kind_of(const Emission& e, double horizon) {
  const double spread = e.spread(horizon);
  return e.passages.empty() ? 0 : spread >= 0 && spread < 0.1 ? 1 : 2;
}

}  // namespace

Sweep drive_chart(const std::filesystem::path& folder, bool quick) {
  const Columns columns{
      number("delta", "distance from the beams' frequency"),
      number("frequency", "of the piston", "Hz"),
      number("ratio", "amplitude over the asymptotic threshold"),
      number("amplitude", "of the piston", "um"),
      count("kind", "0 quiet, 1 periodic, 2 irregular or fewer than four packets"),
      count("kind_rough", "the same for half the time and steps twice as long"),
      number("rate", "packets that pass the detector site", "1/s"),
      number("rate_rough", "the same for half the time and steps twice as long", "1/s"),
      number("spread", "relative standard deviation of their intervals; -1: too few"),
      number("power", "mean power of the drive", "W"),
      number("power_rough", "the same for half the time and steps twice as long", "W"),
      number("far", "largest displacement of the last bead", "um")};
  return {folder, "chart", columns, chart_points(quick).size(),
          std::string("chart of a driven array, ") + (quick ? "quick" : "full")};
}

// Each point twice: is it quiet, periodic or irregular?
void compute_chart(Sweep& sweep, const ArraySetup& setup, bool quick, Part part) {
  const auto points = chart_points(quick);
  const double horizon = quick ? 2400 : 4800;
  sweep.compute(part, [&](std::size_t i) {
    const ChartPoint& p = points[i];
    const double omega = 1 + p.delta, a = p.ratio * threshold_law(Drive::By::piston, omega);
    const DrivenChain driven =
        setup.driven(Drive::By::piston, omega, a, 0, horizon / 12, DrivenArray::sites);
    const Emission coarse = drive_chain(driven, horizon / 2, ArraySetup::detector, 0.2);
    const Emission fine = drive_chain(driven, horizon, ArraySetup::detector, 0.1);
    const double per_second = setup.per_second(1);
    return Cells{p.delta,
                 setup.hertz(omega),
                 p.ratio,
                 setup.micrometres(a),
                 kind_of(fine, horizon),
                 kind_of(coarse, horizon / 2),
                 fine.rate(horizon) * per_second,
                 coarse.rate(horizon / 2) * per_second,
                 fine.spread(horizon),
                 setup.watts(fine.power),
                 setup.watts(coarse.power),
                 setup.micrometres(fine.far)};
  });
}

}  // namespace lattice
