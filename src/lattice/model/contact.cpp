#include "lattice/model/contact.hpp"

namespace lattice {

Contact simplest(const Contact& contact) {
  const auto hertz = [](double d) {
    return d == 0 ? Contact{Hertz{}} : Contact{CompressedHertz{d}};
  };
  if (const auto* c = std::get_if<CompressedHertz>(&contact)) return hertz(c->d);
  if (const auto* c = std::get_if<PowerContact>(&contact); c && c->exponent == 1.5)
    return hertz(c->d);
  return contact;
}

}  // namespace lattice
