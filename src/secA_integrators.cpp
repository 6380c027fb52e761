/**
# Appendix: the order of integrators at contact events

How accurate is an integrator if the force is not smooth where a contact opens or closes? The contact force is exactly
zero before the contact closes at $t^*$, and then begins like $(t-t^*)^{3/2}$. So the order of an ordinary method of
order four or six falls to 5/2, and to 3/2 for the derivative of the motion with respect to the initial state. Two
methods of ours treat these *contact events*: event-corrected steps, for long runs, and `flow`, for orbits and their
derivatives, which stops at the events. We measure their errors and explain `flow`.

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
#include <tuple>
#include <vector>

#include "lattice/events/event_driven.hpp"          // flow
#include "lattice/integrators/event_corrected.hpp"  // EventCorrected, Splitting, evolve
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/orbits/breather.hpp"
#include "report/program.hpp"

using namespace lattice;
using namespace report;

/**
## What to expect

An integrator that steps across $t^*$ with the step $h$ makes an error of a fraction of the impulse $h\cdot h^{3/2}$;
the fraction depends on where in the step the event falls. So its error falls like $h^{5/2}$, however high its order is
for smooth forces; a method of order two, such as Verlet's, keeps its order. An event-corrected step replaces this
impulse by an integral of the force along an interpolated path, and corrects a formula of order six; what that leaves is
of size $h^5$ (event_corrected.hpp).

The steps next to an event count, too, because the force is smooth there but close to its singular point. At a distance
of $k$ steps a formula of order six errs by $h^7$ times the sixth derivative of $(t-t^*)^{3/2}$, that is by
$h^{5/2}k^{-9/2}$. By default we correct up to two steps from an event (`reach`); what that leaves out exceeds $h^5$ at
small steps.

The ordinary integrators are symmetric splittings, kicks by the force and drifts with the velocity, of order two
(Verlet), four and six (schemes.hpp). The order is the slope of a least-squares line on logarithmic axes; its
uncertainty is the standard error or, if that is larger, the change without the two longest steps. */
constexpr double velocities[]{1.6, 1.7, 1.8, 1.9};
constexpr int phases = 4;  // of a period, at which a tangent vector starts
constexpr double duration = 50, reference_step = 1. / 1024, far_reach = 6;
const Chain hard_chain{100, Quartic{1}, Hertz{}};
const Chain compressed_chain{100, Quartic{1}, CompressedHertz{5}};  // no contact opens

struct Tested {
  std::string name;
  std::function<Method(double step)> with;
};
const Tested verlet_2{"verlet", [](double h) { return Splitting{verlet(), h}; }};
const Tested order_4{"blanes_moan_4", [](double h) { return Splitting{blanes_moan_4(), h}; }};
const Tested order_6{"blanes_moan_6", [](double h) { return Splitting{blanes_moan_6(), h}; }};
const Tested two_steps{"two_steps", [](double h) { return EventCorrected{h}; }};
const Tested six_steps{"six_steps",
                       [](double h) { return EventCorrected{.step = h, .reach = far_reach}; }};

std::vector<double> step_lengths(int halvings) {
  std::vector<double> steps;
  for (int k = 0; k <= 2 * halvings; ++k) steps.push_back(0.2 * std::pow(2, -0.5 * k));
  return steps;
}

// What belongs to a fit: steps of a range, and errors that are not those of the reference
struct Fit {
  double least = 0, longest = 1, shortest = 0;
};

Estimate order(const std::vector<double>& step, const std::vector<double>& error, const Fit& fit) {
  std::vector<double> x, y;
  for (std::size_t k = 0; k < step.size(); ++k) {
    if (step[k] > fit.longest || step[k] < fit.shortest || error[k] < fit.least) continue;
    x.push_back(std::log(step[k]));
    y.push_back(std::log(error[k]));
  }
  const Line line = fit_line(x, y);
  if (x.size() < 5) return line.estimate();
  x.erase(x.begin(), x.begin() + 2);
  y.erase(y.begin(), y.begin() + 2);
  return {line.slope, std::max(line.slope_error, std::abs(fit_line(x, y).slope - line.slope))};
}

double largest_error(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, std::abs(a[n] - b[n]));
  return most;
}

/**
## One event alone

Two beads in hard wells, of the masses 1 and 4, have one contact, which closes, opens or grazes: it closes for a short
time, with a largest overlap of 0.02. At the event the heavier bead rests at 0.7, and the lighter one is at 0.7 plus the
overlap. From there `flow` in extended precision goes back for a time between 0.4 and 0.6, turns round, and goes on for
a unit of time to the exact end. The root mean square over 128 such starts has the event anywhere within a step.

| power of the step with which the error falls | closing | opening | grazing |
|---|---|---|---|
| not corrected | [2.48 ± 0.01](cell:event_orders/event=closing/plain) | [2.47 ± 0.01](cell:event=opening/plain) | [2.50 ± 0.04](cell:event=grazing/plain) |
| reach of two steps, $h$ from 0.2 to 0.05 | [5.0 ± 0.3](cell:event_orders/event=closing/two_long) | [5.3 ± 0.3](cell:event=opening/two_long) | [4.8 ± 0.4](cell:event=grazing/two_long) |
| the same, $h$ up to 0.0125 | [2.55 ± 0.03](cell:event_orders/event=closing/two_short) | [2.51 ± 0.03](cell:event=opening/two_short) | [2.63 ± 0.04](cell:event=grazing/two_short) |
| reach of six steps, all $h$ | [4.92 ± 0.06](cell:event_orders/event=closing/six) | [5.2 ± 0.1](cell:event=opening/six) | [4.9 ± 0.1](cell:event=grazing/six) | */
struct Event {
  const char* name;
  double overlap, rate;  // the latter: velocity of the lighter bead
};
struct Passage {
  State<double> start{2};
  std::vector<double> end{};
};

Chain two_beads() {
  Chain chain{2, Quartic{1}};
  vary(chain, {1, 4}, {});
  return chain;
}

// From the event back to the start, turned round and rounded, then forward
Passage passage(const Event& event, double before) {
  State<long double> state(2);
  state.y = {0.7 + event.overlap, 0.7};
  state.v = {-event.rate, 0};
  flow(two_beads(), state, before);
  Passage out;
  for (std::size_t n = 0; n < 2; ++n) {
    state.y[n] = out.start.y[n] = double(state.y[n]);
    state.v[n] = out.start.v[n] = -double(state.v[n]);
  }
  state.t = 0;
  flow(two_beads(), state, 1);
  out.end.assign(state.y.begin(), state.y.end());
  return out;
}

double passage_error(const EventCorrected& method, const std::vector<Passage>& passages) {
  double squares = 0;
  for (const auto& [start, end] : passages) {
    State<double> state = start;
    evolve(method, two_beads(), state, 1);
    const double error = largest_error(state.y, end);
    squares += error * error;
  }
  return std::sqrt(squares / double(passages.size()));
}

void report_events(Report& report) {
  const std::vector<double> steps = step_lengths(report.quick ? 5 : 6);
  const double least = 5e-15;  // ten times the rounding
  Table& orders = report.table("event_orders");
  for (const Event& event :
       {Event{"closing", 0, 0.7}, {"opening", 0, -0.7}, {"grazing", 0.02, 0}}) {
    std::vector<Passage> passages;  // the golden ratio spreads the starts
    for (int k = 0; k < 128; ++k)
      passages.push_back(passage(event, 0.4 + 0.2 * std::fmod(k * std::numbers::phi, 1)));
    std::vector<double> plain, two, six;
    for (const double h : steps) {
      // Without corrections: no force is worth one
      plain.push_back(passage_error({.step = h, .negligible = HUGE_VAL}, passages));
      two.push_back(passage_error({.step = h}, passages));
      six.push_back(passage_error({.step = h, .reach = far_reach}, passages));
    }
    orders.add({{"event", event.name},
                {"plain", order(steps, plain, {least})},
                {"two_long", order(steps, two, {.least = least, .shortest = 0.049})},
                {"two_short", order(steps, two, {.least = least, .longest = 0.013})},
                {"six", order(steps, six, {least})}});
  }
}

/**
## An impact (figure x05 a)

Now a run with many events: a strong impact on a hundred beads in hard wells, Eqs. (9) and (10) with $s = 1$. The chain
is at rest, the first bead gets the velocity $v_0$, Eq. (26), and we compare the displacements at $t = 50$. The errors
of single events have random signs, so we take the root mean square over four impact velocities.

The references are runs with the step 1/1024, a `reach` of six steps and another formula of order six. The program stops
unless `flow` ends within $10^{-11}$ of them and, with the same step, the tested method within $10^{-12}$. */
struct References {
  Chain chain;
  std::vector<State<double>> end{};  // one for each velocity
  double error = 0;
};

// Root mean square over the impacts, of the largest error of a displacement
double error_of(const Tested& method, double step, const References& references) {
  double squares = 0;
  for (std::size_t k = 0; k < std::size(velocities); ++k) {
    State<double> state(references.chain.sites);
    state.v[0] = velocities[k];
    evolve(method.with(step), references.chain, state, duration);
    const double error = largest_error(state.y, references.end[k].y);
    squares += error * error;
  }
  return std::sqrt(squares / double(std::size(velocities)));
}

References references_of(const Chain& chain) {
  const EventCorrected other{
      .step = reference_step, .base = nystrom(blanes_moan_6_14()), .reach = far_reach};
  References out{chain};
  for (const double v0 : velocities) {
    State<double> state(chain.sites);
    state.v[0] = v0;
    State<double> by_flow = state;
    evolve(other, chain, state, duration);
    flow(chain, by_flow, duration, {.tolerance = 1e-12});
    if (!(largest_error(state.y, by_flow.y) < 1e-11)) throw Failure("flow ends elsewhere");
    out.end.push_back(state);
  }
  out.error = error_of(six_steps, reference_step, out);
  if (!(out.error < 1e-12)) throw Failure("the references have not converged");
  return out;
}

/**
Splittings of order four and six err with the powers [2.63 ± 0.08](cell:orders/method=blanes_moan_4/contacts=open/order)
and [2.59 ± 0.08](cell:orders/method=blanes_moan_6/contacts=open/order) of the step, event-corrected steps (reach six)
with [5.0 ± 0.5](cell:orders/method=six_steps/contacts=open/order), Verlet's method with
[2.0](cell:orders/method=verlet/contacts=open/order). All but the last are irregular in $h$, as the places of the events
in their steps are. A control has the same impacts on a chain compressed by $\delta_0 = 5$, Eq. (33): opening one of its
contacts needs the energy $\frac35\delta_0^{5/2} = 33.5$; no impact brings more than 1.81. There order four gives
[4.0](cell:orders/method=blanes_moan_4/contacts=closed/order) and order six
[6.00](cell:orders/method=blanes_moan_6/contacts=closed/order). */
void report_orders(Report& report) {
  const std::vector<double> steps = step_lengths(report.quick ? 2 : 6);
  Table &errors = report.table("error_orbit"), &orders = report.table("orders");
  for (const bool open : {true, false}) {
    const References references = references_of(open ? hard_chain : compressed_chain);
    std::vector<Tested> methods{order_4, order_6};
    if (open) methods = {verlet_2, order_4, order_6, two_steps, six_steps};
    for (const Tested& method : methods) {
      std::vector<double> error(steps.size());
      parallel_for(method.name, steps.size(),
                   [&](std::size_t k) { error[k] = error_of(method, steps[k], references); });
      for (std::size_t k = 0; open && k < steps.size(); ++k)
        errors.add({{"method", method.name}, {"step", steps[k]}, {"error", error[k]}});
      // With a reach of two the error bends from h^5 to h^(5/2): one slope would mean nothing
      if (method.name == two_steps.name) continue;
      const Estimate power = order(steps, error, {.least = 10 * references.error});
      orders.add(
          {{"method", method.name}, {"contacts", open ? "open" : "closed"}, {"order", power}});
    }
  }
}

/**
## How `flow` works (figure x42)

Between two events the motion is smooth, and `flow` ends steps at them. But right after $t^*$ the force still behaves
like $(t-t^*)^{3/2}$, and its derivatives blow up. Yet the whole solution is a power series in $(t-t^*)^{1/2}$. With $t
= t^*+u^2$ it is one in $u$, and a formula has its full order again. A segment of length $L$ between events needs this
at both ends, so the library has $t = t^*+L\,(3\theta^2-2\theta^3)$ with $0\le\theta\le1$ (location.hpp).

The formula is the leapfrog with $j = 1, 2, 3, \dots$ steps. They are equal in $\theta$, hence symmetric in time, so
that the error is a series in $j^{-2}$, which extrapolation removes term by term. Here it is for one bead that meets a
wall with velocity 1, $\ddot x = -x-x_+^{3/2}$, over half a unit of time after the contact closes.

![Errors of extrapolation after one contact event.](fig:x42)

From five levels on, steps equal in $u$ are better. With eight, 36 evaluations of the force, their error is
[1.22e-10](cell:one_segment/levels=8/in_u), in steps equal in $t$ [5.04e-7](cell:one_segment/levels=8/in_t). `flow`
raises the number of levels until two successive values agree within the tolerance, and shortens a step if they do not.

Events are seen by looking ahead with a plain leapfrog and located with parabolas of the overlap (overlap.hpp). The
slowest are left out, and those very close in time count as one (event_driven.cpp); at the others the whole chain stops.
A tangent vector passes an event without a jump, since the contact force is continuous. */
// x at t = 0.5 by steps that are equal in t (exponent 1) or in u (exponent 2)
double leapfrog(int steps, double exponent) {
  double x = 0, v = 1;
  const auto t = [&](int i) { return 0.5 * std::pow(double(i) / (2 * steps), exponent); };
  for (int i = 1; i < 2 * steps; i += 2) {
    x += (t(i) - t(i - 1)) * v;
    v -= (t(i + 1) - t(i - 1)) * (x + x * std::sqrt(x));
    x += (t(i + 1) - t(i)) * v;
  }
  return x;
}

// The polynomial in j^-2 through the results of 1, 2, ... steps, at zero, by Neville's recursion
double extrapolated(int levels, double exponent) {
  std::vector<double> table;
  for (int j = 1; j <= levels; ++j) {
    table.push_back(leapfrog(j, exponent));
    for (int i = j - 1; i > 0; --i) {
      const double ratio = double(j) / i;
      table[i - 1] = table[i] + (table[i] - table[i - 1]) / (ratio * ratio - 1);
    }
  }
  return table[0];
}

void report_segment(Report& report) {
  Table& segment = report.table("one_segment");
  const double exact = extrapolated(13, 2), nearly = extrapolated(12, 2);
  for (int levels = 1; levels <= 8; ++levels) {
    const auto error = [&](double exponent) {
      const double x = extrapolated(levels, exponent);
      return with_error(std::abs(x - nearly), std::abs(x - exact));
    };
    segment.add({{"levels", levels}, {"in_t", error(1)}, {"in_u", error(2)}});
  }
}

/**
## The error of the linearised flow (figure x05 b)

Floquet multipliers and Newton's method need the derivative of the flow with respect to the initial state. The
stiffness of a contact begins like $(t-t^*)^{1/2}$, so the error of this derivative falls like $h^{3/2}$. We follow one
tangent vector, the change caused by displacing the central bead, over one period of the site-centred breather of
frequency 1.1, from four starts within the period. An ordinary integrator gives it the same drifts, and kicks by the
linearised force. */
struct Transported {
  std::vector<double> tangent;
  double evaluations;  // of the force
};

Transported by_splitting(const Chain& chain, State<double> state, double time, const Scheme& scheme,
                         std::size_t steps) {
  const std::size_t sites = chain.sites, stages = stage_count(scheme, steps);
  State<double> change(sites);
  change.y[sites / 2] = 1;
  Window all{0, sites};
  for (std::size_t k = 0; k < stages; ++k) {
    const auto stage = stage_at<double>(scheme, time / double(steps), steps, k);
    const auto stiffness = linearise(chain, state.y);  // symmetric and tridiagonal
    for (std::size_t n = 0; n < sites; ++n) {
      double force = stiffness.diagonal[n] * change.y[n];
      if (n > 0) force += stiffness.off[n - 1] * change.y[n - 1];
      if (n + 1 < sites) force += stiffness.off[n] * change.y[n + 1];
      change.v[n] -= stage.kick * force;
    }
    for (std::size_t n = 0; n < sites; ++n) change.y[n] += stage.drift * change.v[n];
    kick_drift(chain, state, all, stage.kick, stage.drift);
  }
  return {change.y, double(stages)};
}

template <class T>
Transported by_flow(const Chain& chain, const State<double>& start, double time,
                    const EventTolerance<T>& rule) {
  State<T> state(chain.sites);
  state.y.assign(start.y.begin(), start.y.end());
  state.v.assign(start.v.begin(), start.v.end());
  Tangent<T> tangent(chain.sites, 1);  // one column
  std::swap(tangent(0, 0), tangent(chain.sites / 2, 0));
  const auto evaluations = flow(chain, state, T(time), rule, &tangent).evaluations;
  const auto begin = tangent.entries.begin(), end = begin + long(chain.sites);
  return {std::vector<double>(begin, end), double(evaluations)};
}

/**
The reference is `flow` in extended precision; the error is the root mean square over the starts. It falls with the
power [1.54 ± 0.08](cell:tangent_orders/method=blanes_moan_6/order) of the step for the splitting of order six, and with
[1.3 ± 0.1](cell:tangent_orders/method=verlet/order) for the six shortest steps of Verlet's method; so a high order
gains nothing. `flow` chooses its own steps, and is below $10^{-8}$ with less than 2000 evaluations of the force. */
void report_tangents(Report& report) {
  const Shooting<double> problem = breather_problem(Centre::site, 1.1, 0, 31);
  const double period = 2 * std::numbers::pi / problem.omega;
  const Chain& chain = problem.chain;
  State<double> state = find_breather(problem).start;
  std::vector<State<double>> starts;
  std::vector<Transported> exact;
  for (int k = 0; k < phases; ++k) {
    starts.push_back(state);
    exact.push_back(by_flow(chain, state, period, EventTolerance<long double>{}));
    flow(chain, state, period / 2 * std::numbers::phi);
    state.t = 0;
  }
  Table &table = report.table("error_tangent"), &orders = report.table("tangent_orders");
  const auto add = [&](const std::string& method, const auto& transported) {
    double squares = 0, evaluations = 0;
    for (std::size_t k = 0; k < starts.size(); ++k) {
      const Transported one = transported(starts[k]);
      const double error = largest_error(one.tangent, exact[k].tangent);
      squares += error * error / phases;
      evaluations += one.evaluations / phases;
    }
    table.add({{"method", method}, {"evaluations", evaluations}, {"tangent", std::sqrt(squares)}});
    return std::sqrt(squares);
  };

  // Splittings, with twice as many steps each time; flow, with a tenth of the tolerance
  const double most = report.quick ? 1500 : 50000;  // evaluations
  for (const auto& [name, scheme, fitted] :
       {std::tuple{"verlet", verlet(), 33}, {"blanes_moan_6", blanes_moan_6(), 5000}}) {
    std::vector<double> step, error;
    for (std::size_t steps = 16; double(stage_count(scheme, steps)) < most; steps *= 2) {
      step.push_back(period / double(steps));
      error.push_back(add(name, [&](const auto& start) {
        return by_splitting(chain, start, period, scheme, steps);
      }));
    }
    orders.add(
        {{"method", name}, {"order", order(step, error, {.longest = fitted * step.back()})}});
  }
  for (double tolerance = 1e-3; tolerance > 5e-13; tolerance /= report.quick ? 1e4 : 10)
    add("flow", [&](const State<double>& start) {
      return by_flow(chain, start, period, EventTolerance<double>{.tolerance = tolerance});
    });
}

void reproduce(Report& report) {
  report_events(report);
  report_orders(report);
  report_segment(report);
  report_tangents(report);
}

/**
## Try it

**To change it.** Another method is one more `Tested` and a name in `report_orders`; other impacts are `velocities`,
another well is the second member of the chains (not a soft one: with `Quartic{-0.1}` the program stops). A contact
force that begins like $(t-t^*)^\alpha$ should limit ordinary methods to the order $1+\alpha$; for `PowerContact{3}` in
place of `Hertz{}` that is 4.

1. *Harder.* Which step does Verlet's method need for a packet?
   `build/bin/sec34_impact run --velocity 1.8 --s 1 --time 50` gives `centre` = 8.78688. Hint: let the program of
   sec1_the_chain.cpp find this, `packet_centre` at the end of such an impact, at the steps of figure x05(a). */
int main(int argc, char** argv) {
  return run(
      {"secA_integrators", "A", "The order of integrators at contact events (appendix)", reproduce},
      argc, argv);
}
