/**
# A defect in the browser

A packet of an array of cantilevers meets beads of another radius at site 100: first the map of
contact forces is drawn as it is computed, then two runs with different steps say where the energy
is after 75 ms (scattering.hpp). */

#include "page.hpp"
#include "sec36/scattering.hpp"

using namespace lattice;

/// The defect's radius over the others', the impact velocity in m/s, and how many rows the map has.
struct Request {
  double radius, velocity, rows;
};

constexpr double until = 75;  // ms

/**
A row of the map holds the strongest push of each contact since the row before, in newtons. */
void draw_map(const ArrayImpact& impact, const Request& r) {
  const auto chain = cantilever_chain(impact.array, r.radius);
  const std::size_t contacts = chain.sites - 1;
  const double duration = impact.time(until), unit = impact.scales.unit_force();
  std::vector<double> most(contacts, 0.0);
  std::size_t shown = 0;
  State<double> state = struck(chain.sites, impact.struck_velocity());
  evolve(ContactAware{0.1}, chain, state, duration, 0.1, [&](const State<double>& now) {
    for (std::size_t n = 0; n < contacts; ++n)
      most[n] = std::max(most[n], contact_push(chain, now.y.data(), n + 1) * unit);
    if (now.t < duration * double(shown + 1) / r.rows) return;
    ++shown;
    page_row(0, impact.milliseconds(now.t), most.data(), contacts);
    std::fill(most.begin(), most.end(), 0.0);
  });
}

/**
All that the page shows is computed in one call. */
PAGE_REQUEST(Request)

extern "C" __attribute__((export_name("run"))) void run() {
  const ArrayImpact impact{{}, asked.velocity};
  draw_map(impact, asked);
  const Fractions found = fractions(Workshop(impact, {0.1, 0.05}, until), asked.radius);
  for (const auto& named : found.named()) page::fact(named.name, named.share);
  page::fact("ledger", found.ledger);
  page::fact("mu", exact(impact.array.mu(asked.radius)));
}
