// Sections 3.5 and 3.6: the table of all scales of the cantilevers' array.

#include <map>

#include "commands/all_scales.hpp"
#include "sec3/array_impact.hpp"
#include "support/check.hpp"

using namespace lattice;
using namespace report;

TEST_CASE("the table of scales has its closed forms", "[unit][cantilever]") {
  const Table table = AllScales{.velocity = 2}.table();
  std::map<std::string, double> value;
  const auto names = table.texts("quantity");
  for (std::size_t i = 0; i < names.size(); ++i) value[names[i]] = table.numbers("value")[i];
  const auto close = [&](const char* name, double expected) {
    CAPTURE(name);
    check_close(value.at(name), expected, 0, 1e-12);
  };
  const Scales s = CantileverArray{}.scales();
  const Collision hit = collision_by_energy();
  const double V = 2, tau = std::pow(s.m * s.m / (s.gamma * s.gamma * V), 0.2);
  const double gamma = 193e9 * std::sqrt(2 * 2.38e-3) / 3 / (1 - 0.46 * 0.46);
  close("impact_velocity", 2);
  close("contact_time", hit.contact_time * tau);
  close("max_compression", hit.compression * std::pow(s.m * V * V / s.gamma, 0.4));
  close("cradle_lambda_5_2", Cradle{}.lambda_5_2(9.81, hit.contact_time));
  close("gamma_with_beam_modulus", gamma);
  close("lambda_with_beam_modulus", s.m / s.k * std::pow(gamma * gamma * V / s.m / s.m, 0.4));
  // Eqs. (29) and (30): so fast is the first bead of the chain
  close("lambda_5_2", StruckArray{.velocity = V}.struck_velocity());
}
