/**
# Appendix: the order of integrators at contact events

How accurate is an integrator if the force is not smooth where a contact opens or closes? The contact force is exactly
zero before the contact closes at $t^*$, and then begins like $(t-t^*)^{3/2}$. So the order of an ordinary method of
order four or six falls to 5/2, and to 3/2 for the derivative of the motion with respect to its start. Two methods of
ours treat these *contact events*. Event-corrected steps, for long runs, have at a step of 0.01 an error about ten
thousand times smaller than that of a splitting of order six. `flow`, for orbits and their derivatives, stops at every
event and has an error of the order of its tolerance. We measure how all of them depend on the step, explain `flow`, and
compare the work.

![Error against step after an impact (a); error of the linearised motion against the work (b).](fig:x05)

<!-- head -->
`build/bin/secA_integrators` computes this chapter in 2 s on two cores and writes 6 tables to
`build/data/secA_integrators`. Its figures: `make x05`, `make x42`.
<!-- /head --> */

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "lattice/events/event_driven.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/orbits/breather.hpp"
#include "report/program.hpp"
#include "secA/single_event.hpp"

using namespace lattice;

/**
## What to expect

An integrator that steps across $t^*$ with the step $h$ misses a fraction of an impulse of size $h\cdot h^{3/2}$; the
fraction depends on where in the step the event falls. So its error falls like $h^{5/2}$, however high its order is for
smooth forces; a method of order two, such as Verlet's, keeps its order. An event-corrected step (event_corrected.hpp)
replaces this impulse by the exact one. Its base scheme has order six, and the error that the correction leaves is of
size $h^5$.

The steps next to an event count, too, because the force is smooth there but close to its singular point. At a distance
of $k$ steps a formula of order six errs by $h^7$ times the sixth derivative of $(t-t^*)^{3/2}$, that is by
$h^{5/2}k^{-9/2}$. By default we correct up to two steps from an event (`reach`). What that leaves out is small, but at
small steps it exceeds $h^5$.

The ordinary integrators are symmetric splittings, sequences of kicks by the force and drifts with the velocity, of
order two (Verlet), four and six (schemes.hpp). All methods run with the same steps, each a factor $\sqrt2$ shorter than
the one before. The order is the slope of a least-squares line on logarithmic axes, down to where an error is less than
ten times that of the reference. We fit only where one power is expected. But a second power may still count at the ends
of a range, and errors at events jump; so the error of an order is its standard error or, if that is larger, its change
when the two longest steps are left out. */
constexpr double velocities[]{1.6, 1.7, 1.8, 1.9};
constexpr double duration = 50, reference_step = 1. / 1024, far_reach = 6;
const Chain hard_chain{100, Quartic{1}};
const Chain compressed_chain{100, Quartic{1}, CompressedHertz{5}};  // no contact opens

struct Range {
  double longest = 1, shortest = 0;  // steps of a fit
};
struct Tested {
  std::string name;
  std::function<Method(double step)> with;
  double shortest = 0;  // step of the fit
};
const Tested verlet_2{"verlet", [](double h) { return Splitting{verlet(), h}; }};
const Tested order_4{"blanes_moan_4", [](double h) { return Splitting{blanes_moan_4(), h}; }};
const Tested order_6{"blanes_moan_6", [](double h) { return Splitting{blanes_moan_6(), h}; }};
const Tested reach_2{"two_steps", [](double h) { return EventCorrected{h}; }, 0.0125};
const Tested reach_6{"six_steps",
                     [](double h) { return EventCorrected{.step = h, .reach = far_reach}; }};

std::vector<double> step_lengths(int halvings) {
  std::vector<double> steps;
  for (int k = 0; k <= 2 * halvings; ++k) steps.push_back(0.2 * std::pow(2, -0.5 * k));
  return steps;
}

Estimate order(const std::vector<double>& step, const std::vector<double>& error, double unsure,
               const Range& range = {}) {
  std::vector<double> x, y;
  for (std::size_t k = 0; k < step.size(); ++k) {
    if (step[k] > 1.001 * range.longest || step[k] < 0.999 * range.shortest) continue;
    if (error[k] < 10 * unsure) break;
    x.push_back(std::log(step[k]));
    y.push_back(std::log(error[k]));
  }
  const Line line = fit_line(x, y);
  if (x.size() < 5) return line.estimate();
  x.erase(x.begin(), x.begin() + 2);
  y.erase(y.begin(), y.begin() + 2);
  return {line.slope, std::max(line.slope_error, std::abs(fit_line(x, y).slope - line.slope))};
}

/**
## One event alone

Two beads in hard wells, one with the mass 1, the other with 4, have one contact, which closes, opens or grazes. A
contact that grazes overlaps by 0.02 at most, when both beads have the same velocity; the lighter one is accelerated
more, and they part again. We choose the state at this instant, or at the event, follow it back for a time between 0.4
and 0.6, and run over a unit of time. We take the root mean square over 128 such times, so that the event falls anywhere
within a step. The exact end is that of `flow` in extended precision (src/secA/single_event.cpp).

| power of the step with which the error falls | closing | opening | grazing |
|---|---|---|---|
| not corrected | [2.48 ± 0.01](cell:event_orders/event=closing/plain) | [2.47 ± 0.01](cell:event=opening/plain) | [2.50 ± 0.04](cell:event=grazing/plain) |
| reach of two steps, steps from 0.2 to 0.05 | [5.0 ± 0.3](cell:event_orders/event=closing/two_long) | [5.3 ± 0.3](cell:event=opening/two_long) | [4.8 ± 0.4](cell:event=grazing/two_long) |
| the same, steps below 0.0125 | [2.55 ± 0.03](cell:event_orders/event=closing/two_short) | [2.51 ± 0.03](cell:event=opening/two_short) | [2.63 ± 0.04](cell:event=grazing/two_short) |
| reach of six steps, all steps | [4.92 ± 0.06](cell:event_orders/event=closing/six) | [5.2 ± 0.1](cell:event=opening/six) | [4.9 ± 0.1](cell:event=grazing/six) |

So each law appears where it is expected: no power is farther than 0.3 from 5/2 or 5. */
void report_events(Report& report) {
  const std::vector<double> steps = step_lengths(report.quick ? 5 : 6);
  const double rounding = 5e-16;
  Table& orders = report.table("event_orders");
  for (const Event& event :
       {Event{"closing", 0, 0.7}, {"opening", 0, -0.7}, {"grazing", 0.02, 0}}) {
    const std::vector<Passage> passages = passages_of(event, 128);
    std::vector<double> plain, two, six;
    for (const double h : steps) {
      // Without corrections: no force is worth one
      plain.push_back(passage_error({.step = h, .negligible = HUGE_VAL}, passages));
      two.push_back(passage_error({.step = h}, passages));
      six.push_back(passage_error({.step = h, .reach = far_reach}, passages));
    }
    const char* from = "fit, and two steps less; the power is known to 10 per cent";
    orders.add(
        {{"event", "closing, opening or grazing", event.name},
         {"plain", "power of the step, not corrected", order(steps, plain, rounding), "", from},
         {"two_long", "corrected up to two steps, steps from 0.2 to 0.05",
          order(steps, two, rounding, {0.2, 0.05}), "", from},
         {"two_short", "the same, steps of 0.0125 and less",
          order(steps, two, rounding, {.longest = 0.0125}), "", from},
         {"six", "corrected up to six steps", order(steps, six, rounding), "", from}});
  }
}

/**
## An impact (figure x05 a)

Now a run with many events: a strong impact on a hundred beads in hard wells, Eqs. (9) and (10) with $s = 1$. The chain
is at rest, the first bead gets the velocity $v_0$, Eq. (26), and we compare the displacements at $t = 50$. The errors
of single events have random signs, so we take the root mean square over four impact velocities. */
State<double> impact(const Chain& chain, double v0) {
  State<double> state(chain.sites);  // at rest
  state.v[0] = v0;
  return state;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, std::abs(a[n] - b[n]));
  return most;
}

// The states at the end, as exact as we know them, and the error of their displacements
struct References {
  Chain chain;
  std::vector<State<double>> exact{};
  double error = 0;
};

struct OrbitError {
  double error;        // root mean square over the impacts, of the largest error of a displacement
  double evaluations;  // of the force on a moving bead, over the number of all beads
};

// `run` carries a state to the end and returns its work
template <class Run>
OrbitError orbit_error(const References& references, Run run) {
  double squares = 0, work = 0;
  for (std::size_t k = 0; k < references.exact.size(); ++k) {
    State<double> state = impact(references.chain, velocities[k]);
    work += run(state);
    const double error = largest_difference(state.y, references.exact[k].y);
    squares += error * error;
  }
  const auto impacts = double(references.exact.size());
  return {std::sqrt(squares / impacts), work / impacts / double(references.chain.sites)};
}

OrbitError error_of(const Tested& method, double step, const References& references) {
  return orbit_error(references, [&](State<double>& state) {
    return evolve(method.with(step), references.chain, state, duration, duration).work;
  });
}

/**
The references are runs with the step 1/1024, a `reach` of six steps and a base scheme different from that of the tested
method. The program stops unless two checks hold. With its own scheme and the same step the tested method ends within
$10^{-12}$ of them; and GSL, which controls its own error and does not detect events, within $10^{-9}$. */
References references_of(const Chain& chain) {
  References out{chain};
  const EventCorrected other{
      .step = reference_step, .base = nystrom(blanes_moan_6_14()), .reach = far_reach};
  for (const double v0 : velocities) {
    State<double> state = impact(chain, v0);
    evolve(other, chain, state, duration, duration);
    distance_from_reference(chain, impact(chain, v0), duration, state, 1e-9);  // GSL; throws beyond
    out.exact.push_back(state);
  }
  out.error = error_of(reach_6, reference_step, out).error;
  if (!(out.error < 1e-12)) throw Failure("the references have not converged");
  return out;
}

/**
This is what the runs give, without and with contact events:

| power of the step with which the error falls | expected | measured |
|---|---|---|
| velocity Verlet | 2 | [2.003 ± 0.008](cell:orders/method=verlet/order) |
| splitting of order four | 5/2 | [2.63 ± 0.08](cell:orders/method=blanes_moan_4/contacts=open/order) |
| splitting of order six | 5/2 | [2.59 ± 0.08](cell:orders/method=blanes_moan_6/contacts=open/order) |
| event-corrected, reach of six steps | 5 | [5.0 ± 0.5](cell:orders/method=six_steps/order) |
| event-corrected, reach of two steps, steps above 0.0125 | 5 | [4.7 ± 0.2](cell:orders/method=two_steps/order) |
| order four, no contact opens | 4 | [4.02 ± 0.01](cell:orders/method=blanes_moan_4/contacts=closed/order) |
| order six, no contact opens | 6 | [6.003 ± 0.002](cell:orders/method=blanes_moan_6/contacts=closed/order) |

The last two rows are a control: the same impacts on a chain compressed by $d = 5$, Eq. (33). Opening one of its
contacts needs the energy $\frac35d^{5/2} = 33.5$, and no impact brings more than 1.81.

<!-- integrators.order -->
Where contacts open and close, symplectic splittings of order four and six lose their order: after impacts on hard wells
their errors scale with the powers 2.63 ± 0.08 and 2.59 ± 0.08 of the step. The power is 5.0 ± 0.5 if each contact
receives the impulse that it really exerts, from six steps before a contact event to six steps after it. With two steps
that is so for long steps only: below a step of 0.0125 the error of a single closing contact falls with the power 2.55 ±
0.03, since the next steps still lie close to the singular point of the force. (computed)
<!-- /integrators.order --> */
Row orbit_row(const std::string& method, const char* contacts, double setting,
              const OrbitError& found) {
  return {
      {"method", "integrator", method},
      {"contacts", "open if contacts open and close, closed if none opens", contacts},
      {"setting", "time step, of flow the tolerance", setting},
      {"evaluations", "of the force on moving beads, over the number of beads", found.evaluations},
      {"error", "root mean square over the impacts, of the largest error", found.error}};
}

void report_orders(Table& errors, Table& orders, const References& references, int halvings,
                   const char* contacts, const std::vector<Tested>& methods) {
  const char* from = "fit, and two steps less; the order is known to 10 per cent";
  const std::vector<double> steps = step_lengths(halvings);
  for (const Tested& method : methods) {
    std::vector<OrbitError> found(steps.size());
    parallel_for(method.name, steps.size(),
                 [&](std::size_t k) { found[k] = error_of(method, steps[k], references); });
    std::vector<double> error;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      error.push_back(found[k].error);
      errors.add(orbit_row(method.name, contacts, steps[k], found[k]));
    }
    orders.add({{"method", "integrator", method.name},
                {"contacts", "open if contacts open and close, closed if none opens", contacts},
                {"order", "power of the step with which the error falls; two_steps: to 0.0125",
                 order(steps, error, references.error, {1, method.shortest}), "", from}});
  }
}

/**
## How `flow` works (figure x42)

Between two events the motion is smooth, and `flow` ends a step at each of them. That alone is not enough: right after
$t^*$ the force still behaves like $(t-t^*)^{3/2}$, and its derivatives blow up. But the whole solution is a power
series in $(t-t^*)^{1/2}$. With $t = t^*+u^2$ it is one in $u$, and a formula has its full order again. A segment of
length $L$ between two events needs the square at both ends, so the library has $t = t^*+L\,(3\theta^2-2\theta^3)$ with
$0\le\theta\le1$ (location.hpp).

The formula is the leapfrog with $j = 1, 2, 3, \dots$ steps. They are equal in $\theta$, hence symmetric in time, so
that the error is a series in $j^{-2}$, which extrapolation removes term by term. Here it is for one bead that meets a
wall with velocity 1, $\ddot x = -x-x_+^{3/2}$, over half a unit of time after the contact closes. */
/// x at t = 0.5 by steps that are equal in t (power 1) or in u (power 2).
double leapfrog(int steps, double power) {
  double x = 0, v = 1;
  const auto t = [&](int i) { return 0.5 * std::pow(double(i) / (2 * steps), power); };
  for (int i = 1; i < 2 * steps; i += 2) {
    x += (t(i) - t(i - 1)) * v;
    v -= (t(i + 1) - t(i - 1)) * (x + x * std::sqrt(x));
    x += (t(i + 1) - t(i)) * v;
  }
  return x;
}

// The polynomial in j^-2 through the results of 1, 2, ... steps, at zero, by Neville's recursion
double extrapolated(int levels, double power) {
  std::vector<double> table;
  for (int j = 1; j <= levels; ++j) {
    table.push_back(leapfrog(j, power));
    for (int i = j - 1; i > 0; --i) {
      const double ratio = double(j) / i;
      table[i - 1] = table[i] + (table[i] - table[i - 1]) / (ratio * ratio - 1);
    }
  }
  return table[0];
}

/**
With eight levels, 36 evaluations of the force, the error is [5.04e-7](cell:one_segment/levels=8/in_t) in steps equal
in $t$ and [1.22e-10](cell:one_segment/levels=8/in_u) in steps equal in $u$. The number of levels grows until two
successive extrapolated values agree within the tolerance, and a step for which it does not is shortened; so the error
is known, too.

To find the events `flow` looks ahead with a plain leapfrog (event detection), integrates up to the instant where it
saw one, corrects that instant with the root of the parabola $x+\dot x\tau+\ddot x\tau^2/2$ of the overlap, and
repeats (event location, event_driven.hpp). A tangent vector is integrated along. It passes an event without a jump,
since the contact force is continuous.

![Errors of extrapolation after one event (a), and of the impacts, against the work (b).](fig:x42)

On the four impacts the error of `flow` stays within 5 times the tolerance, down to the $10^{-12}$ to which the
references are known. But it stops the whole chain at every event of any contact. For an error of $10^{-8}$ it needs
about 5 times as many evaluations as event-corrected steps if only beads that move are counted (figure x42 b). `flow`
itself does not leave out those at rest, and needs nearly 30 times as many. So event-corrected steps are the cheapest
for long runs of many beads; `flow` has an error that one can ask for, in any precision, and it is cheap for a breather,
whose few beads have few events. */
void report_flow(Report& report, Table& errors, const References& open) {
  Table& segment = report.table("one_segment");
  const double exact = extrapolated(13, 2), nearly = extrapolated(12, 2);
  for (int levels = 1; levels <= 8; ++levels) {
    const auto error = [&](double power) {
      const double x = extrapolated(levels, power);
      return compare(std::abs(x - nearly), std::abs(x - exact));
    };
    segment.add(
        {{"levels", "of the extrapolation", levels},
         {"in_t", "error with steps that are equal in t", error(1), "", "of two references"},
         {"in_u", "error with steps that are equal in u", error(2), "", "of two references"}});
  }

  // The impacts again, with a hundredth of the tolerance each time; `moving`: the fraction of beads that move
  const double h = 0.05, moving = error_of(verlet_2, h, open).evaluations / (duration / h + 1);
  std::vector<double> tolerances;
  for (int k = 2; k <= (report.quick ? 3 : 6); ++k) tolerances.push_back(std::pow(10, -2 * k));
  std::vector<OrbitError> found(tolerances.size());
  parallel_for("flow", found.size(), [&](std::size_t i) {
    found[i] = orbit_error(open, [&](State<double>& state) {
      const EventTolerance<double> rule{.tolerance = tolerances[i]};
      const auto evaluations = double(flow(open.chain, state, duration, rule).evaluations);
      return evaluations * moving * double(open.chain.sites);
    });
  });
  for (std::size_t i = 0; i < found.size(); ++i)
    errors.add(orbit_row("flow", "open", tolerances[i], found[i]));
}

/**
## The error of the linearised flow (figure x05 b)

Floquet multipliers and Newton's method need the derivative of the flow with respect to the initial state. The
stiffness of a contact begins like $(t-t^*)^{1/2}$, so the error of this derivative falls more slowly by one power:
like $h^{3/2}$. We follow one tangent vector, the change caused by displacing the central bead, over one period of the
site-centred breather of frequency 1.1. An ordinary integrator can propagate it: it gets the same drifts, and kicks by
the linearised force. */
const Shooting<double> problem = breather_problem(Centre::site, 1.1, 0, 31);
const double period = 2 * std::numbers::pi / problem.omega;
const std::size_t centre = problem.chain.sites / 2;

std::vector<double> tangent_by_splitting(const State<double>& breather, const Scheme& scheme,
                                         std::size_t steps) {
  const Chain& chain = problem.chain;
  State<double> state = breather, change(chain.sites);
  change.y[centre] = 1;
  Window all{0, chain.sites};
  for (std::size_t k = 0; k < stage_count(scheme, steps); ++k) {
    const auto stage = stage_at<double>(scheme, period / double(steps), steps, k);
    const auto stiffness = linearise(chain, state.y);  // symmetric and tridiagonal
    for (std::size_t n = 0; n < chain.sites; ++n) {
      double force = stiffness.diagonal[n] * change.y[n];
      if (n > 0) force += stiffness.off[n - 1] * change.y[n - 1];
      if (n + 1 < chain.sites) force += stiffness.off[n] * change.y[n + 1];
      change.v[n] -= stage.kick * force;
    }
    for (std::size_t n = 0; n < chain.sites; ++n) change.y[n] += stage.drift * change.v[n];
    kick_drift(chain, state, all, stage.kick, stage.drift);
  }
  return change.y;
}

template <class T>
std::vector<double> tangent_by_flow(const State<double>& breather, const EventTolerance<T>& rule,
                                    double& evaluations) {
  State<T> state(problem.chain.sites);
  std::copy(breather.y.begin(), breather.y.end(), state.y.begin());
  Tangent<T> tangent(problem.chain.sites, 1);  // one column
  std::fill(tangent.entries.begin(), tangent.entries.end(), T(0));
  tangent(centre, 0) = T(1);
  evaluations = double(flow(problem.chain, state, T(period), rule, &tangent).evaluations);
  std::vector<double> out;
  for (std::size_t n = 0; n < problem.chain.sites; ++n) out.push_back(double(tangent(n, 0)));
  return out;
}

/**
The reference is `flow` in extended precision, which the splittings approach to some $10^{-9}$. As `flow` chooses its
own steps, the error stands against the number of force evaluations in one period.

| power of the step with which the error of the tangent falls | expected | measured |
|---|---|---|
| velocity Verlet, from 1024 steps a period on | 3/2 | [1.51 ± 0.08](cell:tangent_orders/method=verlet/order) |
| splitting of order six | 3/2 | [1.6 ± 0.1](cell:tangent_orders/method=blanes_moan_6/order) |

Verlet's longer steps are left out, since there the error of its order two prevails. A high order gains nothing here: at
equal work Verlet's method is better than that of order six over most of the range. */
void report_tangents(Report& report) {
  Table &table = report.table("error_tangent"), &orders = report.table("tangent_orders");
  const State<double> breather = find_breather(problem).start;
  double evaluations = 0;
  const auto exact = tangent_by_flow(breather, EventTolerance<long double>{}, evaluations);
  const auto add = [&](const std::string& method, double error) {
    table.add({{"method", "integrator", method},
               {"evaluations", "force evaluations", evaluations},
               {"tangent", "largest error in the tangent vector", error}});
  };

  // Splittings, with twice as many steps each time
  for (const auto& [name, scheme] :
       {std::pair{"verlet", verlet()}, {"blanes_moan_6", blanes_moan_6()}}) {
    std::vector<double> step, error;
    for (int k = 0; k <= (report.quick ? 3 : 10); ++k) {
      const std::size_t steps = std::size_t(16) << k;
      step.push_back(period / double(steps));
      error.push_back(largest_difference(tangent_by_splitting(breather, scheme, steps), exact));
      evaluations = double(stage_count(scheme, steps));
      add(name, error.back());
    }
    const double longest = scheme.order > 2 || report.quick ? 1 : period / 1024;
    orders.add({{"method", "splitting", name},
                {"order", "power of the step with which the error of the tangent falls",
                 order(step, error, 0, {.longest = longest}), "",
                 "fit, and two steps less; the power is known to 10 per cent"}});
  }

  // flow, with a tenth of the tolerance each time
  for (double tolerance = 1e-3; tolerance > 5e-15; tolerance /= report.quick ? 1e4 : 10) {
    const EventTolerance<double> rule{.tolerance = tolerance};
    const double error = largest_difference(tangent_by_flow(breather, rule, evaluations), exact);
    add("flow", error);
  }
}

/**
## What this rests on

The orders are from four impacts and three events in hard wells, and from one tangent vector of one breather. Whether
events affect a given result is examined in its chapter. */
void reproduce(Report& report) {
  report.output.note("tolerance", "references at step 1/1024 and in extended precision");
  report_events(report);
  const References open = references_of(hard_chain), closed = references_of(compressed_chain);
  Table &errors = report.table("error_orbit"), &orders = report.table("orders");
  const int halvings = report.quick ? 2 : 6;
  report_orders(errors, orders, open, halvings, "open",
                {verlet_2, order_4, order_6, reach_2, reach_6});
  report_orders(errors, orders, closed, halvings, "closed", {order_4, order_6});
  report_flow(report, errors, open);
  report_tangents(report);
}

/**
## Try it

**To change it.** Another method is one more `Tested` and a name in the list in `reproduce`; other impacts are
`velocities`, another well is the second member of the chains. The program stops if the references do not pass their two
checks.

1. *Easy.* When does a run have no contact events?
   `build/bin/sec34_impact run --velocity 0.5 --s 1 --time 50 --precompression 5` gives `centre` = 67.48323. Hint:
   contacts that stay closed are smooth, and every splitting has its full order; the table shows two.
2. *Harder.* For which contacts would the events not matter to a method of order four?
   `build/bin/sec34_impact run --velocity 1.8 --s 1 --time 50 --contact power --alpha 3` gives `centre` = 4.58100. Hint:
   a force that begins like $(t-t^*)^\alpha$ costs $h^{1+\alpha}$. */
int main(int argc, char** argv) {
  return run(
      {"secA_integrators", "A", "The order of integrators at contact events (appendix)", reproduce},
      argc, argv);
}
