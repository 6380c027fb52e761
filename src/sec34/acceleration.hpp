#pragma once
/**
# The mean acceleration of a packet

The path of a particle on which a constant force acts is a parabola. We fit one to a part of a smoothed path: its second
derivative is the mean acceleration, and its distance from the path shows how constant the force is. */

#include <cmath>
#include <vector>

#include "lattice/algebra/dense.hpp"
#include "lattice/diagnostics/path.hpp"

namespace lattice {

/// A parabola through a path.
struct PathFit {
  double acceleration;  ///< site per squared unit of time
  double deviation;     ///< root mean square of the distance, over the range of the path
};

/// The parabola that fits a smoothed path best from time `from` to `to`.
inline PathFit fit_parabola(const Path& path, double from, double to) {
  std::vector<double> u, centre;
  const double half = (to - from) / 2;
  for (const PathSample& at : path) {
    if (at.t < from - 1e-9 || at.t > to + 1e-9) continue;
    u.push_back((at.t - from - half) / half);
    centre.push_back(at.centre);
  }
  const auto n = Eigen::Index(u.size());
  const Vector<double> x = Eigen::Map<Vector<double>>(centre.data(), n);
  Eigen::MatrixX3d powers(n, 3);
  for (Eigen::Index i = 0; i < n; ++i)
    powers.row(i) << 1, u[std::size_t(i)], u[std::size_t(i)] * u[std::size_t(i)];
  const Eigen::Vector3d fit = fit_columns(powers, x);
  const double off = (powers * fit - x).norm() / std::sqrt(double(n));
  return {2 * fit[2] / (half * half), off / (x.maxCoeff() - x.minCoeff())};
}

}  // namespace lattice
