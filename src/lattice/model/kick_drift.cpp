// The loops of the splitting methods, for every pair of potentials.

#include "lattice/model/typed.hpp"

namespace lattice {

template <class T>
detail::KickDrift<T> detail::kick_drifter(const Chain& chain) {
  return with_pair<T>(chain, []<class W, class C>(const W&, const C&) -> KickDrift<T> {
    return [](const Chain& c, State<T>& state, Window& window, const T& kick, const T& drift) {
      kick_drift(c, known<W>(c.well), known<C>(c.contact), state, window, kick, drift);
    };
  });
}

template <class T>
void kick_drift(const Chain& chain, State<T>& state, Window& window, std::type_identity_t<T> kick,
                std::type_identity_t<T> drift) {
  detail::kick_drifter<T>(chain)(chain, state, window, kick, drift);
}

#define LATTICE_INSTANCES(T)                                           \
  template detail::KickDrift<T> detail::kick_drifter<T>(const Chain&); \
  template void kick_drift<T>(const Chain&, State<T>&, Window&, T, T);
#include "lattice/model/instances.hpp"

}  // namespace lattice
