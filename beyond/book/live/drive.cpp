/**
# Driving an array in the browser

An array of cantilevers is driven at one end, by a piston or by the base of its first beam: first the map of the
beads' energies is drawn as it is computed, then two runs with different steps say what comes out
(driven_array.hpp). */

#include <algorithm>

#include "page.hpp"
#include "sec5/driven_array.hpp"

using namespace lattice;

/// Frequency in Hz, amplitude in micrometres, one for a driven base, lifetime and duration in ms, rows of the map.
struct Request {
  double frequency, amplitude, base, lifetime, duration, rows;
};

/**
A row of the map holds the largest energy of each bead since the row before, in joules and without the contacts. */
void draw_map(const DrivenArray& array, double rows) {
  std::vector<double> most(DrivenArray::drawn, 0.0);
  double shown = 0;
  State<double> state(DrivenArray::sites);
  evolve(array.driven(), state, time_grid(array.horizon(), 0.8, 0.1),
         [&](const State<double>& now, const EnergyBudget&) {
           for (std::size_t n = 0; n < most.size(); ++n) {
             const double e = (now.y[n] * now.y[n] + now.v[n] * now.v[n]) / 2;
             most[n] = std::max(most[n], e * array.unit_energy());
           }
           if (now.t < array.horizon() * (shown + 1) / rows) return true;
           ++shown;
           page_row(0, array.milliseconds(now.t), most.data(), most.size());
           std::fill(most.begin(), most.end(), 0.0);
           return true;
         });
}

PAGE_REQUEST(Request)

extern "C" __attribute__((export_name("run"))) void run() {
  DrivenArray array;
  array.frequency = asked.frequency, array.amplitude = asked.amplitude;
  array.lifetime = asked.lifetime, array.duration = asked.duration;
  array.by = asked.base != 0 ? Drive::By::base : Drive::By::piston;
  draw_map(array, asked.rows);
  for (const DrivenQuantity& one : array.quantities()) page::fact(one.name, one.value);
}
