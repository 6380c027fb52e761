/**
# The second Python module

It has what is beyond the article: `lattice.travelling`, whose names and documentation are in travelling.py. */

#include "binding.hpp"

#include "commands/one_orbit.hpp"
#include "lattice/numerics/parallel.hpp"

namespace {

py::tuple one_orbit(const Words& words) {
  const auto command = read<OneOrbit>(words);
  const auto found = at_work([&] { return command.find(); });
  return answer(command, found) + py::make_tuple(found.problem.chain);
}

}  // namespace

PYBIND11_MODULE(_beyond, m) {
  translate_complaints();
  m.attr("options") = options<OneOrbit>();
  m.def("set_threads", &set_threads);
  m.def("travelling", &one_orbit);
}
