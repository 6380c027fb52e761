#pragma once
/**
# A model chosen at run time

Which well and which contact a reader wants is known only when the program runs, but the inner loop
(kernel.hpp) is fast because it knows them when it is compiled. A `Model` holds the choice as a value,
and `with_chain` turns it, once, into a chain of the right type. */

#include <concepts>
#include <cstddef>
#include <utility>
#include <variant>

#include "lattice/model/chain.hpp"

namespace lattice {

/// A well, a contact and what lies beyond the ends; by default Eq. (9), harmonic wells (s = 0) and
/// plain Hertzian contacts with free ends.
struct Model {
  AnyOnsite onsite = Quartic{};
  AnyContact contact = Hertz{};
  Ends ends = Ends::free;

  Model() = default;
  Model(AnyOnsite well, AnyContact touch = Hertz{}, Ends beyond = Ends::free)
      : onsite(well), contact(touch), ends(beyond) {}
  /// A well of any kind stands for the chain of such wells with Hertzian contacts.
  template <class Well>
  requires(!std::convertible_to<Well, double> && std::constructible_from<AnyOnsite, Well> &&
           !std::same_as<Well, AnyOnsite> && !std::same_as<Well, Model>) Model(Well well)
      : onsite(well) {}
  /// So does a number: the article's family of wells, Eq. (10), is named by its s.
  Model(double s) : onsite(Quartic{s}) {}
};

/**
Here the choice becomes a type: `use(chain)` is compiled for every pair of a well and a contact, and the
version that fits `model` is called with a chain of `sites` beads. Returns what `use` returns, which must
have the same type for all chains. */
template <class Use>
auto with_chain(const Model& model, std::size_t sites, Use use) {
  const auto build = [&](const auto& onsite, const auto& contact) {
    using Onsite = std::decay_t<decltype(onsite)>;
    using Contact = std::decay_t<decltype(contact)>;
    return use(Chain<Onsite, Contact>{sites, onsite, contact, model.ends});
  };
  return std::visit(build, model.onsite, simplest(model.contact));
}

}  // namespace lattice
