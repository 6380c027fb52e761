#pragma once
/**
# Looking at a run

A run shows what it has at every sample to any function. One that returns false ends the run; one that returns nothing
never does. */

#include <functional>
#include <type_traits>
#include <utility>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// Any function of what is `Seen`; without one nobody looks.
template <class... Seen>
class Observer {
 public:
  Observer() = default;
  /// `f` returns whether the run goes on, or nothing.
  template <class F>
  requires(std::is_invocable_v<F&, const Seen&...> && !std::is_same_v<std::decay_t<F>, Observer>)
      Observer(F f)
      : see_([f = std::move(f)](const Seen&... seen) mutable {
          if constexpr (std::is_same_v<decltype(f(seen...)), bool>) return f(seen...);
          f(seen...);
          return true;
        }) {}

  /// Shows it; whether the run goes on.
  bool operator()(const Seen&... seen) const { return !see_ || see_(seen...); }

 private:
  std::function<bool(const Seen&...)> see_{};
};

}  // namespace lattice
