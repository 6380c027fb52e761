#pragma once
/**
# What both Python modules share

How a command is read, runs beside the interpreter, and answers. Each module includes this once. */

#include <gsl/gsl_errno.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <exception>
#include <future>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "lattice/integrators/refinement.hpp"
#include "lattice/numerics/progress.hpp"
#include "report/command_line.hpp"

namespace py = pybind11;
using namespace lattice;
using namespace report;

namespace {

using Words = std::vector<std::string>;

/**
## Long work

Signals reach the main thread only. There a computation runs in a thread of its own, without the lock, while the main
thread waits and asks from time to time whether the user has pressed Ctrl-C. If so, the computation is told to stop.
Any other thread computes itself. */
template <class Compute>
auto at_work(Compute compute) {
  std::atomic<bool> stop{false};
  std::packaged_task<decltype(compute())()> task([&] {
    const Interruptible with_flag(&stop);
    return compute();
  });
  auto found = task.get_future();
  {
    const py::gil_scoped_release for_others;
    std::thread worker;
    if (gettid() == getpid())
      worker = std::thread(std::ref(task));
    else
      task();
    while (found.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
      if (const py::gil_scoped_acquire with_lock; !stop && PyErr_CheckSignals() != 0) stop = true;
    if (worker.joinable()) worker.join();
  }
  if (PyErr_Occurred()) throw py::error_already_set();
  return found.get();
}

/**
## Options

A command reads words, as in a program. `options` tells what there is to be said, for signatures and
documentation. */
template <class Command>
struct Spoken {
  Command command{};
  std::deque<Offer> offers{};

  Spoken() {
    offers.emplace_back();
    Offer& offer = offers.emplace_back();
    offer.name = Command::title.name;
    command.parameters(offer.parameters);
  }
  Spoken(const Spoken&) = delete;
  Spoken& operator=(const Spoken&) = delete;
};

template <class Command>
Command read(Words words) {
  Spoken<Command> spoken;
  words.insert(words.begin(), Command::title.name);
  if (read_line(spoken.offers, words).what != Asked::What::run)
    throw UsageError("--help: is an option of the programs (allowed: Python's own help)");
  return spoken.command;
}

/// Name, whether it is a flag, what is allowed, meaning and default of every option.
template <class Command>
py::list options() {
  const Spoken<Command> spoken;
  py::list out;
  for (const Option& p : spoken.offers.back().parameters.all())
    out.append(py::make_tuple(p.name, p.is_flag(), p.check.allowed, p.meaning, p.standard));
  return out;
}

/**
## Tables

A column becomes an array of its own type. */
py::array_t<double> array_of(const std::vector<double>& x) {
  return py::array_t<double>(py::ssize_t(x.size()), x.data());
}

py::object column_of(const Table& table, std::size_t k) {
  if (table.columns[k].kind == Kind::real) return array_of(table.numbers(table.columns[k].name));
  py::list out;
  for (const auto& row : table.rows)
    std::visit([&](const auto& cell) { out.append(cell); }, row[k]);
  if (table.columns[k].kind == Kind::integer) return py::array(out);
  return out;
}

py::dict to_python(const Table& table) {
  py::dict out;
  for (std::size_t k = 0; k < table.columns.size(); ++k)
    out[py::str(table.columns[k].name)] = column_of(table, k);
  return out;
}

/// Both tables of a command, as dictionaries of columns.
template <class Command, class Found>
py::tuple answer(const Command& command, const Found& found) {
  const auto tables = at_work([&] {
    return std::pair{command.quantities(found), command.profile(found)};
  });
  return py::make_tuple(to_python(tables.first), to_python(tables.second));
}

/**
## Motion

The arrays for what is seen of a run are made before it, so that one which would not fit is refused before it begins. */
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

constexpr double most_gigabytes = 2;

State<double> state_of(const Chain& chain, const double* y, const double* v) {
  State<double> state(chain.sites);
  std::copy_n(y, chain.sites, state.y.begin());
  std::copy_n(v, chain.sites, state.v.begin());
  return state;
}

void refuse_too_many(const Chain& chain, double time, double sample) {
  const double gigabytes = (time / sample + 2) * 2 * double(chain.sites) * sizeof(double) / 1e9;
  if (gigabytes <= most_gigabytes) return;
  std::ostringstream text;
  text.precision(3);
  text << "sample: y and v would take " << gigabytes << " GB (allowed: " << most_gigabytes
       << "; take fewer samples, or several runs, each from the final state of the previous one)";
  throw UsageError(text.str());
}

/// Room for the samples of a run.
struct Samples {
  Numbers t, y, v;
  double *t_to, *y_to, *v_to;
  const double* end;

  Samples(const Chain& chain, double time, double sample) {
    refuse_too_many(chain, time, sample);
    const std::size_t rows = time_grid(time, sample, largest_step).samples + 1;
    const std::vector<std::size_t> shape{rows, chain.sites};
    t = Numbers(std::vector{rows}), y = Numbers(shape), v = Numbers(shape);
    t_to = t.mutable_data(), y_to = y.mutable_data(), v_to = v.mutable_data();
    end = t_to + rows;
  }
  Samples(const Samples&) = delete;
  Samples& operator=(const Samples&) = delete;

  void take(const State<double>& now) {
    if (t_to == end) throw std::logic_error("more samples than the run has room for");
    *t_to++ = now.t;
    y_to = std::copy(now.y.begin(), now.y.end(), y_to);
    v_to = std::copy(now.v.begin(), now.v.end(), v_to);
  }
  void demand_all() const {
    if (t_to != end) throw std::logic_error("a run ends before its time and does not say so");
  }
};

/**
## Complaints

Whatever is wrong is said in the one line that the programs print: a ValueError if the input cannot be used, a
RuntimeError if the computation did not deliver what it promised. */
void say(PyObject* kind, std::string line) {
  std::replace(line.begin(), line.end(), '\n', ' ');
  PyErr_SetString(kind, line.c_str());
}

void translate(std::exception_ptr error) {
  try {
    if (error) std::rethrow_exception(error);
  } catch (const py::error_already_set&) {
    throw;  // Python's own exceptions pass
  } catch (const py::builtin_exception&) {
    throw;
  } catch (const UsageError& e) {
    say(PyExc_ValueError, e.what());
  } catch (const std::invalid_argument& e) {
    say(PyExc_ValueError, e.what());
  } catch (const std::runtime_error& e) {
    say(PyExc_RuntimeError, e.what());
  }
}

void translate_complaints() {
  gsl_set_error_handler_off();  // its errors are ours to report, not a reason to abort
  py::register_exception_translator(&translate);
}

}  // namespace
