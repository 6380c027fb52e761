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
void draw_map(const StruckArray& blow, const Request& r) {
  const Impact impact = blow.impact(r.radius, until, 0.1);
  const std::size_t contacts = impact.chain.sites - 1;
  std::vector<double> most(contacts, 0.0);
  std::size_t shown = 0;
  strike(EventCorrected{0.1}, impact, [&](const State<double>& now, const auto&) {
    for (std::size_t n = 0; n < contacts; ++n) {
      const double push = contact_push(impact.chain, now.y.data(), n + 1);
      most[n] = std::max(most[n], push * blow.scales.unit_force());
    }
    if (now.t < impact.time * double(shown + 1) / r.rows) return;
    ++shown;
    page_row(0, blow.scales.milliseconds(now.t), most.data(), contacts);
    std::fill(most.begin(), most.end(), 0.0);
  });
}

/**
All that the page shows is computed in one call. */
PAGE_REQUEST(Request)

extern "C" __attribute__((export_name("run"))) void run() {
  const StruckArray blow{{}, asked.velocity};
  draw_map(blow, asked);
  const Fractions found = fractions(ScatteringSetup(blow, {0.1, 0.05}, until), asked.radius);
  for (const auto& named : found.named()) page::fact(named.name, named.share);
  page::fact("budget", found.budget);
  page::fact("mu", exact(blow.array.mu(asked.radius)));
}
