#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "lattice/model/contact.hpp"
#include "lattice/numbers/dense.hpp"
#include "sec5/half_line.hpp"

namespace lattice {

struct Resolution {
  std::size_t nodes = 12;
  double longest = 0.5;
};
struct KernelWave {
  PowerContact law;
  HalfLine line;
  Vector<double> d;
  std::vector<double> zeros;

  Vector<double> force() const;
  double action() const;
  double energy() const;
  double quotient() const;
  double peak() const { return d.maxCoeff(); }
  std::size_t contacts() const;
  double residual() const;
  double component() const;
  double central_velocity() const;
};

Vector<double> gmres_even(const HalfLine& line, const Vector<double>& stiffness, const Vector<double>& r);
KernelWave refine_wave(const KernelWave& guess, double shift_time, const PowerContact& law, const Resolution& res);
KernelWave seed_wave(double shift_time, int start, const PowerContact& law);
}  // namespace lattice
