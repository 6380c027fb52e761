#include "sec5/solution_curve.hpp"

#include <stdexcept>

namespace lattice {
namespace {

/// The solution on the plane at `distance` from the point `from`, across the direction `along`.
Vector<double> next_solution(const Residual& residual, const Vector<double>& from,
                             const Vector<double>& along, double distance, double unit) {
  const auto evaluate = [&](const Vector<double>& x, const auto&, bool derivative) {
    const Eigen::Index n = x.size();
    Evaluation<double> out;
    out.residual.resize(n);
    out.residual << residual(x), (x - from).dot(along) - distance * unit;
    if (!derivative) return out;
    out.jacobian.resize(n, n);
    out.jacobian.topRows(n - 1) = central_differences<double>(residual, x, 1e-6 * unit);
    out.jacobian.row(n - 1) = along.transpose();
    return out;
  };
  const auto sizes = [&](const Vector<double>& x, bool) {
    const Vector<double> all = Vector<double>::Constant(x.size(), unit);
    return Sizes<double>{all, all};
  };
  NewtonRule<double> rule;
  rule.events.tolerance = 1e-11;
  const Vector<double> guess = from + distance * unit * along;
  return newton<double>({"the driven orbit", evaluate, sizes}, guess, rule).x;
}

/// The maximum of the parabola through the last three points, in Newton's form.
double top_of_parabola(const SolutionCurve& curve) {
  const std::size_t m = curve.points.size() - 3;
  const auto s = [&](std::size_t i) { return curve.length[m + i]; };
  const auto a = [&](std::size_t i) { return curve.points[m + i].tail<1>()[0]; };
  const double first = (a(1) - a(0)) / (s(1) - s(0)), second = (a(2) - a(1)) / (s(2) - s(1)),
               bend = (second - first) / (s(2) - s(0));
  const double top = (s(0) + s(1)) / 2 - first / (2 * bend);
  return a(0) + (top - s(0)) * (first + bend * (top - s(1)));
}

}  // namespace

SolutionCurve follow_solutions(const Residual& residual, Eigen::Index unknowns, double first,
                               double apart, double unit, double beyond) {
  const Eigen::Index last = unknowns - 1;
  Vector<double> at = Vector<double>::Zero(unknowns);
  Vector<double> tangent = Vector<double>::Unit(unknowns, last);
  SolutionCurve curve;
  double way = 0;
  for (int k = 0; k < int(20 / apart); ++k) {
    const Vector<double> next = next_solution(residual, at, tangent, k ? apart : first, unit);
    const bool falls = k >= 3 && next[last] <= at[last];
    way += (next - at).norm() / unit;
    tangent = (next - at).normalized(), at = next;
    curve.points.push_back(at), curve.length.push_back(way);
    if (falls && curve.fold == 0) curve.fold = top_of_parabola(curve);
    if (falls && at[last] < beyond * curve.fold) break;
  }
  if (curve.fold == 0) throw std::runtime_error("the curve of solutions does not fold back");
  return curve;
}

}  // namespace lattice
