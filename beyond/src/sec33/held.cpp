#include "sec33/held.hpp"
#include "lattice/model/precisions.hpp"

namespace lattice {

/**
The sizes of positions and their equations are those of the inner problem; the parameter and the centre are
of order one. */
template <class T>
Sizes<T> Held<T>::sizes(const Vector<T>& x, bool scaled) const {
  const Sizes<T> inner = problem.sizes(x.head(x.size() - 1), scaled);
  Sizes<T> out{Vector<T>::Ones(x.size()), Vector<T>::Ones(x.size())};
  out.unknown.head(x.size() - 1) = inner.unknown;
  out.equation.head(x.size() - 1) = inner.equation;
  return out;
}

/**
An evaluation gives the velocities at $T_b/2$ and, as the last equation, the centre. The derivative of the latter
needs the positions at $T_b/2$ as well; these are in the same columns of the tangent. */
template <class T>
Evaluation<T> Held<T>::evaluate(const Vector<T>& x, const EventTolerance<T>& rule,
                                bool with_jacobian) const {
  const std::size_t n = sites();
  const auto last = Eigen::Index(n);
  Tangent<T> tangent(n, with_jacobian ? n : 0);
  Evaluation<T> out;
  const State<T> end = after_half(x, rule, out.flow, with_jacobian ? &tangent : nullptr);
  T weight(0), moment(0);
  for (std::size_t i = 0; i < n; ++i) {
    const T w = x[Eigen::Index(i)] * x[Eigen::Index(i)] + end.y[i] * end.y[i];
    weight += w;
    moment += w * place(i);
  }
  out.residual.resize(last + 1);
  for (std::size_t i = 0; i < n; ++i) out.residual[Eigen::Index(i)] = end.v[i];
  out.residual[last] = moment / weight - centre;
  if (with_jacobian) differentiate(x, rule, end, tangent, weight, out);
  return out;
}

template <class T>
Equations<T> Held<T>::equations() const {
  return {"breather constrained to a centre",
          [*this](const Vector<T>& x, const EventTolerance<T>& rule, bool derivative) {
            return evaluate(x, rule, derivative);
          },
          [*this](const Vector<T>& x, bool scaled) { return sizes(x, scaled); }};
}

/**
The flow's derivative with respect to a parameter is not computed, and we take a central difference
instead. Its step is small, because almost nothing in these equations fixes $p$: along the direction in
which the breather can be shifted their derivative is as small as the barrier (breather.hpp). */
template <class T>
void Held<T>::differentiate(const Vector<T>& x, const EventTolerance<T>& rule, const State<T>& end,
                            const Tangent<T>& tangent, const T& weight, Evaluation<T>& out) const {
  const std::size_t n = sites();
  const auto last = Eigen::Index(n);
  Vector<T> more = x, less = x;
  more[last] += T(change);
  less[last] -= T(change);
  FlowReport<T> unused;
  const State<T> up = after_half(more, rule, unused, nullptr),
                 down = after_half(less, rule, unused, nullptr);
  out.jacobian = Matrix<T>::Zero(last + 1, last + 1);
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = Eigen::Index(i);
    const T lever = T(2) * (place(i) - centre - out.residual[last]) / weight;
    for (std::size_t k = 0; k < n; ++k) {
      out.jacobian(row, Eigen::Index(k)) = tangent(n + i, k);
      out.jacobian(last, Eigen::Index(k)) += lever * end.y[i] * tangent(i, k);
    }
    out.jacobian(last, row) += lever * x[row];
    out.jacobian(row, last) = (up.v[i] - down.v[i]) / (T(2) * T(change));
    out.jacobian(last, last) += lever * end.y[i] * (up.y[i] - down.y[i]) / (T(2) * T(change));
  }
}

template <class T>
Vector<T> moved_to_centre(const Held<T>& held, Vector<T> x, const EventTolerance<T>& rule) {
  const Eigen::Index n = x.size() - 1;
  // Newton's method for the centre alone: the last unknown is a shift along the discrete gradient
  for (int k = 0; k < 4; ++k) {
    const Evaluation<T> here = held.evaluate(x, rule);
    Matrix<T> matrix = here.jacobian;
    for (Eigen::Index i = 0; i < n; ++i)
      matrix(i, n) = i > 0 && i + 1 < n ? x[i + 1] - x[i - 1] : T(0);
    matrix(n, n) = T(0);
    const Vector<T> step = solve_scaled<T>(matrix, here.residual, held.sizes(x, true), 0);
    x.head(n) -= step.head(n);
  }
  return x;
}

#define LIST(T)            \
  template struct Held<T>; \
  template Vector<T> moved_to_centre<T>(const Held<T>&, Vector<T>, const EventTolerance<T>&);
LATTICE_IN_EACH_PRECISION(LIST)
#undef LIST

}  // namespace lattice
