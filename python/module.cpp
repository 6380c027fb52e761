/**
# The Python module: how

Each function of the module runs the command of the same meaning (src/commands): it reads its options as a
program reads its line, computes, and returns the same tables. So bits, ranges and complaints are those of the
programs, and nothing is decided here. What is added is what Python needs: arrays, exceptions, potentials that
are written in Python, and a way to stop. The package around it (package.py) has the names and the
documentation. */

#include "binding.hpp"

#include <pybind11/complex.h>

#include <functional>
#include <memory>

#include "any_orbit.hpp"
#include "commands/dps_strike.hpp"
#include "commands/multipliers.hpp"
#include "commands/one_barrier.hpp"
#include "commands/one_breather.hpp"
#include "commands/one_impact.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/model_options.hpp"

namespace {

/**
## Potentials that are written in Python

A well or a contact of one's own is three functions of an array. A row of numbers is one call, in which the
interpreter's lock is held; without rows a chain of a hundred beads would make a hundred calls. The functions
belong to Python, so the last owner takes the lock to let go of them. */
struct Functions {
  py::function energy, force, stiffness;
};

class PythonRows {
 public:
  explicit PythonRows(const Functions& functions)
      : functions_(new Functions(functions), [](const Functions* last) {
          const py::gil_scoped_acquire with_lock;
          delete last;
        }) {}

  const Functions& functions() const { return *functions_; }

  template <class T>
  void row(PotentialFunction which, const T* x, T* out, std::size_t n) const {
    const bool energy = which == PotentialFunction::energy,
               force = which == PotentialFunction::force;
    const char* name = energy ? "energy" : force ? "force" : "stiffness";
    const py::function& function = energy  ? functions_->energy
                                   : force ? functions_->force
                                           : functions_->stiffness;
    const py::gil_scoped_acquire with_lock;
    const auto returned = py::array::ensure(function(py::array_t<T>(py::ssize_t(n), x)));
    if (!returned || std::string("fiu").find(returned.dtype().kind()) == std::string::npos)
      throw std::invalid_argument(std::string(name) + " does not return real numbers");
    const py::array_t<T, py::array::c_style | py::array::forcecast> answer(returned);
    // One number stands for as many as are asked for
    if (returned.size() == 1) return void(std::fill_n(out, n, *answer.data()));
    if (std::size_t(returned.size()) != n)
      throw std::invalid_argument(std::string(name) + " returns " +
                                  std::to_string(returned.size()) + " numbers for " +
                                  std::to_string(n) + " (allowed: the same number, or one)");
    std::copy_n(answer.data(), n, out);
  }

 private:
  std::shared_ptr<const Functions> functions_;
};

struct RowWell : PythonRows {
  double edge;
  RowWell(const Functions& functions, double rim) : PythonRows(functions), edge(rim) {}
  double rim() const { return edge; }
};

struct RowContact : PythonRows {
  double open, exponent;
  RowContact(const Functions& functions, double opening, double power)
      : PythonRows(functions), open(opening), exponent(power) {}
  double opening() const { return open; }
};

/**
A chain is described by the options that all programs share, and beyond them by potentials of one's own. */
struct OwnChain {
  static constexpr Title title{"chain", "a chain"};
  Chain chain{};

  void parameters(Parameters& p) {
    p.add("sites", chain.sites, "number of beads (default: as many as needed)", {2, 1e6});
    add_well(p, chain.well);
    add_contact(p, chain.contact);
    add_ends(p, chain.ends);
  }
};

Chain make_chain(const Words& words, const OwnWell* well, const OwnContact* contact) {
  Chain chain = read<OwnChain>(words).chain;
  if (well) chain.well = *well;
  if (contact) chain.contact = *contact;
  return chain;
}

/// The potential of one's own that a chain has, None if it has a name.
template <class Own, class Any>
py::object own_in(const Any& any) {
  const Own* own = any.template get_if<Own>();
  return own ? py::cast(*own) : py::none();
}

/**
## Tables */
py::dict to_python(const Path& path) {
  py::dict out;
  out["t"] = array_of(path.all(&PathSample::t));
  out["centre"] = array_of(path.all(&PathSample::centre));
  out["energy"] = array_of(path.all(&PathSample::energy));
  out["peak"] = array_of(path.all(&PathSample::peak));
  return out;
}

/**
## The commands */
py::tuple strike_chain(const Words& words, const Chain* chain) {
  auto command = read<OneImpact>(words);
  if (chain) command.impact.chain = *chain;
  if (chain && chain->sites) command.sites = chain->sites;
  const auto found = at_work([&] { return command.find(); });
  return answer(command, found) +
         py::make_tuple(to_python(found.runs.fine.path), found.impact.chain);
}

/// The breather of a command on the reader's chain or in the reader's well.
template <class Command>
Command chosen(const Words& words, const OwnWell* well, const Chain* chain) {
  auto command = read<Command>(words);
  if (well) command.well = *well;
  if (!chain) return command;
  command.like = *chain;
  command.well = chain->well;
  if (chain->sites) command.sites = chain->sites;
  return command;
}

py::tuple one_breather(const Words& words, const OwnWell* well, const Chain* chain) {
  const auto command = chosen<OneBreather>(words, well, chain);
  const auto found = at_work([&] { return command.find(); });
  return answer(command, found) + py::make_tuple(found.problem.chain);
}

py::tuple all_multipliers(const Words& words, const OwnWell* well, const Chain* chain) {
  const auto command = chosen<Multipliers>(words, well, chain);
  return answer(command, at_work([&] { return command.find(); }));
}

py::tuple one_barrier(const Words& words, const OwnWell* well, const Chain* chain) {
  const auto command = chosen<OneBarrier>(words, well, chain);
  return py::make_tuple(to_python(at_work([&] { return command.table(); })));
}

py::tuple dps_strike(const Words& words) {
  const auto command = read<DpsStrike>(words);
  const auto found = at_work([&] { return command.find(); });
  return answer(command, found) + py::make_tuple(to_python(found[1].path));
}

/**
## A chain in motion

Any motion of a chain can be followed, with the error of its end. */
py::tuple evolve_chain(const Chain& chain, const Numbers& y, const Numbers& v, double time,
                       double sample, double tolerance) {
  Samples samples(chain, time, sample);
  State<double> state = state_of(chain, y.data(), v.data());
  const Run run = at_work([&] {
    return evolve(Converged{tolerance}, chain, state, time, Every{sample},
                  [&](const State<double>& now) { samples.take(now); });
  });
  samples.demand_all();
  return py::make_tuple(samples.t, samples.y, samples.v, run.error, run.energy_drift);
}

/**
A chain of one's own has periodic orbits of its own. */
State<double> at_rest(const Chain& chain, const Numbers& y) {
  return state_of(chain, y.data(), std::vector<double>(chain.sites).data());
}

py::tuple orbit_of(const Chain& chain, const Numbers& y, double period) {
  const auto [table, positions] = at_work([&] {
    const RestingOrbit found = orbit_from_rest(chain, at_rest(chain, y), period);
    return std::pair{found.quantities(), found.y};
  });
  std::vector<double> places, errors;
  for (const Estimate& one : positions) places.push_back(one.value), errors.push_back(one.error);
  return py::make_tuple(to_python(table), array_of(places), array_of(errors));
}

py::tuple multipliers_of_orbit(const Chain& chain, const Numbers& y, double period) {
  const auto found =
      at_work([&] { return multipliers_from_rest(chain, at_rest(chain, y), period); });
  const Estimate largest = found.largest_modulus();
  return py::make_tuple(largest.value, largest.error, multipliers_of(found));
}

// A chain answers with a copy of its masses: who writes into that has changed nothing, and shall know.
py::array_t<double> read_only(const std::vector<double>& x) {
  auto array = array_of(x);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// Masses or stiffnesses, none where all are one.
auto varied(const Chain& chain, std::vector<double> Variation::*row) {
  return read_only(chain.variation ? (*chain.variation).*row : std::vector<double>{});
}

/// What `compute(state)` says, one number a site, of every row of `y` and `v`.
template <class Compute>
Numbers by_rows(const Chain& chain, const Numbers& y, const Numbers& v, Compute compute) {
  Numbers out(std::vector<py::ssize_t>(y.shape(), y.shape() + y.ndim()));
  const double *y_at = y.data(), *v_at = v.data(), *const end = y_at + y.size();
  double* to = out.mutable_data();
  at_work([&] {
    for (; y_at < end; y_at += chain.sites, v_at += chain.sites) {
      heed_stop();
      const std::vector<double> row = compute(state_of(chain, y_at, v_at));
      to = std::copy(row.begin(), row.end(), to);
    }
    return to;
  });
  return out;
}

Numbers density_of(const Chain& chain, const Numbers& y, const Numbers& v) {
  return by_rows(chain, y, v,
                 [&](const State<double>& state) { return energy_density(chain, state); });
}

Numbers accelerations_of(const Chain& chain, const Numbers& y) {
  return by_rows(chain, y, y,
                 [&](const State<double>& state) { return accelerations(chain, state.y); });
}

/// The three functions of a potential, as they were given.
template <class Row, class Own>
py::tuple functions_of(const Own& own) {
  const Functions& all = own.template as<Row>().functions();
  return py::make_tuple(all.energy, all.force, all.stiffness);
}

/// The names of all parameters in a list of potentials.
template <class Any>
py::list parameter_names() {
  py::list out;
  for (const ParameterInfo& p : parameters_of<Any>()) out.append(p.name);
  return out;
}

// What can be made: potentials, which are checked then, and chains
void add_model(py::module_& m) {
  using py::function;
  const auto functions = [](function e, function f, function s) {
    return Functions{std::move(e), std::move(f), std::move(s)};
  };
  py::class_<OwnWell>(m, "Well")
      .def(py::init([=](function e, function f, function s, double rim) {
        return OwnWell(RowWell(functions(std::move(e), std::move(f), std::move(s)), rim));
      }))
      .def_property_readonly("functions", functions_of<RowWell, OwnWell>)
      .def_property_readonly("_loses_digits",
                             [](const OwnWell& well) { return loses_digits(well); })
      .def_property_readonly("rim", &OwnWell::rim);
  py::class_<OwnContact>(m, "Contact")
      .def(py::init([=](function e, function f, function s, double opening, double exponent) {
        return OwnContact(
            RowContact(functions(std::move(e), std::move(f), std::move(s)), opening, exponent));
      }))
      .def_property_readonly("functions", functions_of<RowContact, OwnContact>)
      .def_property_readonly("_loses_digits",
                             [](const OwnContact& contact) { return loses_digits(contact); })
      .def_property_readonly("opening", &OwnContact::opening)
      .def_readonly("exponent", &OwnContact::exponent);
  py::class_<Chain>(m, "Chain")
      .def(py::init(&make_chain))
      .def(py::init<const Chain&>())
      .def_readonly("sites", &Chain::sites)
      .def_property_readonly("well", [](const Chain& c) { return describe<Well>(c.well); })
      .def_property_readonly("contact", [](const Chain& c) { return describe<Contact>(c.contact); })
      .def_property_readonly("ends", [](const Chain& c) { return ends_names[int(c.ends)]; })
      .def_property_readonly("mass", [](const Chain& c) { return varied(c, &Variation::mass); })
      .def_property_readonly("eta", [](const Chain& c) { return varied(c, &Variation::eta); })
      .def_property_readonly("_well", [](const Chain& c) { return own_in<OwnWell>(c.well); })
      .def_property_readonly("_contact",
                             [](const Chain& c) { return own_in<OwnContact>(c.contact); })
      .def("_vary", &vary)
      .def("evolve", &evolve_chain)
      .def("orbit", &orbit_of)
      .def("multipliers", &multipliers_of_orbit)
      .def("energy_density", &density_of)
      .def("accelerations", &accelerations_of);
}

}  // namespace

PYBIND11_MODULE(_lattice, m) {
  translate_complaints();
  add_model(m);
  m.attr("version") = LATTICE_VERSION;
  m.attr("options") = py::dict(
      py::arg("Chain") = options<OwnChain>(), py::arg("strike") = options<OneImpact>(),
      py::arg("breather") = options<OneBreather>(), py::arg("multipliers") = options<Multipliers>(),
      py::arg("barrier") = options<OneBarrier>(), py::arg("dps") = options<DpsStrike>());
  m.attr("digits_hint") = digits_hint;
  m.attr("parameters") = py::dict(py::arg("well") = parameter_names<Well>(),
                                  py::arg("contact") = parameter_names<Contact>());
  m.def("set_threads", &set_threads);
  m.def("strike", &strike_chain);
  m.def("breather", &one_breather);
  m.def("multipliers", &all_multipliers);
  m.def("barrier", &one_barrier);
  m.def("dps", &dps_strike);
}
