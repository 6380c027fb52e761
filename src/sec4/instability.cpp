#include "sec4/instability.hpp"

#include <numbers>

namespace lattice {

// Phi is positive at q = 0 if beta is negative there, and changes its sign at each zero of omega_2 and of beta
template <class T>
std::vector<T> edges_of_instability(T d, T s) {
  using std::asin, std::sqrt;
  const T root = sqrt(d), b = T(2) * s * d * root - T(1) / (T(4) * root);
  const auto positive = [&](T x) { return x * x * (x * (T(1) - x) + b) + s * d > T(0); };
  // The polynomial is monotone between these places
  std::vector<T> places{T(0)};
  if (const T square = T(9) + T(32) * b; square > T(0)) {
    const T top = (T(3) + sqrt(square)) / T(8);
    for (T x : {-b / (T(2) * top), top})
      if (x > T(0) && x < T(2)) places.push_back(x);
  }
  places.push_back(T(2));
  std::vector<T> zeros{T(2) / (T(1) + sqrt(T(1) + T(6) * root))};  // that of omega_2
  for (std::size_t k = 1; k < places.size(); ++k) {
    T low = places[k - 1], high = places[k], middle;
    const bool before = positive(low);
    if (positive(high) == before) continue;
    while ((middle = low + (high - low) / T(2)) > low && middle < high)
      (positive(middle) == before ? low : high) = middle;
    zeros.push_back(middle);
  }
  std::sort(zeros.begin(), zeros.end());
  std::vector<T> edges;
  if (!positive(T(0))) edges.push_back(T(0));
  for (T x : zeros) edges.push_back(T(2) * asin(sqrt(x / T(2))));
  if (edges.size() % 2 == 1) edges.push_back(std::numbers::pi_v<T>);
  return edges;
}

// The scalars that are used
template std::vector<double> edges_of_instability(double, double);
template std::vector<long double> edges_of_instability(long double, long double);

}  // namespace lattice
