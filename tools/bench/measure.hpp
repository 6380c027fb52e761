#pragma once
/**
# Measuring fairly

All competitors solve the same problem in the same process. Each one has a setting, a step
or a tolerance, and nobody may choose it by hand: we scan it from coarse to fine by equal
factors and take the cheapest one that meets the demands on accuracy. The chosen settings
are then timed in turns, so that a disturbance of the machine hits all alike, and the
median of the rounds counts. */

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "report/table.hpp"

namespace bench {

/// Processor time of all threads, in seconds.
inline double cpu_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

inline double median(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return x.empty() ? std::numeric_limits<double>::quiet_NaN() : x[x.size() / 2];
}

/// Median time of each of several tasks, done in turns. A short task is repeated for `least` seconds.
inline std::vector<double> in_turns(const std::vector<std::function<void()>>& tasks, int rounds,
                                    double least = 0) {
  std::vector<std::vector<double>> times(tasks.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const double start = cpu_time();
      double spent = 0;
      int runs = 0;
      for (; runs == 0 || spent < least; spent = cpu_time() - start, ++runs) tasks[i]();
      times[i].push_back(spent / runs);
    }
  std::vector<double> medians;
  for (const auto& t : times) medians.push_back(median(t));
  return medians;
}

/**
A score says what a run achieved. An error that a problem does not ask about is zero. */
struct Score {
  /// Largest relative error of the energy, of a displacement, of an entry of the monodromy matrix; evaluations of the
  /// force on the whole chain.
  double energy = 0, solution = 0, tangent = 0, evaluations = 0;
};

/// What a run has to achieve.
struct Demand {
  double energy, solution, tangent;  ///< the errors allowed
  bool met_by(const Score& s) const {
    return s.energy <= energy && s.solution <= solution && s.tangent <= tangent;
  }
};

/// A competitor: `run` solves the problem with a setting, which is scanned from `coarse` on.
struct Contender {
  std::string name;
  bool ours;              ///< or a peer's
  double coarse, factor;  ///< the first setting, and from one to the next
  std::function<Score(double)> run;
  int beyond = 2;  ///< settings tried after the first success
};

/// One point of the work-precision diagram.
struct Point {
  double setting, seconds;
  Score score;
};

/**
The scan ends some settings after the first success, since a finer setting may be quicker by
chance, or when a run exceeds its time. Short runs are repeated and the fastest counts. */
struct Scan {
  std::vector<Point> points;
  std::optional<Point> best;
};

/// The scan of a method down to the setting `finest`, or until a run takes longer than `patience` seconds.
inline Scan scan(const Contender& method, const Demand& demand, double patience, double finest) {
  Scan result;
  int more = method.beyond;
  for (double s = method.coarse; s >= finest && more >= 0; s *= method.factor) {
    Point p{s, std::numeric_limits<double>::infinity(), {}};
    for (int k = 0; k < 3 && (k == 0 || p.seconds < 0.05); ++k) {
      const double start = cpu_time();
      p.score = method.run(s);
      p.seconds = std::min(p.seconds, cpu_time() - start);
    }
    result.points.push_back(p);
    const bool good = demand.met_by(p.score);
    if (good && (!result.best || p.seconds < result.best->seconds)) result.best = p;
    if (result.best) --more;
    if (p.seconds > patience) break;
  }
  return result;
}

/**
The two tables that the figure and the reader need. */
struct Book {
  report::Table ratios{}, precision{};

  /// One comparison, in the table and on standard output.
  void ratio(const std::string& problem, const std::string& peer, const std::string& quantity,
             double ours, double theirs, const std::string& note = "") {
    ratios.add({{"problem", "what is computed", problem},
                {"peer", "whom we compare with", peer},
                {"quantity", "what is compared, with its unit", quantity},
                {"ratio", "theirs over ours: how many times better we are", theirs / ours},
                {"ours", "our value, in the unit of the quantity", ours},
                {"theirs", "their value, in the unit of the quantity", theirs},
                {"note", "settings, or why there is no value", note}});
    std::printf("%-10s %-30s %-26s %9.3g %11.4g %11.4g  %s\n", problem.c_str(), peer.c_str(),
                quantity.c_str(), theirs / ours, ours, theirs, note.c_str());
    std::fflush(stdout);
  }
  /// All settings that were tried; `tangent` says which errors count.
  void points(const std::string& problem, const std::string& method, const Scan& scan,
              bool tangent) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (const Point& p : scan.points)
      precision.add({{"problem", "what is computed", problem},
                     {"method", "integrator", method},
                     {"step_or_tolerance", "setting of the method", p.setting},
                     {"cpu_seconds", "processor time of the run", p.seconds, "s"},
                     {"evaluations", "force evaluations on the whole chain", p.score.evaluations},
                     {"energy_error", "largest relative energy error at the samples",
                      tangent ? none : p.score.energy},
                     {"solution_error", "largest error of a displacement", p.score.solution},
                     {"tangent_error", "largest error of an entry of the monodromy matrix",
                      tangent ? p.score.tangent : none}});
  }
};

inline std::string short_text(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

/**
A race: all are scanned, those that qualify are timed, and our best one is compared with all the
others. One that does not qualify is listed with how far it came. */
inline void race(Book& book, const std::string& problem, const std::vector<Contender>& methods,
                 const Demand& demand, double patience, double finest, int rounds) {
  const bool tangent = std::isfinite(demand.tangent);
  std::vector<Scan> scans;
  std::vector<std::function<void()>> tasks;
  std::vector<std::size_t> runner;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    scans.push_back(scan(methods[i], demand, patience, finest));
    book.points(problem, methods[i].name, scans[i], tangent);
    std::fprintf(stderr, "  scanned %s, %s: %zu settings, the last one in %.2g s\n",
                 problem.c_str(), methods[i].name.c_str(), scans[i].points.size(),
                 scans[i].points.back().seconds);
    if (!scans[i].best) continue;
    runner.push_back(i);
    tasks.push_back([&m = methods[i], s = scans[i].best->setting] { m.run(s); });
  }
  const auto medians = in_turns(tasks, rounds, 0.1);
  std::vector<double> time(methods.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < runner.size(); ++k) time[runner[k]] = medians[k];
  std::size_t winner = methods.size();
  for (std::size_t i : runner)
    if (methods[i].ours && (winner == methods.size() || time[i] < time[winner])) winner = i;
  const double ours = winner < methods.size() ? time[winner] : time[0];
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const Point& last = scans[i].points.back();
    const std::string note =
        scans[i].best
            ? "setting " + short_text(scans[i].best->setting)
            : "not reached: at " + short_text(last.setting) + " after " + short_text(last.seconds) +
                  " s energy " + short_text(last.score.energy) + " solution " +
                  short_text(last.score.solution) + " tangent " + short_text(last.score.tangent);
    book.ratio(problem, methods[i].name, "cpu time [s]", ours, time[i], note);
  }
}

}  // namespace bench
