#include "sec5/type_one_line.hpp"

#include <cmath>
#include <numbers>

#include "sec5/travelling.hpp"

namespace lattice {

double ExactLine::at(double c, const std::vector<double>& y, std::size_t from) const {
  double sum = 0;
  for (std::size_t i = from; i < y.size(); ++i) {
    double w = y[i];
    for (std::size_t j = from; j < y.size(); ++j)
      if (j != i) w *= (c - speed[j]) / (speed[i] - speed[j]);
    sum += w;
  }
  return sum;
}

ExactLine exact_line() {
  ExactLine line;
  TypeOneOrbits orbits(1);
  for (std::size_t k : {7, 6, 5, 4, 3, 2, 1}) {
    const Orbit<double> orbit = orbits.orbit_at(k);
    const double time = 2 * std::numbers::pi * double(k), c = 1 / time;
    const Chain chain{24};
    State<double> state = embed(orbit.start, chain.sites, 0);
    const std::size_t samples = 400 * k;
    double contact = 0;
    evolve(EventCorrected{0.1}, chain, state, TimeGrid{time, samples, 1},
           [&](const State<double>& now) {
             for (std::size_t i = 1; i < chain.sites; ++i)
               if (now.t > 0) contact += contact_energy(chain, now.y.data(), i) / double(samples);
           });
    line.speed.push_back(c), line.scaled_speed.push_back(c / std::pow(orbit.energy, 0.25));
    line.scaled_contact.push_back(contact / std::pow(c, 5));
  }
  return line;
}

}  // namespace lattice
