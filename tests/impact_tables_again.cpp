// What the chapters of section 4 tabulate and answer, from runs that are made up or very short.

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "check.hpp"
#include "lattice/gsl/reference.hpp"
#include "sec4/modulated_rings.hpp"
#include "sec4/struck_compressed.hpp"

namespace impact_tables_again {

using namespace lattice;

namespace {

/// A run with two snapshots of three sites and a sample per unit of time.
CompressedRun made_up(double by) {
  CompressedRun run;
  for (int t = 0; t <= 30; ++t)
    run.samples.push_back({double(t), t + 0.5, 0.1 * t, 0.2 * t, 3.0 * t, 7.0 * t + by});
  for (double t : {12.0, 30.0}) {
    Snapshot shot{State<double>(60), 20, {1, std::vector<double>(60)}, {0.3 + by, 21, 4, 0.01}};
    for (std::size_t n = 0; n < 60; ++n) {
      shot.state.v[n] = 0.01 * double(n) + by + 0.001 * t;
      shot.envelope.amplitude[n] = 1 + double(n);
    }
    shot.state.t = t;
    run.shown.push_back(shot);
  }
  return run;
}

/// A course in which the energy gathers at `gathered`, in a packet of this width.
rings::RingOfWell ring_with(double gathered, double width, double speed) {
  rings::RingOfWell ring{1, 0.5};
  ring.course.gathered = gathered;
  ring.course.samples.push_back(
      {RingSample{gathered, 6, 9, 0, true, width}, RingSample{gathered, 6, 9, 0, true, width}});
  for (Modulated& m : ring.course.packet) {
    m.density = std::vector<double>(60, 0.0);
    m.density[9] = 1;
    m.t = {0, 1, 2, 3};
    m.centre = {9, 9 + speed, 9 + 2 * speed, 9 + 3 * speed + 0.01};
  }
  return ring;
}

}  // namespace

TEST_CASE("an impact's experiment and its tables", "[unit]") {
  compressed::Experiment e("x", 0.3, 50, {12, 30});
  CHECK((e.d == 0.5 && e.s == 0.3 && e.name == "x"));
  CHECK((e.impact.velocity == 1.87 && e.impact.time == 50));
  CHECK(e.impact.chain.contact.opening() == 0.5);
  CHECK(compressed::Experiment("y", 0.3, 50, {}, 0).impact.chain.contact.opening() == 0);
  e.coarse = made_up(1e-3), e.fine = made_up(0);
  const auto folder =
      std::filesystem::temp_directory_path() / ("impact_tables_" + std::to_string(getpid()));
  Output output(folder, {});
  Report report{output, true};
  compressed::Experiment none("z", 1, 50, {});
  none.fine.samples = e.fine.samples;
  compressed::add_tables(report, {e, none});
  std::filesystem::create_directories(folder);
  output.finish(report.results);
  const Table profiles = read(folder / "impact_profiles.ecsv"),
              history = read(folder / "packet_history.ecsv");
  std::filesystem::remove_all(folder);
  // Two times, and all sites at each; the sech within twenty sites of its top at 21
  REQUIRE(profiles.rows.size() == 120);
  for (std::size_t row = 0; row < 120; ++row) {
    const double n = double(row % 60 + 1), t = row < 60 ? 12 : 30;
    const auto is = [&](const std::string& name, double expected) {
      check_close(profiles.numbers(name)[row], expected, 1e-14);
    };
    is("s", 0.3), is("t", t), is("n", n), is("v", 0.01 * (n - 1) + 0.001 * t), is("v_error", 1e-3),
        is("amplitude", n);
    const double sech = profiles.numbers("sech")[row];
    CHECK(std::isnan(sech) == (n < 2 || n > 40));
    if (!std::isnan(sech)) check_close(sech, 0.3 / std::cosh((n - 21) / 4), 1e-14);
  }
  // Every fifth sample from t = 10 on, and nothing of an experiment that shows none
  CHECK(history.numbers("t") == std::vector<double>{10, 15, 20, 25, 30});
  CHECK(history.numbers("centre")[1] == 15.5);
  CHECK(history.numbers("s")[4] == 0.3);
  const Estimate sites = compressed::sites_of_packet(e, 12);
  check_close(sites.value, 84, 0);
  check_close(sites.error, 1e-3, 1e-12);
  e.coarse.samples.clear(), e.fine.samples.clear();
  for (int t = 1; t <= 300; ++t) {
    e.coarse.samples.push_back({double(t), t * 1.0, std::pow(t, -0.3), 1.0 / t, 1, 1});
    e.fine.samples.push_back({double(t), t * 2.0, std::pow(t, -0.3), 1.0 / t, 1, 1});
  }
  check_close(e.rough().speed, 1, 1e-12);
  check_close(e.best().speed, 2, 1e-12);
  CHECK(e.judged(mere_train).at(0).name == "x_packet_exponent");
}

TEST_CASE("the band of hard wells counts what has formed", "[unit]") {
  Output output("unused", {});
  Report report{output, true};
  const rings::RingOfWell good = ring_with(100, 8, 0.3), wide = ring_with(300, 9, 0.3),
                          back = ring_with(900, 50, -0.3);
  rings::RingOfWell never{1, 0.5};
  CHECK(holds(good.formed()));
  CHECK_FALSE(holds(back.formed()));
  CHECK(never.formed().empty());
  rings::report_band_of(report, "_x", {good, back, wide, never});
  const auto names = report.facts.table.texts(report.facts.table.columns[0].name);
  const auto value = [&](const std::string& name) {
    for (std::size_t k = 0; k < names.size(); ++k)
      if (names[k] == name) return report.facts.table.numbers("value")[k];
    return -1.0;
  };
  CHECK(value("rings_tried_x") == 4);
  CHECK(value("rings_formed_x") == 2);
  CHECK(value("widest_packet_x") == 9);
  CHECK(value("last_gathered_x") == 300);
  Report empty{output, true};
  rings::report_band_of(empty, "_x", {back});
  CHECK(empty.facts.table.rows.size() == 2);
}

TEST_CASE("the commands of section 4 by their defaults and a short run", "[unit]") {
  const compressed::CompressedImpact impact;
  CHECK((impact.time == 724 && impact.velocity == 1.87 && impact.d == 0.5));
  CHECK(impact.well.as<Quartic>().s == 1);
  compressed::CompressedImpact typed;
  Parameters p;
  typed.parameters(p);
  rings::OneRing ring;
  CHECK((ring.s == 0 && ring.longest == 60000 && ring.waves == 24));
  Parameters q;
  ring.parameters(q);
  const auto bounds = [](Parameters& all, const std::string& name, std::vector<std::string> inside,
                         std::vector<std::string> outside) {
    const auto& check = all.find(name)->check;
    CAPTURE(name);
    for (const std::string& x : inside) CHECK(check.complaint(x).empty());
    for (const std::string& x : outside) CHECK_FALSE(check.complaint(x).empty());
  };
  bounds(p, "time", {"1", "20000"}, {"0.9", "20001"});
  bounds(p, "velocity", {"1e-6", "100"}, {"0.9e-6", "100.5"});
  bounds(p, "d", {"1e-3", "10"}, {"0.9e-3", "10.5"});
  bounds(q, "s", {"-0.5", "10"}, {"-0.6", "10.5"});
  bounds(q, "waves", {"1", "99"}, {"0", "100"});
  bounds(q, "longest", {"100", "1000000"}, {"99", "1100000"});
  // A blow of thirty units of time, and what two runs say of it
  typed.time = 30;
  const Table table = typed.table();
  const Impact blow = endless({1.87, {.well = Quartic{1}, .contact = CompressedHertz{0.5}}, 30});
  const auto runs = strike_to(1e-4, blow);
  const auto rows = table.texts("quantity");
  const auto cell = [&](const std::string& name, const std::string& column) {
    const auto at = std::find(rows.begin(), rows.end(), name);
    REQUIRE(at != rows.end());
    return table.numbers(column)[std::size_t(at - rows.begin())];
  };
  const PacketSample a = packet_sample(30, runs.coarse.density),
                     b = packet_sample(30, runs.fine.density);
  const Snapshot rough = snapshot(blow.chain, runs.coarse.end),
                 best = snapshot(blow.chain, runs.fine.end);
  CHECK(cell("centre", "value") == b.centre);
  CHECK(cell("centre", "error") == compare(a.centre, b.centre).error);
  CHECK(cell("energy_fraction", "value") == b.share);
  CHECK(cell("boundary_energy_fraction", "value") == b.boundary);
  CHECK(cell("residual", "value") == best.sech.residual);
  CHECK(cell("residual", "error") == compare(rough.sech.residual, best.sech.residual).error);
  const Sech& f = best.sech;
  const bool within = std::max(std::abs(f.centre - best.centre), f.width) < 10;
  CHECK(std::isnan(cell("width", "value")) == !within);
  if (within) CHECK(cell("width", "value") == f.width);
}

TEST_CASE("an impact whose contacts go on opening has the error that it states", "[unit]") {
  // Against GSL's method. In the first three runs contacts open after the settling time of the chapter
  struct Blow {
    double velocity, s, d, time;
  };
  for (const Blow& b : {Blow{0.014854110076982853, 5.470967112522019, 0.001, 100},
                        {0.8, 1, 0.02, 60},
                        {0.05, -0.3, 0.004, 80},
                        {1e-6, 1, 0.5, 30}}) {
    compressed::CompressedImpact one;
    one.velocity = b.velocity, one.well = Quartic{b.s}, one.d = b.d, one.time = b.time;
    const Table table = one.table();
    const Chain chain = compressed_impact(b.s, b.time, b.velocity, b.d).chain;
    State<double> end = struck(chain.sites, b.velocity);
    evolve_reference(chain, end, b.time, {1e-12 * b.velocity, 1e-12, gsl_odeiv2_step_rk8pd});
    const PacketSample seen = packet_sample(b.time, energy_density(chain, end));
    const auto value = table.numbers("value"), error = table.numbers("error");
    CAPTURE(b.velocity, b.s, b.d, value[0], seen.centre, value[4], seen.boundary);
    check_close(value[0], seen.centre, 3 * error[0] + 1e-9);
    check_close(value[3], seen.share, 3 * error[3] + 1e-11);
    check_close(value[4], seen.boundary, 3 * error[4] + 1e-11);
  }
}

TEST_CASE("a ring of the reader's choice, for a short time", "[unit]") {
  rings::OneRing ring;
  ring.s = 1, ring.waves = 40, ring.longest = 100;
  const Table table = ring.table();
  const RingCourse course =
      ring_course({.s = 1, .q = 2 * std::numbers::pi * 40 / 200}, 100, {0.4, 0.2}, 1.5);
  const auto values = table.numbers("value"), errors = table.numbers("error");
  const auto names = table.texts("quantity"), reasons = table.texts("reason");
  REQUIRE(names == std::vector<std::string>{"gathered", "agree", "width", "highest"});
  CHECK((std::isnan(values[0]) && std::isnan(values[2])));
  CHECK(values[1] == 100);
  check_close(values[3], course.highest().value, 1e-14);
  check_close(errors[3], course.highest().error, 1e-14);
  CHECK(reasons[0] == "the energy has not gathered by t = 100");
}

}  // namespace impact_tables_again
