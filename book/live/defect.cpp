/**
# A defect in the browser

A packet of an array of cantilevers meets beads of another radius at site 100: first the map of
contact forces is drawn as it is computed, then runs with two steps, with the defect and without it, say
where the energy is after 75 ms, as in sec36_cantilever_defect.cpp. */

#include <array>
#include <numeric>

#include "page.hpp"
#include "sec3/array_impact.hpp"

using namespace lattice;

/// The defect's radius over the others', the impact velocity in m/s, and how many rows the map has.
struct Request {
  double radius, velocity, rows;
};

constexpr double until = 75;  // ms

/**
A row of the map holds the strongest push of each contact since the row before, in newtons. */
void draw_map(const StruckArray& struck, const Request& r) {
  const Impact impact = struck.impact({.ratio = r.radius, .until = until, .sample = 0.1});
  const std::size_t contacts = impact.chain.sites - 1;
  std::vector<double> most(contacts, 0.0);
  std::size_t shown = 0;
  strike(EventCorrected{0.1}, impact, [&](const State<double>& now, const auto&) {
    for (std::size_t n = 0; n < contacts; ++n) {
      const double push = contact_push(impact.chain, now.y.data(), n + 1);
      most[n] = std::max(most[n], push * struck.scales.unit_force());
    }
    if (now.t < impact.time * double(shown + 1) / r.rows) return;
    ++shown;
    page_row(0, struck.scales.milliseconds(now.t), most.data(), contacts);
    std::fill(most.begin(), most.end(), 0.0);
  });
}

/// Fractions of the impact's energy at the end: sites 1 to 95, 96 to 104, and from 105 on.
struct EnergyShares {
  double reflected, near, transmitted;
};

EnergyShares shares(const StruckArray& struck, double radius, double step) {
  const auto e =
      strike(EventCorrected{step}, struck.impact({.ratio = radius, .until = until})).density;
  const auto defect = e.begin() + std::ptrdiff_t(struck.array.defect);
  const double all = struck.struck_velocity() * struck.struck_velocity() / 2;
  return {std::accumulate(e.begin(), defect - 5, 0.0) / all,
          std::accumulate(defect - 5, defect + 4, 0.0) / all,
          std::accumulate(defect + 4, e.end(), 0.0) / all};
}

/**
Only what passes the defect's place in an array without a defect arrives there; the net fractions refer to it. */
void divide_energy(const StruckArray& struck, double radius) {
  std::array<std::array<double, 7>, 2> found{};
  for (std::size_t k : {0, 1}) {
    const double step = k == 0 ? 0.1 : 0.05;
    const auto [r, d, t] = shares(struck, radius, step);
    const double before = shares(struck, 1, step).reflected, arriving = 1 - before;
    found[k] = {r, d, t, (r - before) / arriving, d / arriving, t / arriving, r + d + t - 1};
  }
  const char* names[] = {"reflected",     "near",     "transmitted",
                         "net_reflected", "net_near", "net_transmitted"};
  for (std::size_t i = 0; i < 6; ++i) page::fact(names[i], with_error(found[0][i], found[1][i]));
  page::fact("budget", Estimate{found[1][6], std::abs(found[0][6])});
}

/**
All that the page shows is computed in one call. */
PAGE_REQUEST(Request)

extern "C" __attribute__((export_name("run"))) void run() {
  const StruckArray struck{{}, asked.velocity};
  draw_map(struck, asked);
  divide_energy(struck, asked.radius);
}
