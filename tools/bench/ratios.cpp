/**
# Our integrators and other people's

`make bench` runs this program. It writes two tables, `ratios.ecsv` (theirs over ours, at equal
accuracy) and `work_precision.ecsv` (all that was tried on the way), and prints the first one.
Timings differ from run to run; the ratios, taken within one run, hardly do. */

#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <thread>

#include "lattice/impact/impact.hpp"
#include "monodromy.hpp"
#include "peers.hpp"
#include "report/table.hpp"

using namespace lattice;
using namespace report;
using namespace bench;

namespace {

/**
## Long impacts (B1 and B2)

B1 is the hard well of the article's section on direction reversal, B2 its longest run: a
weak impact in linear wells. Demanded are a relative energy error of 1e-8 over the run and a
displacement error of 1e-6 at $t = 100$, later trajectories being chaotic. */
Problem problem_b1() {
  return {"B1", {200, Quartic{1}}, struck(200, 1.9), 600};
}
Problem problem_b2() {
  return {"B2", {300}, struck(300, 2 * 0.9548e-3), 8090};
}

/// The contact-aware stepper on another base scheme with a very small step.
void find_reference(Problem& p) {
  State<double> s = p.start;
  Window window = waking(p.chain, s);
  const std::size_t steps = 102400;
  const Method method = EventCorrected{0, nystrom(blanes_moan_6_14())};
  method.on(p.chain)(p.chain, s, window, p.compare_at / double(steps), steps);
  p.reference = s.y;
}

/// Where each method begins its scan, and into how many parts a decade or an octave is divided.
struct Range {
  double coarse, tolerance;
  int parts;
  double by_tolerance() const { return std::pow(10, -1.0 / parts); }
  double by_step() const { return std::pow(2, -1.0 / parts); }
};

std::vector<Contender> our_methods(const Problem& p, const Range& r) {
  std::vector<Contender> all{{"contact-aware", true, 4 * r.coarse, r.by_step(),
                              [&p](double h) { return own(p, EventCorrected{h}, true); }, 10}};
  for (const Scheme& scheme : {verlet(), blanes_moan_4(), blanes_moan_6(), blanes_moan_6_14()})
    for (bool windowed : {true, false})
      all.push_back({scheme.name + (windowed ? ", window" : ", whole chain"), false,
                     r.coarse * (scheme.order == 2 ? 0.1 : 1), r.by_step(),
                     [&p, scheme, windowed](double h) {
                       return own(p, Splitting{scheme, h}, windowed);
                     }});
  return all;
}

std::vector<Contender> peer_methods(const Problem& p, const Range& r) {
  using Dopri = odeint::runge_kutta_dopri5<Numbers>;
  using Stoer = odeint::bulirsch_stoer<Numbers>;
  using McLachlan = odeint::symplectic_rkn_sb3a_mclachlan<Numbers>;
  using Verlet = odeint::velocity_verlet<Numbers>;
  const auto adaptive = [&](const char* name, std::function<Score(double)> run) {
    return Contender{name, false, r.tolerance, r.by_tolerance(), run};
  };
  return {
      adaptive("GSL rk8pd", [&p](double s) { return gsl(p, gsl_odeiv2_step_rk8pd, s); }),
      adaptive("GSL rkf45", [&p](double s) { return gsl(p, gsl_odeiv2_step_rkf45, s); }),
      adaptive("Boost dopri5",
               [&p](double s) { return controlled(p, odeint::make_controlled(s, s, Dopri())); }),
      adaptive("Boost bulirsch_stoer", [&p](double s) { return controlled(p, Stoer(s, s)); }),
      {"Boost sb3a_mclachlan", false, r.coarse, r.by_step(),
       [&p](double h) { return fixed(p, h, McLachlan()); }},
      {"Boost velocity_verlet", false, r.coarse * 0.1, r.by_step(),
       [&p](double h) { return fixed(p, h, Verlet()); }}};
}

void race_impacts(Book& book, Problem p, const Range& range, double patience, int rounds) {
  find_reference(p);
  std::vector<Contender> methods = our_methods(p, range);
  for (const Contender& m : peer_methods(p, range)) methods.push_back(m);
  race(book, p.name, methods, {1e-8, 1e-6, std::numeric_limits<double>::infinity()}, patience,
       1e-15, rounds);
}

/**
## Everything moves (B3)

With all sites active there is no window to gain from, and both sides do the same arithmetic: velocity
Verlet with the same step. Ours differs in its passes over the memory. */
State<double> swell(std::size_t sites) {
  State<double> s(sites);
  for (std::size_t n = 0; n < sites; ++n)
    s.y[n] = 0.3 * std::sin(0.37 * double(n) + 1) + 0.2 * std::sin(0.011 * double(n));
  return s;
}

void race_long_chains(Book& book, int rounds) {
  for (std::size_t sites : {1000, 10000, 100000, 1000000}) {
    const Chain chain{sites, Quartic{1}};
    const std::size_t steps = std::max<std::size_t>(100, 20000000 / sites);
    const double h = 0.01;
    State<double> ours = swell(sites);
    std::pair<Numbers, Numbers> theirs{ours.y, ours.v};
    odeint::velocity_verlet<Numbers> stepper;
    double count = 0;
    const Force system{chain, count};
    Window all{0, sites};
    const auto times = in_turns({[&] {
                                   Splitting{verlet(), h}.advance(chain, ours, all, h, steps);
                                 },
                                 [&] {
                                   for (std::size_t k = 0; k < steps; ++k)
                                     stepper.do_step(system, theirs, 0, h);
                                 }},
                                rounds);
    book.ratio("B3, N=" + std::to_string(sites), "Boost velocity_verlet", "cpu time a step [us]",
               times[0] * 1e6 / double(steps), times[1] * 1e6 / double(steps));
  }
}

/**
## Where and when

Ratios differ from one processor to another, so the tables say on which one they were taken. */
std::string machine() {
  std::ifstream about("/proc/cpuinfo");
  for (std::string line; std::getline(about, line);)
    if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos)
      return line.substr(line.find(": ") + 2) + ", " +
             std::to_string(std::thread::hardware_concurrency()) + " threads";
  return "unknown";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int rounds = 5;
  const std::filesystem::path folder = argc > 1 ? argv[1] : "build/bench";
  const std::string only = argc > 2 ? argv[2] : "";  // one problem
  const auto wanted = [&](const char* part) { return only.empty() || only == part; };
  try {
    Book book;
    if (wanted("B3")) race_long_chains(book, rounds);
    if (wanted("M")) race_monodromies(book, 31, rounds, true);
    if (wanted("M")) race_monodromies(book, 99, rounds, false);
    if (wanted("B1")) race_impacts(book, problem_b1(), {0.05, 1e-5, 4}, 3, rounds);
    if (wanted("B2")) race_impacts(book, problem_b2(), {0.1, 1e-9, 2}, 2, rounds);
    for (Table* t : {&book.ratios, &book.precision})
      t->meta = {{"program", "ratios"},
                 {"build", LATTICE_BUILD},
                 {"machine", machine()},
                 {"date", today()}};
    write(folder / "ratios.ecsv", book.ratios);
    write(folder / "work_precision.ecsv", book.precision);
  } catch (const std::exception& error) {
    std::cerr << "ratios: " << error.what() << '\n';
    return 1;
  }
}
