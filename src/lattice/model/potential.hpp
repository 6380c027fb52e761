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

/**
Each potential says what it is called and which parameters it has, by which a reader picks it
(potential_names.hpp). A parameter has a name, a meaning, an allowed range and a place where it is stored. Its
default is the value that it has in a freshly made potential. */
template <class Potential>
struct Parameter {
  const char* name;          ///< as an option has it, without dashes
  const char* meaning;       ///< for help, a few words
  double least, most;        ///< the allowed range, ends included
  double Potential::*value;  ///< where it is stored
};

/**
Not every potential is in a list. Any struct with the three functions can stand in a chain: it is kept behind
the six functions below, three in double and three in extended precision, each of which treats a row of
numbers at once. So a potential of one's own costs little more than the others. It has no name for the
command line. One that is evaluated elsewhere, as by the interpreter of another language, may prefer rows to
single numbers; it then has the three functions of rows instead. */
template <class P>
concept TakesRows = requires(const P& p, const double* x, double* out, std::size_t n) {
  p.energies(x, out, n);
  p.forces(x, out, n);
  p.stiffnesses(x, out, n);
};

/// Holds any potential that takes rows; copies share it.
class OwnPotential {
 public:
  OwnPotential() = default;
  template <class P>
  explicit OwnPotential(P potential) : kept_(std::make_shared<const Of<P>>(std::move(potential))) {}

  static constexpr const char* name = "own";

  /// The same three functions as those of other potentials, for one number. They throw std::logic_error in other
  /// types than double and long double.
  template <class T>
  T energy(T x) const {
    return energies(&x, &x, 1), x;
  }
  template <class T>
  T force(T x) const {
    return forces(&x, &x, 1), x;
  }
  template <class T>
  T stiffness(T x) const {
    return stiffnesses(&x, &x, 1), x;
  }

  /// The same three for a row of `n` numbers; `out` may be `x`.
  template <class T>
  void energies(const T* x, T* out, std::size_t n) const {
    if constexpr (known<T>) return kept_->energies(x, out, n);
    throw std::logic_error(narrow);
  }
  template <class T>
  void forces(const T* x, T* out, std::size_t n) const {
    if constexpr (known<T>) return kept_->forces(x, out, n);
    throw std::logic_error(narrow);
  }
  template <class T>
  void stiffnesses(const T* x, T* out, std::size_t n) const {
    if constexpr (known<T>) return kept_->stiffnesses(x, out, n);
    throw std::logic_error(narrow);
  }

  /// The struct itself. Throws std::bad_variant_access if it is another one.
  template <class P>
  const P& as() const {
    if (!kept_ || kept_->type() != &Of<P>::tag) throw std::bad_variant_access();
    return static_cast<const Of<P>&>(*kept_).potential;
  }

  // Virtual functions have no templates, so the two precisions are listed one by one
 private:
  template <class T>
  static constexpr bool known = std::is_same_v<T, double> || std::is_same_v<T, long double>;
  static constexpr const char* narrow =
      "a potential of one's own is known in double and extended precision only";

  struct Functions {
    virtual ~Functions() = default;
    virtual const void* type() const = 0;
    virtual void energies(const double*, double*, std::size_t) const = 0;
    virtual void forces(const double*, double*, std::size_t) const = 0;
    virtual void stiffnesses(const double*, double*, std::size_t) const = 0;
    virtual void energies(const long double*, long double*, std::size_t) const = 0;
    virtual void forces(const long double*, long double*, std::size_t) const = 0;
    virtual void stiffnesses(const long double*, long double*, std::size_t) const = 0;
  };

  // One virtual call for a whole row: the loop inside it knows the struct and can be inlined
  template <class P>
  struct Of final : Functions {
    P potential;
    static constexpr char tag = 0;
    explicit Of(P p) : potential(std::move(p)) {}
    template <class T>
    void energy_row(const T* x, T* out, std::size_t n) const {
      if constexpr (TakesRows<P>)
        potential.energies(x, out, n);
      else
        for (std::size_t i = 0; i < n; ++i) out[i] = potential.energy(x[i]);
    }
    template <class T>
    void force_row(const T* x, T* out, std::size_t n) const {
      if constexpr (TakesRows<P>)
        potential.forces(x, out, n);
      else
        for (std::size_t i = 0; i < n; ++i) out[i] = potential.force(x[i]);
    }
    template <class T>
    void stiffness_row(const T* x, T* out, std::size_t n) const {
      if constexpr (TakesRows<P>)
        potential.stiffnesses(x, out, n);
      else
        for (std::size_t i = 0; i < n; ++i) out[i] = potential.stiffness(x[i]);
    }

    // The same without templates
    const void* type() const override { return &tag; }
    void energies(const double* x, double* out, std::size_t n) const override {
      energy_row(x, out, n);
    }
    void forces(const double* x, double* out, std::size_t n) const override {
      force_row(x, out, n);
    }
    void stiffnesses(const double* x, double* out, std::size_t n) const override {
      stiffness_row(x, out, n);
    }
    void energies(const long double* x, long double* out, std::size_t n) const override {
      energy_row(x, out, n);
    }
    void forces(const long double* x, long double* out, std::size_t n) const override {
      force_row(x, out, n);
    }
    void stiffnesses(const long double* x, long double* out, std::size_t n) const override {
      stiffness_row(x, out, n);
    }
  };

  std::shared_ptr<const Functions> kept_{};
};

/**
Nobody else has checked a potential of one's own, and where its three functions do not belong together no run
fails: a wrong stiffness makes wrong multipliers, a wrong energy a drift. So each is asked once, when it is made,
whether force and stiffness are the slopes that they claim to be (potential.cpp says how). */
/// Throws std::invalid_argument, in one line, unless force and stiffness of `well` are minus the slopes of energy
/// and force on both sides, energy and force vanish at rest, and `rim` > 0.
void require_well(const OwnPotential& well, double rim);

/// The same for a contact on either side of its `opening`, which must be finite as must the `exponent` >= 1.
/// Beads that are pressed together repel each other.
void require_contact(const OwnPotential& contact, double opening, double exponent);

/// Whether small displacements have forces of few digits, as in $1 - e^{-y}$ when written like this.
bool loses_digits(const OwnPotential& potential);

/// A struct with the three functions of a potential, of numbers or of rows.
template <class P>
concept IsPotential = TakesRows<P> || requires(const P& p, double x) {
  p.energy(x);
  p.force(x);
  p.stiffness(x);
};

/// Whether a list holds potentials of type `P`.
template <class P, class... Potential>
constexpr bool lists(const std::variant<Potential...>*) {
  return (std::is_same_v<P, Potential> || ...);
}

/**
A chain holds a potential of a list or one of the caller's own, and has the same type whichever it is: that is
what `Well` and `Contact` have in common. Either is made from one of its structs, and `as` gives the struct
back. The functions choose anew in every call; the loops along a chain choose once (chain.hpp). */
template <class Own, class... Known>
struct OneOf : std::variant<Known..., Own> {
  using List = std::variant<Known..., Own>;

  OneOf() = default;
  template <class P>
  requires(!std::is_base_of_v<List, P> && IsPotential<P>) OneOf(P potential)
      : List(kept(std::move(potential))) {}

  /// The potential as what it is. Throws std::bad_variant_access if it is another one.
  template <class P>
  const P& as() const {
    if constexpr (lists<P>(static_cast<const List*>(nullptr)))
      return std::get<P>(*this);
    else
      return std::get<Own>(*this).template as<P>();
  }

  /// The energy at `x`, in the potential's own units, as the two derivatives are.
  template <class T>
  T energy(T x) const {
    return std::visit([&](const auto& p) -> T { return p.energy(x); }, *this);
  }
  /// The force, with the sign that the structs of the list give it.
  template <class T>
  T force(T x) const {
    return std::visit([&](const auto& p) -> T { return p.force(x); }, *this);
  }
  /// The second derivative of the energy.
  template <class T>
  T stiffness(T x) const {
    return std::visit([&](const auto& p) -> T { return p.stiffness(x); }, *this);
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

/// Forces at a row of `n` numbers; `out` may be `x`.
template <class P, class T>
void forces_of(const P& potential, const T* x, T* out, std::size_t n) {
  if constexpr (std::is_base_of_v<OwnPotential, P>)
    potential.forces(x, out, n);
  else
    for (std::size_t i = 0; i < n; ++i) out[i] = potential.force(x[i]);
}
/// Stiffnesses at a row of `n` numbers.
template <class P, class T>
void stiffnesses_of(const P& potential, const T* x, T* out, std::size_t n) {
  if constexpr (std::is_base_of_v<OwnPotential, P>)
    potential.stiffnesses(x, out, n);
  else
    for (std::size_t i = 0; i < n; ++i) out[i] = potential.stiffness(x[i]);
}

}  // namespace lattice
