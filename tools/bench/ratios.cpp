/**
# Our integrators and other people's

`make bench` runs this program. It prints and writes `build/ratios.ecsv`: processor time of theirs over ours. What would one use
instead? The integrators of the GNU Scientific Library and of Boost.odeint, through their ordinary interfaces. They are
given our own vectorised force, so that methods are compared; they know nothing of the chain and move the whole of it.

Nobody chooses a step or a tolerance by hand: a method's setting becomes finer by equal factors until its run meets the
demand. Those that meet it are then timed in turns, so that a disturbance of the machine hits all alike, and the median
counts. Timings differ from run to run; ratios taken within one run hardly do. */

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "lattice/events/event_driven.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/model/kernel.hpp"
#include "report/table.hpp"

using namespace lattice;
using namespace report;
namespace odeint = boost::numeric::odeint;
using Numbers = std::vector<double>;

namespace {

/// Processor time of all threads, in seconds.
double cpu_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// Median time of each of several tasks, done in turns; a short one is repeated for a tenth of a second.
std::vector<double> in_turns(const std::vector<std::function<void()>>& tasks) {
  std::vector<std::vector<double>> times(tasks.size());
  for (int round = 0; round < 5; ++round)
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const double start = cpu_time();
      int runs = 0;
      for (; runs == 0 || cpu_time() - start < 0.1; ++runs) tasks[i]();
      times[i].push_back((cpu_time() - start) / runs);
    }
  std::vector<double> medians;
  for (auto& t : times) {
    std::sort(t.begin(), t.end());
    medians.push_back(t[t.size() / 2]);
  }
  return medians;
}

void compare(Table& ratios, const std::string& problem, const std::string& peer,
             const std::string& unit, double ours, double theirs, const std::string& note) {
  ratios.add({{"problem", "what is computed", problem},
              {"peer", "whom we compare with", peer},
              {"quantity", "what is compared, with its unit", "cpu time " + unit},
              {"ratio", "theirs over ours: how many times faster we are", theirs / ours},
              {"ours", "our value, in the unit of the quantity", ours},
              {"theirs", "their value, in the unit of the quantity", theirs},
              {"note", "the setting, or why there is no value", note}});
  std::printf("%-14s %-24s %9.3g %11.4g %11.4g %s  %s\n", problem.c_str(), peer.c_str(),
              theirs / ours, ours, theirs, unit.c_str(), note.c_str());
  std::fflush(stdout);
}

/// A competitor: `miss` solves the problem with a setting and returns the largest error over what is demanded.
struct Contender {
  std::string name;
  double coarse, factor;  ///< the first setting, and from one to the next
  std::function<double(double)> miss;
};

/// Times the first method, ours, against the others; a run longer than `patience` seconds ends the search for a setting.
void race(Table& ratios, const std::string& problem, const std::vector<Contender>& methods,
          double patience) {
  std::vector<std::function<void()>> tasks;
  std::vector<std::string> notes;
  std::vector<bool> met;
  for (const Contender& m : methods) {
    for (double setting = m.coarse;; setting *= m.factor) {
      const double start = cpu_time(), miss = m.miss(setting), seconds = cpu_time() - start;
      met.push_back(miss <= 1);
      char note[96];
      std::snprintf(
          note, sizeof note,
          met.back() ? "setting %.3g" : "not reached: at %.3g missed by %.2g after %.2g s", setting,
          miss, seconds);
      if (met.back()) tasks.push_back([&m, setting] { m.miss(setting); });
      if (met.back() || seconds > patience || setting < 1e-15) {
        notes.emplace_back(note);
        break;
      }
      met.pop_back();
    }
  }
  const std::vector<double> times = in_turns(tasks);
  for (std::size_t i = 0, k = 0; i < methods.size(); ++i)
    compare(ratios, problem, methods[i].name, "[s]", times[0], met[i] ? times[k++] : std::nan(""),
            notes[i]);
}

/**
## Long impacts

B1 is the hard well of the article's section on direction reversal, B2 its longest run: a weak impact in linear wells.
Demanded are a relative energy error of 1e-8 over the run and a displacement error of 1e-6 at $t = 100$, later
trajectories being chaotic. */
struct Problem {
  std::string name;
  Chain chain;
  State<double> start;
  double time;
  Numbers reference{};  ///< displacements at t = 100
};

struct Judge {
  const Problem& problem;
  double energy = lattice::energy(problem.chain, problem.start), miss = 0;
  void operator()(const State<double>& now) {
    const double drift = std::abs(lattice::energy(problem.chain, now) / energy - 1) / 1e-8;
    miss = drift <= miss ? miss : drift;  // and so it is if that is not a number
    if (std::abs(now.t - 100) > 1e-9) return;
    for (std::size_t n = 0; n < now.y.size(); ++n)
      miss = std::max(miss, std::abs(now.y[n] - problem.reference[n]) / 1e-6);
  }
};

/// The force on the whole chain, as our peers ask for it.
struct Force {
  const Chain& chain;
  void operator()(const Numbers& y, const Numbers&, Numbers& a, double) const {
    write(y.data(), a.data());
  }
  /// Positions and then velocities, as a first-order system.
  void operator()(const Numbers& z, Numbers& dz, double) const {
    std::copy(z.begin() + long(chain.sites), z.end(), dz.begin());
    write(z.data(), dz.data() + chain.sites);
  }
  void write(const double* y, double* a) const {
    Window all{0, chain.sites};
    accelerate(chain, y, a, all);
  }
};

double own(const Problem& p, const Method& method) {
  Judge judge{p};
  State<double> state = p.start;
  evolve(method, p.chain, state, p.time, Every{100}, std::ref(judge));
  return judge.miss;
}

/// A peer carries the state from one sample to the next.
template <class Carry>
double peer(const Problem& p, Carry carry) {
  Judge judge{p};
  State<double> state = p.start;
  while (state.t < p.time - 1e-9) {
    const double next = std::min(state.t + 100, p.time);
    carry(state, next - state.t);
    state.t = next;
    judge(state);
  }
  return judge.miss;
}

double boost_dopri5(const Problem& p, double tolerance) {
  auto stepper =
      odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_dopri5<Numbers>());
  return peer(p, [&](State<double>& s, double duration) {
    Numbers z(s.y);
    z.insert(z.end(), s.v.begin(), s.v.end());
    odeint::integrate_adaptive(std::ref(stepper), Force{p.chain}, z, 0.0, duration, 0.01);
    std::copy_n(z.begin(), s.y.size(), s.y.begin());
    std::copy_n(z.begin() + long(s.y.size()), s.v.size(), s.v.begin());
  });
}

double boost_verlet(const Problem& p, double step) {
  odeint::velocity_verlet<Numbers> stepper;
  return peer(p, [&](State<double>& s, double duration) {
    std::pair<Numbers, Numbers> x{s.y, s.v};
    const auto steps = std::size_t(std::ceil(duration / step));
    for (std::size_t k = 0; k < steps; ++k)
      stepper.do_step(Force{p.chain}, x, 0, duration / double(steps));
    std::tie(s.y, s.v) = x;
  });
}

void race_impacts(Table& ratios, Problem p, double coarse, double tolerance, double patience) {
  State<double> s = p.start;
  evolve(EventCorrected{100. / 102400, nystrom(blanes_moan_6_14())}, p.chain, s, 100);
  p.reference = s.y;
  const double finer = std::pow(2, -0.25), tighter = std::pow(10, -0.25);
  std::vector<Contender> all{
      {"contact-aware", 4 * coarse, finer, [&](double h) { return own(p, EventCorrected{h}); }}};
  for (const Scheme& scheme : {verlet(), blanes_moan_4(), blanes_moan_6()})
    all.push_back(
        {scheme.name, coarse * (scheme.order == 2 ? 0.1 : 1), finer, [&p, scheme](double h) {
           return own(p, Splitting{scheme, h});
         }});
  const auto gsl = [&p](const gsl_odeiv2_step_type* type) {
    return [&p, type](double small) {
      return peer(p, [&](State<double>& state, double duration) {
        evolve_reference(p.chain, state, duration, {small, small, type});
      });
    };
  };
  all.push_back({"GSL rk8pd", tolerance, tighter, gsl(gsl_odeiv2_step_rk8pd)});
  all.push_back({"GSL rkf45", tolerance, tighter, gsl(gsl_odeiv2_step_rkf45)});
  all.push_back(
      {"Boost dopri5", tolerance, tighter, [&](double small) { return boost_dopri5(p, small); }});
  all.push_back(
      {"Boost velocity_verlet", 0.1 * coarse, finer, [&](double h) { return boost_verlet(p, h); }});
  race(ratios, p.name, all, patience);
}

/**
## Everything moves

With all sites active there is no window to gain from, and both sides do the same arithmetic: velocity Verlet with the
same step. Ours differs in its passes over the memory. The limit is one pass that reads and writes positions and
velocities and computes next to nothing. */
void race_long_chains(Table& ratios) {
  for (std::size_t sites : {1000, 10000, 100000, 1000000}) {
    const Chain chain{sites, Quartic{1}};
    const std::size_t steps = std::max<std::size_t>(100, 20000000 / sites);
    const double h = 0.01;
    State<double> ours(sites);
    for (std::size_t n = 0; n < sites; ++n)
      ours.y[n] = 0.3 * std::sin(0.37 * double(n) + 1) + 0.2 * std::sin(0.011 * double(n));
    std::pair<Numbers, Numbers> theirs{ours.y, ours.v}, pass = theirs;
    odeint::velocity_verlet<Numbers> stepper;
    Window all{0, sites};
    const auto times = in_turns({[&] {
                                   Splitting{verlet(), h}.advance(chain, ours, all, h, steps);
                                 },
                                 [&] {
                                   for (std::size_t k = 0; k < steps; ++k)
                                     stepper.do_step(Force{chain}, theirs, 0, h);
                                 },
                                 [&] {
                                   for (std::size_t k = 0; k < steps; ++k)
                                     for (std::size_t n = 0; n < sites; ++n) {
                                       pass.second[n] -= h * pass.first[n];
                                       pass.first[n] += h * pass.second[n];
                                     }
                                 }});
    const std::string name = "B3, N=" + std::to_string(sites);
    const double each = 1e6 / double(steps);
    for (std::size_t k : {1, 2})
      compare(ratios, name, k == 1 ? "Boost velocity_verlet" : "limit: memory", "a step [us]",
              times[0] * each, times[k] * each, "");
  }
}

/// Ratios differ from one processor to another, so the table says on which one they were taken.
std::string machine() {
  std::ifstream about("/proc/cpuinfo");
  for (std::string line; std::getline(about, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(": ") + 2);
  return "unknown";
}

}  // namespace

int main(int argc, char** argv) try {
  Table ratios;
  ratios.meta = {{"program", "ratios"}, {"build", LATTICE_BUILD}, {"machine", machine()}};
  race_long_chains(ratios);
  race_impacts(ratios, {"B1", {200, Quartic{1}}, struck(200, 1.9), 600}, 0.05, 1e-5, 3);
  race_impacts(ratios, {"B2", {300}, struck(300, 2 * 0.9548e-3), 8090}, 0.1, 1e-9, 2);
  write(argc > 1 ? argv[1] : "ratios.ecsv", ratios);
} catch (const std::exception& error) {
  std::cerr << "ratios: " << error.what() << '\n';
  return 1;
}
