/**
# Striking the chain in the browser

This is the run of `sec34_impact run`, compiled from the same headers for a page: the same chain,
the same resolutions, the same bits. The page hands over numbers, sees every row of a map as
it is computed, and gets each quantity with its error; what goes wrong is told in the words in
which the programs tell it. */

#include "lattice/impact/impact.hpp"
#include "lattice/model/potential_names.hpp"
#include "page.hpp"

using namespace lattice;

/**
## The run

A request says what is struck and what is shown: energy densities or contact forces, in `rows`
rows. The well is a place in the library's list, and `s` is taken where that well has it. */
struct Request {
  double velocity, well, s, precompression, time, sites, tolerance, forces, rows;
};

Impact impact_of(const Request& r) {
  const std::string name = names_of<Well>().at(std::size_t(r.well));
  Settings given;
  for (const ParameterInfo& p : parameters_of<Well>(name))
    if (p.name == "s") given["s"] = r.s;
  const Contact contact = simplest(Contact{CompressedHertz{r.precompression}});
  return {.velocity = r.velocity,
          .chain = {std::size_t(r.sites), named<Well>(name, given), contact},
          .time = r.time,
          .far_end = may_move};
}

/// Shows about `rows` of the samples of a run, whatever their number.
struct MapRows {
  const Request& request;
  const Impact& impact;
  int halvings;
  std::size_t count = 0, shown = 0;

  void operator()(const State<double>& now, const std::vector<double>& density) {
    if (now.t < impact.time * double(shown) / request.rows && now.t < impact.time) return;
    ++shown;
    if (request.forces == 0) return page_row(halvings, now.t, density.data(), density.size());
    const auto force = contact_forces(impact.chain, now.y);
    page_row(halvings, now.t, force.data(), density.size());
  }
};

Refined<ImpactRun> strike_for(const Request& request, const Impact& impact) {
  return refined(request.tolerance, [&](const EventCorrected& method) {
    return strike(method, impact, MapRows{request, impact, method.halvings});
  });
}

/**
## What is reported

The quantities are those of the program and have its names; one that does not exist is `nan`. */
void report(const Impact& impact, const Refined<ImpactRun>& runs) {
  const double to = double(impact.chain.sites) - 20, undefined = std::nan("");
  const auto tracked = [&](std::string_view name, auto of) {
    page::fact(name,
               runs.at_end([&](const ImpactRun& o) { return o.path.empty() ? undefined : of(o); }));
  };
  page::fact("speed", runs.of([&](const ImpactRun& o) {
    return o.path.line(fit_from, to).value_or(Line{undefined, undefined, undefined}).estimate();
  }));
  tracked("centre", [](const ImpactRun& o) { return o.path.back().centre; });
  page::fact("peak_energy_density",
             runs.of([&](const ImpactRun& o) { return o.path.largest_peak(fit_from, to); }));
  tracked("packet_energy_fraction",
          [](const ImpactRun& o) { return o.path.back().energy / total(o.density); });
  page::fact("boundary_energy_fraction",
             runs.at_end([](const ImpactRun& o) { return boundary_share(o.density); }));
  page::fact("energy_drift", runs.of([](const ImpactRun& o) { return o.run.energy_drift; }));
}

/**
All that the page shows is computed in one call. */
PAGE_REQUEST(Request)

extern "C" __attribute__((export_name("run"))) void run() {
  const Impact impact = impact_of(asked);
  const Refined<ImpactRun> runs = strike_for(asked, impact);
  report(impact, runs);
  page::list("v", runs.fine.end.v);
}
