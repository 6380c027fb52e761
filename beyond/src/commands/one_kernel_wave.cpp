#include "commands/one_kernel_wave.hpp"

#include "sec5/two_signs.hpp"

namespace lattice {

void OneKernelWave::parameters(Parameters& p) {
  p.add("k", k, "oscillations per site; the shift time is 2 pi k", {1, 12});
  p.add("sign", sign, "sign of the central velocity",
        {{"plus", Sign::plus}, {"minus", Sign::minus}});
  p.add("alpha", alpha, "exponent of the contact force, 3/2 for spheres", {1.1, 8});
}

Table OneKernelWave::table() const {
  const TwoGridWave w = wave_on_two_grids(k, int(sign), alpha);
  const double residual = w.fine().residual();
  Answers q;
  q.add("energy", w(&KernelWave::energy), "",
        "energy of the whole chain that carries the wave, Eq. (6)");
  q.add("action", w(&KernelWave::action), "",
        "integral over all times of d_+^(alpha+1), with d the compression of a contact");
  q.add("peak", w(&KernelWave::peak), "", "largest compression of a contact");
  q.add(
      "contacts", compare(w.grids[0].contacts(), w.fine().contacts()), "",
      "number of time intervals in which a contact is compressed by more than 2.2e-16 of the peak");
  q.add("quotient", w(&KernelWave::quotient), "",
        "value Q of the variational quotient, action^(-(alpha-1)/(alpha+1))");
  q.add_small("residual", {residual, residual}, "relative to the peak",
              "residual of the kernel equation at the nodes of the finer grid");
  return q.table;
}

}  // namespace lattice
