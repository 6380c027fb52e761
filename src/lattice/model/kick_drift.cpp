// The loops of the splitting methods, for every pair of potentials.

#include "lattice/model/typed.hpp"

namespace lattice {

template <class T>
detail::KickDrift<T, PlainSum> detail::plain_kick_drifter(const Chain& chain) {
  return kick_drifter<T, PlainSum>(chain);
}

template <class T>
detail::BareKickDrift<T> detail::bare_kick_drifter(const Chain& chain) {
  return with_pair<T>(chain, []<class W, class C>(const W&, const C&) -> BareKickDrift<T> {
    return [](const Chain& c, T* y, T* v, const Varied& varied, std::size_t n, T left, T right,
              const T& kick, const T& drift) {
      with_variation(varied, [&](const auto& along) {
        kick_drift_sites(known<W>(c.well), known<C>(c.contact), y, v, PlainSum{}, along, n, left,
                         right, kick, drift);
      });
    };
  });
}

template <class T>
void kick_drift(const Chain& chain, State<T>& state, Window& window, std::type_identity_t<T> kick,
                std::type_identity_t<T> drift) {
  detail::plain_kick_drifter<T>(chain)(chain, state, window, kick, drift, {});
}

#define LATTICE_INSTANCES(T)                                                           \
  template detail::KickDrift<T, PlainSum> detail::plain_kick_drifter<T>(const Chain&); \
  template detail::BareKickDrift<T> detail::bare_kick_drifter<T>(const Chain&);        \
  template void kick_drift<T>(const Chain&, State<T>&, Window&, T, T);
#include "lattice/model/instances.hpp"

}  // namespace lattice
