#pragma once
/**
# Potentials

A chain (chain.hpp) needs two kinds of potential energy: the well $W(y)$ that holds each bead (well.hpp)
and the contact $V(r)$ that couples neighbours (contact.hpp), with $r = y_{n+1} - y_n$. Both are small
value types with the same three members:

| member | meaning | well | contact |
|---|---|---|---|
| `energy(x)` | potential energy | $W(y)$ | $V(r)$ |
| `force(x)` | minus its derivative | $-W'(y)$ | $-V'(r) \ge 0$ where beads repel |
| `stiffness(x)` | second derivative | $W''(y)$ | $V''(r)$ |

Every member is a template on the scalar, so the same text serves `double`, `long double` and 128-bit
arithmetic. All quantities are dimensionless: the unit of time makes the frequency of small oscillations
in a well one, the unit of length does the same for the coefficient of the contact force. At rest
`force(0)` and `energy(0)` are exactly zero. */

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// A parameter by which a reader picks a potential (potential_names.hpp). Its default is the value in a freshly made one.
template <class Potential>
struct Parameter {
  const char* name;          ///< as an option has it, without dashes
  const char* meaning;       ///< for help, a few words
  double least, most;        ///< the allowed range, ends included
  double Potential::*value;  ///< where it is stored
};

/// Which of the three functions.
enum class PotentialFunction { energy, force, stiffness };

/// A potential that is evaluated elsewhere, as by the interpreter of another language, and prefers rows of numbers.
template <class P>
concept TakesRows = requires(const P& p, const double* x, double* out, std::size_t n) {
  p.row(PotentialFunction::force, x, out, n);
};

/// A struct with the three functions, of numbers or of rows.
template <class P>
concept IsPotential = TakesRows<P> || requires(const P& p, double x) {
  p.energy(x);
  p.force(x);
  p.stiffness(x);
};

/// Writes the function `which` at a row of `n` numbers; `out` may be `x`.
template <class P, class T>
void row_of(const P& potential, PotentialFunction which, const T* x, T* out, std::size_t n) {
  if constexpr (TakesRows<P>) {
    potential.row(which, x, out, n);
  } else {
    const auto fill = [&](auto function) {
      for (std::size_t i = 0; i < n; ++i) out[i] = function(x[i]);
    };
    if (which == PotentialFunction::energy) fill([&](const T& at) { return potential.energy(at); });
    if (which == PotentialFunction::force) fill([&](const T& at) { return potential.force(at); });
    if (which == PotentialFunction::stiffness)
      fill([&](const T& at) { return potential.stiffness(at); });
  }
}
/// Forces at a row of `n` numbers, and stiffnesses.
template <class P, class T>
void forces_of(const P& potential, const T* x, T* out, std::size_t n) {
  row_of(potential, PotentialFunction::force, x, out, n);
}
template <class P, class T>
void stiffnesses_of(const P& potential, const T* x, T* out, std::size_t n) {
  row_of(potential, PotentialFunction::stiffness, x, out, n);
}

/**
Not every potential is in a list. Any struct with the three functions can stand in a chain: it is kept behind virtual
functions, each of which treats a row of numbers at once, so that a potential of one's own costs little more
than the others. It has no name for the command line. */
/// Holds any potential; copies share it. In other types than double and long double its functions throw std::logic_error.
class OwnPotential {
 public:
  static constexpr const char* name = "own";

  OwnPotential() = default;
  template <class P>
  explicit OwnPotential(P potential) : kept_(std::make_shared<const Of<P>>(std::move(potential))) {}

  template <class T>
  void row(PotentialFunction which, const T* x, T* out, std::size_t n) const {
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, long double>)
      return kept_->row(which, x, out, n);
    throw std::logic_error(
        "a user-defined potential is available in double and extended precision only");
  }
  template <class T>
  T energy(T x) const {
    return row(PotentialFunction::energy, &x, &x, 1), x;
  }
  template <class T>
  T force(T x) const {
    return row(PotentialFunction::force, &x, &x, 1), x;
  }
  template <class T>
  T stiffness(T x) const {
    return row(PotentialFunction::stiffness, &x, &x, 1), x;
  }

  /// The struct itself. Throws std::bad_variant_access if it is another one.
  template <class P>
  const P& as() const {
    if (!kept_ || kept_->type() != &Of<P>::tag) throw std::bad_variant_access();
    return static_cast<const Of<P>&>(*kept_).potential;
  }

  // Virtual functions have no templates, so the two precisions are listed one by one
 private:
  struct Functions {
    virtual ~Functions() = default;
    virtual const void* type() const = 0;
    virtual void row(PotentialFunction, const double*, double*, std::size_t) const = 0;
    virtual void row(PotentialFunction, const long double*, long double*, std::size_t) const = 0;
  };
  template <class P>
  struct Of final : Functions {
    P potential;
    static constexpr char tag = 0;
    explicit Of(P p) : potential(std::move(p)) {}
    const void* type() const override { return &tag; }
    void row(PotentialFunction which, const double* x, double* out, std::size_t n) const override {
      row_of(potential, which, x, out, n);
    }
    void row(PotentialFunction which, const long double* x, long double* out,
             std::size_t n) const override {
      row_of(potential, which, x, out, n);
    }
  };

  std::shared_ptr<const Functions> kept_{};
};

/**
Nobody else has checked a potential of one's own, and where its three functions do not belong together no run
fails: a wrong stiffness makes wrong multipliers, a wrong energy a drift. So each is asked once, when it is made. */
/// Throws std::invalid_argument, in one line, unless force and stiffness of `well` are minus the slopes of energy
/// and force on both sides, energy and force vanish at rest, and `rim` > 0.
void require_well(const OwnPotential& well, double rim);

/// The same for a contact on either side of its `opening`, which must be finite as must the `exponent` >= 1.
/// Beads that are pressed together repel each other.
void require_contact(const OwnPotential& contact, double opening, double exponent);

/// Whether small displacements have forces of few digits, as in $1 - e^{-y}$ when written like this.
bool loses_digits(const OwnPotential& potential);

/// What `Well` and `Contact` have in common: a potential of the list `Known` or one of the caller's own, made from its
/// struct. The functions choose anew in every call; the loops along a chain choose once (kernel.hpp).
template <class Own, class... Known>
struct OneOf {
  using List = std::variant<Known..., Own>;
  List kind{};  ///< the potential by its own type

  OneOf() = default;
  template <class P>
  requires(!std::is_base_of_v<OneOf, P> && IsPotential<P>) OneOf(P potential)
      : kind(kept(std::move(potential))) {}

  /// Whether it is a `P`, one of the list.
  template <class P>
  bool is() const {
    return std::holds_alternative<P>(kind);
  }
  /// The `P` that it is, or a null pointer.
  template <class P>
  const P* get_if() const {
    return std::get_if<P>(&kind);
  }

  template <class T>
  T energy(T x) const {
    return std::visit([&](const auto& p) -> T { return p.energy(x); }, kind);
  }
  template <class T>
  T force(T x) const {
    return std::visit([&](const auto& p) -> T { return p.force(x); }, kind);
  }
  template <class T>
  T stiffness(T x) const {
    return std::visit([&](const auto& p) -> T { return p.stiffness(x); }, kind);
  }

 private:
  template <class P>
  static auto kept(P potential) {
    if constexpr (std::is_constructible_v<List, P>)
      return potential;
    else
      return Own(std::move(potential));
  }
};

}  // namespace lattice
