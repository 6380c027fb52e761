#pragma once
/**
# Runge-Kutta methods as the field uses them

Our own steppers know about contacts (contact_rkn.hpp). Most published computations with such chains come from
general methods that do not: Runge-Kutta methods with a fixed step, or with steps that a program chooses so that
an estimate of its error stays below a tolerance. To find out what such a choice does to a number we need these
methods as they are. They solve $\dot x = f(x)$ by
$$X_i = x + h\sum_{j<i}\alpha_{ij}f(X_j), \qquad x' = x + h\sum_j\beta_jf(X_j).$$ */

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "lattice/integrators/schemes.hpp"
#include "lattice/numerics/rhs.hpp"

namespace lattice {

/// The table of a method and, for an embedded pair, the weights of its error estimate: those of the method
/// less those of the lower order.
struct RungeKutta {
  std::string name;
  int order;                                ///< of the result that is carried on
  std::vector<std::vector<double>> stages;  ///< alpha; row i has i entries
  std::vector<double> weights, error{};     ///< beta, and the differences; empty without a pair
};

/// The classical method of order four.
RungeKutta classical_4();

/// Runge-Kutta-Fehlberg 4(5) (NASA TR R-315, 1969), carried on with the result of order five.
RungeKutta fehlberg_5();

/// Dormand and Prince 5(4) (J. Comput. Appl. Math. 6, 1980); the last stage is the new state.
RungeKutta dormand_prince_5();

/**
For $\ddot y = g(y)$ the velocities can be eliminated: the positions of a stage then depend on the earlier
accelerations by way of $\alpha^2$, and the new positions by way of $\beta\alpha$. */
/// The method for equations of second order; a stage of zero weight is added if the last one is not the new
/// state.
Nystrom nystrom(const RungeKutta& method);

/**
## Steps that follow an estimated error

The error of component $i$ is measured in units of $a + r\,\max(|x_i|, |x'_i|)$, with the absolute and the relative
tolerance $a$ and $r$. How the components make one number is a matter of taste: programs take the largest, the root
of the sum of the squares, or the root of their *mean*. A step is accepted if this number is at most one. The last
choice is the loosest: in a chain most of which is at rest, the mean is taken over many components without any
error. */
enum class ErrorNorm { largest, two, rms };

/// Tolerances and norm of a controlled step; the defaults are those of common programs.
struct StepControl {
  double relative = 1e-3, absolute = 1e-6;  ///< r and a
  ErrorNorm norm = ErrorNorm::rms;
  double first = 1e-3;  ///< step to begin with
};

/// What a controlled run did.
struct ControlledRun {
  std::size_t accepted = 0, rejected = 0;  ///< steps
};

/**
The next step is the old one times $0.9\,e^{-1/5}$, where $e$ is the error in those units, at least a fifth and at
most ten times as long; after a rejected step it does not grow. Samples lie on the cubic through both ends of a step
with the slopes there, so that they do not shorten the steps. */
/// Carries `x` over `duration`; `observe(t, x)` is called at the start and after each of `samples` equal
/// intervals. Throws std::runtime_error if the step becomes too small or a value infinite.
ControlledRun integrate_controlled(
    const RungeKutta& pair, const Rhs& rhs, std::vector<double>& x, double duration,
    std::size_t samples, const StepControl& control,
    const std::function<void(double, const std::vector<double>&)>& observe);

/// The same in `steps` equal steps between samples.
void integrate_fixed(const RungeKutta& method, const Rhs& rhs, std::vector<double>& x,
                     double duration, std::size_t samples, std::size_t steps,
                     const std::function<void(double, const std::vector<double>&)>& observe);

}  // namespace lattice
