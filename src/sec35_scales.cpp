/**
# 3.5 Scales: a cradle is not an array

When is the chain of this book a good picture of real beads? Two times decide. Beads of the mass $m$ that push on each
other with $\gamma x^{3/2}$ at the overlap $x$ and collide at the speed $V$ touch for a time of order $\tau_h$, and
in a well of the stiffness $k$ each of them swings with the period $2\pi\tau_c$,
$$\tau_h = \Bigl(\frac{m^2}{\gamma^2V}\Bigr)^{1/5},\qquad \tau_c = \Bigl(\frac mk\Bigr)^{1/2}.$$
Their ratio is the only parameter that an impact leaves, Eqs. (29) and (30),
$$\lambda = (\tau_c/\tau_h)^2,\qquad \dot y_1(0) = \lambda^{5/2} = (\tau_c/\tau_h)^5,$$
if lengths are measured by $\xi = (k/\gamma)^2$, at which well and contact are equally strong, and times by $\tau_c$. A
travelling breather needs a small $\lambda$: contacts must last for a good part of an oscillation.

![Newton's cradle and an array of clamped cantilevers decorated by beads.](fig:01)

Section 3.5 of James, Kevrekidis and Cuevas (Physica D 251, 2013) puts numbers in: for a cradle $\lambda^{5/2}$ is
astronomical, for stiff cantilevers it is less than one. Here every constant is derived in SI units. */

#include <cmath>
#include <numbers>

#include "lattice/model/cantilever.hpp"
#include "report/program.hpp"
#include "sec35/all_scales.hpp"
#include "sec35/collision.hpp"

using namespace lattice;

/**
## Two beads

All scales rest on the collision of two free beads, so we begin with one (collision.hpp); its units are $\tau_h$ and
$\delta = (mV^2/\gamma)^{2/5}$. Integrated, it lasts for [2.43884](num:scale.contact_time) $\tau_h$, printed as 2.43,
and the largest compression is [0.828614](num:scale.max_compression) $\delta$, where the article has 0.76; it quotes
both numbers from other works. The conservation of energy gives the same as the integration: all energy of the relative
motion, $\frac14mV^2$, is in the contact, $\frac25\gamma\,x^{5/2}$, when $x = (5/8)^{2/5}\,\delta$. With the reduced
mass $\mu = \frac12m$ this is $(\mu V^2/K)^{2/5}$, $K = \frac45\gamma$. A possible cause of the quoted 0.76 is $\gamma$
in the place of $K$, which gives $2^{-2/5}\,\delta$. But the quoted contact time has the right constant: at given $V$ it
is proportional to the compression, and with 0.76 it would be
[2.23689](num:sec35_scales.contact_time_of_printed_compression) $\tau_h$ and not 2.43.

A cradle whose strings have the length $L$ has $\tau_c^2 = L/g$. A collision of steel balls was measured to take 0.077
ms, and this over the contact time in units of $\tau_h$ is $\tau_h$. As $\lambda^{5/2} = (L/g\tau_h^2)^{5/2}$ contains
the fifth power of $\tau_h$, an error of one per cent in the contact time becomes five, and rounding matters. The
article prints $L = 0.5$ m and 2.43, but no $g$. With $g = 10$ m/s² $\lambda^{5/2}$ is [1.74986e19](num:scale.cradle),
the printed value; with 9.81 m/s² it is [1.83582e19](num:sec35_scales.cradle_printed_rounding), and with all digits of
the contact time [1.86945e19](num:sec35_scales.cradle_converged). Either way a collision is over long before a pendulum
has moved, and breathers do not travel there. */
void report_collision(Report& report) {
  const double step = report.quick ? 0.2 : 0.1;
  const Collision coarse = collide(step), fine = collide(step / 2), known = collision_by_energy();
  const Estimate time = compare(coarse.contact_time, fine.contact_time);
  const Estimate compression = compare(coarse.compression, fine.compression);
  if (std::abs(time.value - known.contact_time) > 1e-7 ||
      std::abs(compression.value - known.compression) > 1e-7)
    throw Failure("the integrated collision disagrees with the conservation of energy");
  report.facts.add("contact_time", time, "tau_h");
  report.facts.add("max_compression", compression, "delta");
  report.facts.add("cradle", exact(cradle(10, 2.43)));
  report.facts.add("contact_time_by_gamma", exact(known.contact_time), "tau_h");
  report.facts.add("compression_by_energy", exact(known.compression), "delta");
  report.facts.add("compression_printed", exact(std::pow(0.5, 0.4)), "delta");
  report.facts.add("contact_time_of_printed_compression",
                   exact(0.76 * known.contact_time / known.compression), "tau_h");
  const double ratio = cradle(9.81, time.value);
  report.facts.add("cradle_converged", {ratio, 5 * ratio * time.error / time.value});
  report.facts.add("cradle_printed_rounding", exact(cradle(9.81, 2.43)));
}

/**
## The beam and the scales

The article replaces a beam of the length $\ell$ by a spring and a point mass, with factors that it prints with two or three
digits, so we compute them. We integrate $u'''' = x^4u$ for the deflection $u$, where $x$ is now the wavenumber times
$\ell$, along half of the beam (cantilever.hpp). The stiffness is that against a steady push at the middle; the wavenumber
is then $x = 0$ and the solution a cubic, which the Runge–Kutta method reproduces exactly, so that only rounding is left.
For the frequency an independent route is
$\cos x\cosh x = 1$.

| of a clamped beam | printed | computed |
|---|---|---|
| stiffness, in $EI/\ell^3$ | 192 | [192.000 ± 1e-12](num:beam.stiffness) |
| frequency $x^2$, in $(EI/\rho A)^{1/2}/\ell^2$ | 22.4 | [22.3733 ± 5e-10](num:beam.frequency) |
| effective mass, in masses of the beam | 0.38 | [0.383567 ± 2e-11](num:beam.mass) |

Here $EI$ is the bending stiffness and $\rho A$ the mass per length. Two beads at the middle change the shape of the
vibration, so that one point mass for beam and beads is an approximation: the frequency of the model is
[0.998945](num:sec35_scales.point_mass_frequency_ratio) times that of the decorated beam. */
void report_beam(Report& report, const CantileverArray& array) {
  const auto both = [](auto of) { return compare(of(200), of(400)); };
  const double x = clamped_root(), by_shooting = ClampedBeam{}.wavenumber();
  const auto mass = [](double root) { return 192 / (root * root * root * root); };
  const double load = 2 * array.bead_mass() / array.beam_mass();
  const double model = std::sqrt(192 * array.beam_mass() / array.mass());
  report.facts.add("beam_stiffness",
                   both([](std::size_t n) { return ClampedBeam{n}.stiffness(0); }));
  report.facts.add("beam_frequency", compare(by_shooting * by_shooting, x * x));
  report.facts.add("beam_mass", compare(mass(by_shooting), mass(x)));
  report.facts.add("point_mass_frequency_ratio", both([&](std::size_t n) {
                     const double exact_root = ClampedBeam{n, load}.wavenumber();
                     return model / (exact_root * exact_root);
                   }));
}

/**
## Cradle and array

With these two parts the article's array has, for an impact of 1 m/s, $\tau_h =$ [0.0465155](num:cantilever.tau_h) ms,
printed as 0.047, $\tau_c =$ [0.025219](num:cantilever.tau_c) ms, printed as 0.025, and $\lambda =$
[0.293941](num:cantilever.lambda), printed as 0.29. The two times are of the same order, and the impact of the dimensionless
chain, $\lambda^{5/2}$, is small: in such an array breathers can travel. `scales` prints all constants for an impact
velocity of your choice (sec35/all_scales.hpp); cantilever.hpp has the formulas.

## Losses

The beads of an array lose their energy in some 10 ms. The article's conclusion compares this with the growth of an
instability: a disturbance that is multiplied by $1+\epsilon$ in each period stays hidden if it does not grow by a factor
of $e$ in that time, that is for $\epsilon < 0.015$. With the printed period of 0.15 ms $(1+\epsilon)^{10/0.15} = e$ gives
[0.0151131](num:outlook.dominated), with $2\pi\tau_c$ [0.0159718](num:sec35_scales.epsilon_e_fold). */
void report_losses(Report& report, const StruckArray& array) {
  const double lifetime = 10, period = 0.15;  // ms
  const double linear_period = array.scales.milliseconds(2 * std::numbers::pi);
  report.facts.add("epsilon_printed_period", exact(std::expm1(period / lifetime)));
  report.facts.add("epsilon_e_fold", exact(std::expm1(linear_period / lifetime)));
}

/**
## Differences and limits

Of the printed numbers quoted here one is not found, the compression 0.76; that for $\lambda^{5/2}$ of the cradle is
found with $g = 10$ m/s² only. Hertz's coefficient needs the Young modulus of the beads,
$\gamma = \mathcal E\sqrt{2R}/(3(1-\nu^2))$ with their radius $R$ and Poisson's ratio $\nu$; the article prints the
symbol of the beam's, which would give a $\lambda$ that is not small. A beam is described by one number, the deflection
of its middle: its higher modes and its twisting are left out, and so is whatever a contact does beyond Hertz's static
law. */
void reproduce(Report& report) {
  const StruckArray array;
  report_collision(report);
  report_beam(report, array.array);
  report_scales(report, array);
  report_losses(report, array);
}

/**
## Try it

1. *Easy.* Strike the array ten times less: `build/bin/sec35_scales scales --velocity 0.1` gives `lambda` = 0.11702 and
   `contact_time` = 1.79796e-4. Hint: $\tau_h$ grows like $V^{-1/5}$, so that $\lambda$ falls like $V^{2/5}$ only, while the
   impact of the dimensionless chain, $\lambda^{5/2}$, is proportional to $V$.
2. *Harder.* How hard must one strike for $\lambda = 1$? `build/bin/sec35_scales scales --velocity 21.35` gives
   `lambda` = 1.0000 and `lambda_5_2` = 1.0001. Hint: this is $\xi/\tau_c$, the unit of velocity of the chain; its
   unit of force, in the same table, is 532 N.
3. *Harder.* Give the beads the Young modulus of the beams' steel: `build/bin/sec35_scales scales` gives
   `lambda_with_beam_modulus` = 14.63. Hint: harder contacts are shorter, and breathers need long ones.
4. *Open.* What cradle would show a travelling breather: which string, and which beads, how soft? */
int main(int argc, char** argv) {
  return run({"sec35_scales", "3.5", "Scales of a cradle and of an array (section 3.5)", reproduce,
              commands<AllScales>()},
             argc, argv);
}
