#pragma once
/**
# A chain chosen at run time

Measurements such as those of turning.hpp and parting.hpp are templates on the chain, because the inner loop
must know its type. For a reader's own model that would mean one copy of each measurement for every pair of
a well and a contact. `ChosenChain` stands for a chain of any model instead: it can be run and has an energy
density, each by a step into `with_chain` (model.hpp), and so it serves where a chain is asked for. The
observer is called through a pointer, once a sample; the steps in between are those of the chain itself, to
the bit. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <variant>
#include <vector>

#include "lattice/measure/parting.hpp"
#include "lattice/model/model.hpp"
#include "lattice/stepping/contact_rkn.hpp"

namespace lattice {

struct ChosenChain {
  std::size_t sites = 0;
  Model model{};
};

/**
A far end that the motion reaches sends it back, and what comes back is no property of the impact. How long
must a chain be? Packets in wells move by less than a site per unit of time, unless the impact is so strong
that the wells hardly matter. What then travels are the pulses of a chain without wells, and their speed
grows with the power 1/5 of the impact velocity. If the contacts are compressed sound comes first, with at
most the root of their stiffness at rest. */
/// A chain that an impact of `velocity` does not cross within `time`.
inline ChosenChain endless(const Model& model, double velocity, double time) {
  const auto stiffness = [](const auto& contact) { return contact.stiffness(0.0); };
  const double sound = std::sqrt(std::visit(stiffness, simplest(model.contact)));
  return {std::size_t(time * std::max({1.0, std::pow(velocity, 0.2), sound})) + 100, model};
}

/**
Both steps into the chain itself are compiled for all pairs of a well and a contact, and once for every
stepper, whatever is measured. */
/// Energy density of a chosen chain (chain.hpp).
template <class T>
std::vector<T> energy_density(const ChosenChain& chosen, const State<T>& state) {
  return with_chain(chosen.model, chosen.sites,
                    [&](const auto& chain) { return energy_density(chain, state); });
}

/**
Two runs side by side are a step into the chain as well. */
/// When two runs of a chosen chain part (parting.hpp); `watch(t)` is called after each look.
template <class Stepper>
double parting_time(const Stepper& first, const State<double>& a, const Stepper& second,
                    const State<double>& b, const ChosenChain& chosen, double time,
                    const std::function<void(double)>& watch) {
  return with_chain(chosen.model, chosen.sites, [&](const auto& chain) {
    return parting_time(first, a, second, b, chain, time, watch);
  });
}

/**
An observer is called through a pointer. */
using Look = std::function<bool(const State<double>&)>;

template <class Stepper>
Run evolve_chosen(const Stepper& stepper, const ChosenChain& chosen, State<double>& state,
                  const Pace& pace, const Look& look) {
  return with_chain(chosen.model, chosen.sites,
                    [&](const auto& chain) { return evolve(stepper, chain, state, pace, look); });
}

/// `evolve` of integrate.hpp for a chosen chain, in both forms.
template <class Stepper, class Observer>
Run evolve(const Stepper& stepper, const ChosenChain& chosen, State<double>& state,
           const Pace& pace, Observer observe) {
  return evolve_chosen(stepper, chosen, state, pace,
                       [&](const State<double>& now) { return goes_on(observe, now); });
}
template <class Stepper, class Observer>
Run evolve(const Stepper& stepper, const ChosenChain& chosen, State<double>& state, double duration,
           double sample, Observer observe) {
  return evolve(stepper, chosen, state, pace_for(stepper, duration, sample), std::move(observe));
}

/**
Where only the well is chosen at run time (`NamedWell`), a long run had better not ask for it at every bead:
it becomes a run of the chosen chain. */
template <class Contact, class Observer>
Run evolve(const ContactAware& stepper, const Chain<NamedWell, Contact>& chain,
           State<double>& state, const Pace& pace, Observer observe) {
  const ChosenChain chosen{chain.sites, {chain.onsite.well, chain.contact, chain.ends}};
  return evolve(stepper, chosen, state, pace, std::move(observe));
}

}  // namespace lattice
