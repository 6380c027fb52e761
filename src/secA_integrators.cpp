/**
# Appendix: the order of integrators at contact events

How accurate is an integrator if the force is not smooth where a contact opens or closes? We measure how the error of a
run and that of its derivative depend on the step, for ordinary integrators and for our two that treat contact events.
The order of an ordinary method of order four or six falls to 5/2; at a step of 0.01 a method that corrects for contact
events has an error ten thousand times smaller. The cause is that the contact force is exactly zero before the contact
closes at $t^*$, and then begins like $(t-t^*)^{3/2}$.

![Error against step with and without contact correction. Drawn by x05_error_against_step.gp: the errors of
`error_orbit` against `step`, and `tangent` of `error_tangent` against `evaluations`.](fig:x05) */

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "lattice/events/event_driven.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "report/program.hpp"

using namespace lattice;

/**
## The error of an orbit (figure x05 a)

An integrator that steps across $t^*$ with the step $h$ misses a fraction of an impulse of size $h\cdot h^{3/2}$; the
fraction depends on where in the step the event falls. So its error falls like $h^{5/2}$, however high its order is for
smooth forces; a method of order two, such as Verlet's, keeps its order. Our event-corrected integrator
(event_corrected.hpp) replaces this impulse by the exact one, in the step that contains the event and in its neighbours.
It has a base scheme of order six, and the error that the correction leaves is of size $h^5$.

Neighbours count because the force is smooth there but close to its singular point. At a distance of $k$ steps a formula
of order six errs by $h^7$ times the sixth derivative of $(t-t^*)^{3/2}$, that is by $h^{5/2}k^{-9/2}$. Our integrator
corrects up to two steps from an event (`reach`). What it leaves out is small, but it falls like $h^{5/2}$ and must
exceed $h^5$ in the end.

To see this we need a run with many *contact events*, openings and closings of contacts: a strong impact on a hundred
beads in hard wells, Eqs. (9) and (10) with $s = 1$. The chain is at rest, the first bead gets the velocity $v_0$,
Eq. (26), and we compare the displacements at $t = 50$. The errors of single events have random signs, so we show the
root mean square over four impact velocities. The ordinary integrators are symmetric splittings, sequences of kicks by
the force and drifts with the velocity, of order two (Verlet), four and six (schemes.hpp). */
constexpr double velocities[]{1.6, 1.7, 1.8, 1.9};
constexpr double duration = 50, small = 1. / 1024;  // time and the step of references
const Chain hard_chain{100, Quartic{1}};
const Chain squeezed_chain{100, Quartic{1}, CompressedHertz{5}};

State<double> impact(double v0) {
  State<double> state(100);  // at rest
  state.v[0] = v0;
  return state;
}

// The state at t = 50, by a method with its step
State<double> after(const Method& method, const Chain& chain, double v0) {
  State<double> state = impact(v0);
  evolve(method, chain, state, duration, duration);
  return state;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, std::abs(a[n] - b[n]));
  return most;
}

// The largest error of a displacement; its root mean square over the four impacts
double orbit_error(const Method& method, const Chain& chain,
                   const std::vector<State<double>>& exact) {
  double sum = 0;
  for (std::size_t k = 0; k < exact.size(); ++k) {
    const double error = largest_difference(after(method, chain, velocities[k]).y, exact[k].y);
    sum += error * error;
  }
  return std::sqrt(sum / double(exact.size()));
}

/**
The errors jump between neighbouring steps, since they depend on the position of the events within a step. The order is
the slope of a least-squares line on logarithmic axes, from the largest step down to where an error is less than ten
times the uncertainty of the reference; its error is the standard error of the slope. */
Estimate order(const std::vector<double>& step, const std::vector<double>& error, double unsure) {
  std::vector<double> x, y;
  for (std::size_t k = 0; k < step.size() && error[k] >= 10 * unsure; ++k) {
    x.push_back(std::log(step[k]));
    y.push_back(std::log(error[k]));
  }
  return fit_line(x, y).estimate();
}

/**
The references have the step 1/1024, a `reach` of six steps and a base scheme different from that of the tested
integrator; with its own scheme and the same step that integrator must end within $10^{-12}$ of them. This check is not
independent, since both correct contacts in the same way. So GSL's integrator, which controls its own error without
detecting events, must reach the same end states to $10^{-9}$. Otherwise the program stops.

All integrators run with the same steps, each only a factor $\sqrt2$ shorter than the one before, so a jump between
neighbours is not mistaken for a trend. With a reach of two steps the errors do not follow one law, so that line ends at
the step 0.0125.

<!-- integrators.order -->
Where contacts open and close, symplectic splittings of order four and six lose their order: after impacts on hard wells
their errors scale with the powers 2.63 ± 0.08 and 2.59 ± 0.08 of the step. The power is 5.0 ± 0.2 if each contact
receives the impulse that it really exerts, from six steps before a contact event to six steps after it. With two steps
that is so for long steps only: below a step of 0.0125 the error of a single closing contact falls with the power 2.55 ±
0.02, since the next steps still lie close to the singular point of the force. (computed)
<!-- /integrators.order -->

The orders four and six are lost. As a control the same impacts strike a chain compressed by $d = 5$, Eq. (33). Opening
one of its contacts needs the energy $\frac35d^{5/2} = 33.5$, and no impact brings more than 1.81; there both splittings
have their full order.

| power of the step with which the error falls | smooth forces | expected here | here |
|---|---|---|---|
| velocity Verlet | 2 | 2 | [2.003 ± 0.006](cell:orders/method=verlet/order) |
| splitting of order four | 4 | 5/2 | [2.63 ± 0.08](cell:orders/method=blanes_moan_4/contacts=open/order) |
| splitting of order six | 6 | 5/2 | [2.59 ± 0.08](cell:orders/method=blanes_moan_6/contacts=open/order) |
| event-corrected, up to six steps from an event | 6 | 5 | [5.0 ± 0.2](cell:orders/method=six_steps/order) |
| event-corrected, up to two steps; steps above 0.0125 | 6 | 5 | [4.7 ± 0.1](cell:orders/method=contact_aware/order) |
| order four, no contact opens | 4 | 4 | [4.016 ± 0.005](cell:orders/method=blanes_moan_4/contacts=closed/order) |
| order six, no contact opens | 6 | 6 | [6.003 ± 0.002](cell:orders/method=blanes_moan_6/contacts=closed/order) | */
constexpr double far_reach = 6;

struct References {
  const Chain& chain;
  std::vector<State<double>> exact{};
  double unsure = 0;

  explicit References(const Chain& of) : chain(of) {
    for (double v0 : velocities) {
      const EventCorrected method{
          .step = small, .base = nystrom(blanes_moan_6_14()), .reach = far_reach};
      exact.push_back(after(method, chain, v0));
      distance_from_reference(chain, impact(v0), duration, exact.back(), 1e-9);  // or it throws
    }
    unsure = error(EventCorrected{.step = small, .reach = far_reach});
    if (!(unsure < 1e-12)) throw Failure("the references have not converged");
  }
  double error(const Method& method) const { return orbit_error(method, chain, exact); }
};

void report_orbits(Report& report) {
  std::vector<double> steps;  // the same for all
  for (int k = 0; k <= (report.quick ? 4 : 12); ++k) steps.push_back(0.2 * std::pow(2, -0.5 * k));

  // Impacts that open contacts
  const References open(hard_chain), closed(squeezed_chain);
  Table& errors = report.table("error_orbit");
  const auto with_events = [&](double h) {
    return Row{
        {"step", "time step", h},
        {"verlet", "error of velocity Verlet", open.error(Splitting{verlet(), h})},
        {"blanes_moan_4", "error of the splitting of order 4",
         open.error(Splitting{blanes_moan_4(), h})},
        {"blanes_moan_6", "error of the splitting of order 6",
         open.error(Splitting{blanes_moan_6(), h})},
        {"contact_aware", "error of the event-corrected integrator", open.error(EventCorrected{h})},
        {"six_steps", "the same, corrected up to six steps from an event",
         open.error(EventCorrected{.step = h, .reach = far_reach})}};
  };
  errors.fill(steps, with_events, "steps");

  // The same impacts where no contact opens
  Table& smooth = report.table("error_orbit_closed");
  const auto without = [&](double h) {
    return Row{{"step", "time step", h},
               {"blanes_moan_4", "error of the splitting of order 4",
                closed.error(Splitting{blanes_moan_4(), h})},
               {"blanes_moan_6", "error of the splitting of order 6",
                closed.error(Splitting{blanes_moan_6(), h})}};
  };
  smooth.fill(steps, without, "steps, no contact opens");

  // All orders
  Table& orders = report.table("orders");
  const auto add = [&](const char* contacts, const Table& of, double unsure) {
    for (std::size_t k = 1; k < of.columns.size(); ++k) {
      const std::string method = of.columns[k].name;
      const bool one_law = method != "contact_aware";
      const std::vector<double> long_steps(steps.begin(), std::min(steps.begin() + 9, steps.end()));
      orders.add(
          {{"method", "integrator", method},
           {"contacts", "open if contacts open and close, closed if none opens", contacts},
           {"order", "power of the step with which the error falls; contact_aware: to 0.0125",
            order(one_law ? steps : long_steps, of.numbers(method), unsure), "",
            "standard error of the slope, known to 4 per cent"}});
    }
  };
  add("open", errors, open.unsure);
  add("closed", smooth, closed.unsure);
}

/**
## One event alone

To see both laws we need single events. Two beads in hard wells, one with the mass 1, the other with 4, have one
contact, which closes, opens or grazes. A contact that grazes overlaps by 0.02 at most, when both beads have the same
velocity, and as the lighter one is pulled back harder they part again. We choose the state at this instant, or at the
event, follow it back for a time between 0.4 and 0.6, and run over a unit of time. We take the root mean square over 128
such times, so that the event falls at as many places of a step. The exact end is known from the event-driven integrator
in extended precision, which steps to the event itself (event_driven.hpp).

| power of the step with which the error falls | closing | opening | grazing |
|---|---|---|---|
| not corrected | [2.5](cell:event_orders/event=closing/plain) | [2.5](cell:event=opening/plain) | [2.5](cell:event=grazing/plain) |
| up to two steps from the event, steps from 0.2 to 0.05 | [5.0 ± 0.3](cell:event_orders/event=closing/two_long) | [5.3 ± 0.3](cell:event=opening/two_long) | [4.8 ± 0.4](cell:event=grazing/two_long) |
| the same, steps below 0.0125 | [2.6](cell:event_orders/event=closing/two_short) | [2.5](cell:event=opening/two_short) | [2.6](cell:event=grazing/two_short) |
| up to six steps from the event, all steps | [4.92 ± 0.06](cell:event_orders/event=closing/six) | [5.2 ± 0.1](cell:event=opening/six) | [4.9 ± 0.1](cell:event=grazing/six) |

So each law appears where it is expected. With a reach of two steps they meet between 0.05 and 0.0125, at an error tens
of thousands of times smaller than without a correction. A line through longer and shorter steps has a power between 5
and 5/2 that depends on where it begins and ends. */
Chain two_beads() {
  Chain chain{2, Quartic{1}};
  vary(chain, {1, 4}, {});
  return chain;
}

struct Event {
  const char* name;
  State<double> at{2};  // displacements and velocities at the event
  Event(const char* called, double overlap, double rate) : name(called) {
    at.y = {0.7 + overlap, 0.7}, at.v = {rate, 0};
  }
};

template <class T>
State<T> reversed(const State<T>& state) {
  State<T> out = state;
  out.t = T(0);
  for (T& v : out.v) v = -v;
  return out;
}

// Starts before the event, and the exact positions one unit of time later
using Exact = long double;
struct Passage {
  State<double> start{2};
  std::vector<double> end;

  Passage(const Event& event, double before) {
    const Chain chain = two_beads();
    State<Exact> state(2);
    for (std::size_t n = 0; n < 2; ++n) state.y[n] = event.at.y[n], state.v[n] = -event.at.v[n];
    flow(chain, state, Exact(before));
    state = reversed(state);
    for (std::size_t n = 0; n < 2; ++n) {
      state.y[n] = start.y[n] = double(state.y[n]);
      state.v[n] = start.v[n] = double(state.v[n]);
    }
    flow(chain, state, Exact(1));
    for (const Exact& y : state.y) end.push_back(double(y));
  }
};

double passage_error(const EventCorrected& method, const std::vector<Passage>& passages) {
  double sum = 0;
  for (const Passage& passage : passages) {
    State<double> state = passage.start;
    evolve(method, two_beads(), state, 1, 1);
    const double error = largest_difference(state.y, passage.end);
    sum += error * error;
  }
  return std::sqrt(sum / double(passages.size()));
}

void report_events(Report& report) {
  Table &errors = report.table("single_events"), &orders = report.table("event_orders");
  const Event events[] = {{"closing", 0, 0.7}, {"opening", 0, -0.7}, {"grazing", 0.02, 0}};
  for (const Event& event : events) {
    std::vector<Passage> passages;
    for (int k = 0; k < 128; ++k)
      passages.emplace_back(event, 0.4 + 0.2 * std::fmod(k * std::numbers::phi, 1));
    // From 0.2 to 0.0031; without corrections no overlap is worth one
    std::vector<double> steps, plain, two, six;
    for (int k = 0; k <= (report.quick ? 8 : 12); ++k) {
      const double h = 0.2 * std::pow(2, -0.5 * k);
      steps.push_back(h);
      plain.push_back(passage_error({.step = h, .negligible = HUGE_VAL}, passages));
      two.push_back(passage_error({.step = h}, passages));
      six.push_back(passage_error({.step = h, .reach = far_reach}, passages));
      errors.add({{"event", "closing, opening or grazing", event.name},
                  {"step", "time step", h},
                  {"plain", "error without corrections", plain.back()},
                  {"two_steps", "error, corrected up to two steps from the event", two.back()},
                  {"six_steps", "error, corrected up to six steps from the event", six.back()}});
    }
    const auto part = [&](const std::vector<double>& of, std::size_t from, std::size_t to) {
      const auto cut = [&](const std::vector<double>& all) {
        return std::vector<double>(all.begin() + long(std::min(from, all.size() - 3)),
                                   all.begin() + long(std::min(to, all.size())));
      };
      return order(cut(steps), cut(of), 5e-16);  // above rounding
    };
    const char* from = "standard error of the slope, known to 10 per cent";
    orders.add({{"event", "closing, opening or grazing", event.name},
                {"plain", "power of the step, not corrected", part(plain, 0, 13), "", from},
                {"two_long", "corrected up to two steps, steps from 0.2 to 0.05", part(two, 0, 5),
                 "", from},
                {"two_short", "the same, steps of 0.0125 and less", part(two, 8, 13), "", from},
                {"six", "corrected up to six steps", part(six, 0, 13), "", from}});
  }
}

/**
## The error of the linearised flow (figure x05 b)

Floquet multipliers and Newton's method need the derivative of the flow with respect to the initial state. The stiffness
of a contact begins like $(t-t^*)^{1/2}$, so the error of this derivative falls more slowly by one power: like
$h^{3/2}$. We follow one tangent vector, the change caused by displacing the central bead, over one period of a breather
of frequency 1.1: with ordinary integrators and with the one that ends a step at every contact event (event_driven.hpp).
The breather's rounded positions are good enough for a comparison of integrators. */
constexpr double period = 2 * std::numbers::pi / 1.1;
const Chain breather_chain{31, Harmonic{}, Hertz{.floor = 0}};

State<double> breather() {
  State<double> state(31);
  const std::vector<double> half{0.0197, -0.0133, 0.0037, -0.0002};
  for (std::size_t k = 0; k < half.size(); ++k) state.y[15 + k] = state.y[15 - k] = half[k];
  return state;
}

/**
An ordinary integrator can propagate the tangent vector: it gets the same drifts, and kicks by the linearised force. */
std::vector<double> tangent_by_splitting(const Scheme& scheme, std::size_t steps) {
  const std::size_t N = breather_chain.sites;
  State<double> state = breather(), change(N);
  change.y[15] = 1;
  Window all{0, N};
  for (std::size_t k = 0; k < stage_count(scheme, steps); ++k) {
    const auto stage = stage_at<double>(scheme, period / double(steps), steps, k);
    const auto stiffness = linearise(breather_chain, state.y);  // symmetric and tridiagonal
    for (std::size_t n = 0; n < N; ++n) {
      double pull = stiffness.diagonal[n] * change.y[n];
      if (n > 0) pull += stiffness.off[n - 1] * change.y[n - 1];
      if (n + 1 < N) pull += stiffness.off[n] * change.y[n + 1];
      change.v[n] -= stage.kick * pull;
    }
    for (std::size_t n = 0; n < N; ++n) change.y[n] += stage.drift * change.v[n];
    kick_drift(breather_chain, state, all, stage.kick, stage.drift);
  }
  return change.y;
}

/**
The other integrator steps exactly to every contact event and restarts there, so that no step contains one. It chooses
its own steps, so we also count its force evaluations. */
template <class T>
std::vector<double> tangent_by_events(T tolerance, double& evaluations) {
  State<T> state(31);
  const State<double> start = breather();
  std::copy(start.y.begin(), start.y.end(), state.y.begin());
  Tangent<T> tangent(31, 1);  // one column
  std::fill(tangent.entries.begin(), tangent.entries.end(), T(0));
  tangent(15, 0) = T(1);
  EventTolerance<T> rule;  // 128 roundings of T
  if (tolerance > T(0)) rule.tolerance = tolerance;
  evaluations = double(flow(breather_chain, state, T(period), rule, &tangent).evaluations);
  std::vector<double> out;
  for (std::size_t n = 0; n < 31; ++n) out.push_back(double(tangent(n, 0)));
  return out;
}

/**
The reference is the event-driven one in extended precision. The splittings, which share only the forces with it,
converge to it, as the table shows. Integrators that choose their own steps cannot be compared at equal steps, so the
error of the tangent vector stands against the number of force evaluations in one period. That of the splitting of order
six falls with about the power $-\frac32$ of this number. Verlet's falls faster in this range, on the whole with a power
between that and the $-2$ of its order, whose error dominates as long as the steps are long. With fewer than five
thousand evaluations the event-driven integrator has an error below $10^{-12}$; the splitting of order six, with more
than four times as many, still has an error of $10^{-7}$. */
void report_tangents(Report& report) {
  Table& table = report.table(
      "error_tangent", {label("method", "integrator"), number("evaluations", "force evaluations"),
                        number("tangent", "largest error in the tangent vector")});
  double evaluations = 0;
  const auto exact = tangent_by_events<long double>(0, evaluations);

  // Splittings, with twice as many steps each time
  for (const Scheme& scheme : {verlet(), blanes_moan_6()})
    for (std::size_t steps = 16; steps <= (report.quick ? 64U : 16384U); steps *= 2)
      table.add({scheme.name, double(stage_count(scheme, steps)),
                 largest_difference(tangent_by_splitting(scheme, steps), exact)});

  // Event location, with a tenth of the tolerance each time
  for (double tolerance = 1e-3; tolerance > 5e-15; tolerance /= report.quick ? 1e4 : 10) {
    const double error = largest_difference(tangent_by_events(tolerance, evaluations), exact);
    table.add({"event location", evaluations, error});
  }
}

/**
## Differences and limits

Schemes, steps and starts are ours; the article has no such study. The error of an order is the standard error of the
slope. It accounts for the jumps, but not for a change of law, so a line is drawn only where one law is expected. The
orders are from four impacts and three events in hard wells, and there is one tangent vector for one breather, whose
power is read from the table without an error. The other chapters examine whether contact events affect a given result,
such as a depinning threshold or a chaotic trajectory. */
void reproduce(Report& report) {
  report.output.note("tolerance", "references at step 1/1024 and in extended precision");
  report_orbits(report);
  report_events(report);
  report_tangents(report);
}

/**
## Try it

**To change it.** Another integrator is one more entry of the row in `with_events`, from which its order follows, and a
curve in the script of figure x05; other impacts are `velocities`. Another well is the second member of the chains, also
of that in `two_beads`.

1. *Easy.* When does a run have no contact events?
   `build/bin/sec34_impact run --velocity 0.5 --s 1 --time 50 --precompression 5` gives `centre` = 67.48323. Hint:
   contacts that stay closed are smooth, and every splitting has its full order; the table shows two.
2. *Harder.* For which contacts would the events not matter to a method of order four?
   `build/bin/sec34_impact run --velocity 1.8 --s 1 --time 50 --contact power --alpha 3` gives `centre` = 4.58100. Hint:
   a force that begins like $(t-t^*)^\alpha$ costs $h^{1+\alpha}$. */
int main(int argc, char** argv) {
  return run({"secA_integrators", "A", "Integrators and switching contacts (appendix)", reproduce},
             argc, argv);
}
