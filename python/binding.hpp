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
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "lattice/numerics/interrupt.hpp"
#include "report/command_line.hpp"

namespace py = pybind11;
using namespace lattice;

namespace {

using Words = std::vector<std::string>;

/**
## The lock of the interpreter

An interpreter that exits ends every other thread that wants its lock, or runs its code, by unwinding its stack. Our
frames are not made for that: destructors would let go of objects without the lock, and the process would abort. Such a
thread waits instead until the process is gone, as it does from Python 3.14 on. */
/// What a function of the interpreter, or of numpy, which lets go of the lock to copy, returns, if it returns.
template <class Ask>
auto ask_interpreter(Ask ask) {
  try {
    return ask();
  } catch (...) {
    if (std::current_exception()) throw;  // an exception of C++, as that unwinding is not
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
  }
}

class WithLock {
 public:
  WithLock() = default;
  ~WithLock() { PyGILState_Release(state_); }
  WithLock(const WithLock&) = delete;
  WithLock& operator=(const WithLock&) = delete;

 private:
  PyGILState_STATE state_ = ask_interpreter(PyGILState_Ensure);
};

class WithoutLock {
 public:
  WithoutLock() = default;
  ~WithoutLock() {
    ask_interpreter([this] { PyEval_RestoreThread(state_); });
  }
  WithoutLock(const WithoutLock&) = delete;
  WithoutLock& operator=(const WithoutLock&) = delete;

 private:
  PyThreadState* state_ = PyEval_SaveThread();
};

/**
## Long work

Signals reach the main thread only. There a computation runs in a thread of its own, without the lock, while the main
thread waits and asks from time to time whether the user has pressed Ctrl-C. If so, the computation is told to stop.
Any other thread computes itself, and so does the main one where no thread can start. */
template <class Compute>
auto at_work(Compute compute) {
  std::atomic<bool> stop{false};
  std::packaged_task<decltype(compute())()> task([&] {
    const Interruptible with_flag(&stop);
    return compute();
  });
  auto found = task.get_future();
  {
    const WithoutLock for_others;
    std::thread worker;
    try {
      if (gettid() == getpid()) worker = std::thread(std::ref(task));
    } catch (const std::system_error&) {
    }
    if (!worker.joinable()) task();
    while (found.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
      if (const WithLock with_lock; !stop && PyErr_CheckSignals() != 0) stop = true;
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
    throw UsageError("--help: is for programs (allowed: Python's own help)");
  return spoken.command;
}

/// Name, whether it is a flag, what is allowed, meaning and default of every option.
template <class Command>
py::list options() {
  const Spoken<Command> spoken;
  py::list out;
  for (const Option& p : spoken.offers.back().parameters.all())
    out.append(py::make_tuple(p.name, p.takes == Option::Takes::flag, p.check.allowed, p.meaning,
                              p.standard));
  return out;
}

/**
## Tables

A column becomes an array of its own type. */
py::object array_of(const std::vector<double>& x) {
  return ask_interpreter([&] { return py::array_t<double>(py::ssize_t(x.size()), x.data()); });
}

py::object column_of(const Table& table, std::size_t k) {
  if (table.columns[k].kind == Kind::real) return array_of(table.numbers(table.columns[k].name));
  py::list out;
  for (const auto& row : table.rows)
    std::visit([&](const auto& cell) { out.append(cell); }, row[k]);
  if (table.columns[k].kind == Kind::integer)
    return ask_interpreter([&] { return py::array::ensure(out); });
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
