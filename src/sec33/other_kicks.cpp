#include "sec33/other_kicks.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace lattice {

namespace {

/// Of one of the breathers: reversed or along the mode.
struct Other {
  Which breather;
  std::string kick;

  RestingBreather of(const RestingBreather& at) const {
    return kick == "reversed" ? reversed(at) : along_pinning_mode(at);
  }
};

}  // namespace

Estimate speed_of(const KickedPath& path, double since, double until) {
  const Estimate v = path.speed_during(since, until);
  return {std::abs(v.value), v.error};
}

// Strong kicks
void report_other_strong(Report& report, const Breathers& at, double c,
                         const TwoRuns<EventCorrected>& method) {
  const auto row = [&](const Other& other) {
    const RestingBreather one = other.of(at[other.breather]);
    const auto speed = [&](const Method& by) {
      const KickedPath path = one.after(c, by, 8000);
      return speed_of(path, 0, path.run.t_end);
    };
    return Row{
        {"breather", "its centre and, at the kick, its contact", breather_names[other.breather]},
        {"kick", "reversed or along the pinning mode", other.kick},
        {"speed", "slope of X until t = 8000", compare(speed(method.coarse), speed(method.fine)),
         "site per unit of time", "from two steps and the fit"}};
  };
  const std::vector<Other> kicks{{around_site, "reversed"},
                                 {around_site, "along_mode"},
                                 {stretched, "along_mode"},
                                 {compressed, "along_mode"}};
  report.table("other_strong").fill(kicks, row, "other strong kicks");
}

// Weak kicks
void report_other_weak(Report& report, const RestingBreather& site, double c,
                       const TwoRuns<EventCorrected>& method) {
  const auto row = [&](const Other& other) {
    const auto farthest = [&](const Method& by) {
      const auto look = [](const KickedPath& so_far, auto&...) { return so_far.farthest() < 3.1; };
      return other.of(site).after(c, by, 3.5e5, look).farthest();
    };
    return Row{
        {"kick", "of the site-centred breather: reversed or along the pinning mode", other.kick},
        {"farthest", "largest distance; the run ends beyond 3.1",
         compare(farthest(method.coarse), farthest(method.fine)), "site", "from two steps"}};
  };
  const std::vector<Other> kicks{{around_site, "reversed"}, {around_site, "along_mode"}};
  report.table("other_weak").fill(kicks, row, "other weak kicks");
}

// Is the site-centred breather pinned, and does it slow down?
void report_passages(Report& report, const TwoRuns<KickedPath>& site) {
  Table& passages = report.table("passages");
  for (double x : {1.0, 1.5, 2.0, 2.5, 3.0}) {
    const auto time = [x](const KickedPath& p) { return p.time_at(x); };
    const auto ratio = [x](const KickedPath& p) { return p.speed_at(x) / p.speed_at(1.5); };
    passages.add(Row{{"distance", "from the start", x, "site"},
                     {"time", "when the centre is there", site.of(time)},
                     {"speed_ratio", "speed there over that at 1.5 sites", site.of(ratio)}});
  }
}

// Thresholds
void add_other_thresholds(Table& table, Which phase, const RestingBreather& at,
                          const RestingBreather& longer, const Prediction& law,
                          const Estimate& found) {
  const auto norm = [](const RestingBreather& one) { return 1 / gradient(one.rest.y).norm(); };
  const Estimate length = compare(norm(at), norm(longer));
  const Prediction mode = predict_threshold(along_pinning_mode(at), law.barrier);
  table.add(Row{{"breather", "its centre and, at the kick, its contact", breather_names[phase]},
                {"along_mode", "c_c predicted of a kick along the mode", mode.threshold},
                {"printed_norm", "length of g as printed", length, "", "chains of two lengths"},
                {"as_printed", "c_c for this g", quotient(found, length)}});
}

void report_short_run(Report& report, const TwoRuns<KickedPath>& runs,
                      const TwoRuns<KickedPath>& site) {
  const Estimate passes = runs.of([](const KickedPath& p) { return p.time_at(0.5); });
  const auto by_then = [&](const KickedPath& p) {
    const auto next = std::ranges::lower_bound(p.t, passes.value);
    return std::abs(p.moved(std::size_t(next - p.t.begin()) - 1));
  };
  report.table("short_run")
      .add(Row{{"time", "when the bond-centred breather passes the next site", passes},
               {"moved", "distance of the other by then", site.of(by_then), "site"}});
}

}  // namespace lattice
