#include "sec36/defect_map.hpp"

#include <string>

namespace lattice {

std::vector<double> map_radii(bool quick) {
  std::vector<double> radii;
  for (int k = 40; k <= 160; ++k)  // in eightieths
    if (quick ? k % 10 == 0 : k % 2 == 0 || (k > 68 && k < 92)) radii.push_back(double(k) / 80);
  return radii;
}

Sweep defect_map_sweep(const std::filesystem::path& folder, bool quick) {
  Columns columns{number("ratio", "radius of the defect's beads over the others'"),
                  number("mu", "effective mass of the defect over the others'"),
                  number("linear_frequency", "of the defect, over that of the others")};
  for (const auto& share : Fractions{}.named())
    columns = {columns, estimate(share.name, std::string(share.unit) + ", see the chapter", "",
                                 std::string("difference of two resolutions") + share.judged)};
  columns = {columns, number("budget", "sum of the three shares less one")};
  return {folder, "defect_map", columns.all, map_radii(quick).size(),
          std::string("defect map, velocity 1 m/s, ") + (quick ? "quick" : "full")};
}

ScatteringSetup setup_for(const StruckArray& blow, bool quick) {
  if (quick) return {blow, {0.2, 0.1}, defect_passed};
  return {blow, {0.1, 0.05}, defect_passed};
}

void compute_defect_map(Sweep& sweep, const ScatteringSetup& setup, bool quick, Part part) {
  const CantileverArray& array = setup.blow.array;
  const std::vector<double> radii = map_radii(quick);
  sweep.compute(part, [&](std::size_t i) {
    const Fractions f = fractions(setup, radii[i]);
    Cells row{radii[i], array.mu(radii[i]), array.linear_frequency(radii[i])};
    for (const auto& named : f.named())
      row.insert(row.end(), {named.share.value, named.share.error});
    row.push_back(f.budget.value);
    return row;
  });
}

}  // namespace lattice
