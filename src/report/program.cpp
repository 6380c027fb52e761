/**
# The frame of every program */

#include "report/program.hpp"

#include <fcntl.h>
#include <gsl/gsl_errno.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <deque>
#include <iostream>
#include <optional>
#include <sstream>

#include "report/columns.hpp"
#include "report/command_line.hpp"
#include "report/heartbeat.hpp"
#include "report/sums.hpp"

namespace report {

/**
## Numbers */
Columns quantity_columns() {
  return {label("quantity", "name of the quantity"), number("value", "converged value"),
          number("error", "absolute error, estimated from two resolutions"),
          label("unit", "unit of value and error"),
          label("kind", "estimate, or exact where no error can arise (error 0)")};
}

/**
Where only one of two runs has a quantity its error is not known, and it is not printed either. Numbers that agree
to the last bit have the error of a rounding, which at zero is the least number of the type. */
void Answers::add(const std::string& quantity, const Estimate& e, const std::string& unit,
                  const std::string& meaning, const std::string& reason) {
  const double size = std::max(std::abs(e.value), std::numeric_limits<double>::min());
  if (e.error > size) {
    std::ostringstream text;
    text << quantity << ": the error " << e.error << " exceeds the value " << e.value
         << ", so the result is unresolved; try " << remedy;
    throw Failure(text.str());
  }
  add_small(quantity, e, unit, meaning, reason);
}

void Answers::add_small(const std::string& quantity, const Estimate& e, const std::string& unit,
                        const std::string& meaning, const std::string& reason) {
  if (meaning.empty()) throw std::invalid_argument(quantity + ": has no meaning");
  const bool none = std::isnan(e.value) || std::isnan(e.error);
  std::string why = none ? reason : "";
  if (none && why.empty()) {
    if (std::isnan(e.value)) throw std::logic_error(quantity + ": is nan without a reason");
    why = "only the finer of two runs has a value";
  }
  const char* kind = e.is_exact ? "exact" : "estimate";
  table.add({quantity, none ? undefined : e, unit, kind, meaning, why});
}

/**
## Headers

A key that is known is replaced, and a table is signed with the whole header when it is written. */
void Provenance::set(const std::string& key, const std::string& value) {
  for (Meta* known : {&parameters, &entries})
    for (auto& [name, old] : *known)
      if (name == key) {
        old = value;
        return;
      }
  entries.emplace_back(key, value);
}

Table Provenance::sign(Table table) const {
  Provenance all = *this;
  for (const auto& [key, value] : table.meta) all.set(key, value);
  std::string text;
  for (const auto& [key, value] : all.parameters)
    text += (text.empty() ? "" : ", ") + key + " = " + value;
  table.meta = {};
  for (const auto& [key, value] : all.entries) {
    table.meta.emplace_back(key, value);
    if (key == "command") table.meta.emplace_back("parameters", text);
  }
  return table;
}

/// What is not the same on every machine.
static Meta build() {
  const char* revision = std::getenv("LATTICE_REVISION");
  return {{"revision", revision && *revision ? revision : LATTICE_VERSION},
          {"build", LATTICE_BUILD},
          {"libraries", LATTICE_LIBRARIES}};
}

Table& Output::add(const std::string& name, Table table) {
  return tables_.emplace_back(name, std::move(table)).second;
}

Table& Report::table(const std::string& name, const Columns& columns) {
  return output.add(name, {columns});
}

void Output::finish() {
  Sums sums;
  for (const auto& [name, table] : tables_) {
    if (table.columns.empty()) throw std::logic_error(name + ": a table without a row");
    Table whole = provenance_.sign(table);
    describe(name, whole);
    const std::string text = to_text(whole);
    write_whole(folder_ / (name + ".ecsv"), text);
    sums[name + ".ecsv"] = sha256(text);
  }
  Table made{label("what", "what the tables beside this one were made with"),
             label("value", "the program by its SHA-256, the others in words")};
  made.add({"program", sha256_of("/proc/self/exe")});
  for (const auto& [what, value] : build()) made.add({what, value});
  write(folder_ / "run.ecsv", made);
  write_sums(folder_, sums);
}

namespace {

/**
A header must be the same for the same result. So it holds the options that decide a result, each
with its value, the one typed or the default, and leaves out the number of threads and the place
of the output, on which no digit depends. It holds no clock time, which would make equal runs differ.
How the program was built is in the header of a single table only; the tables of a full run have `run.ecsv` beside
them. */
Provenance provenance(const Program& program, const std::string& command, const Parameters& used) {
  Provenance out{{{"program", program.name},
                  {"section", program.section},
                  {"command", command},
                  {"seed", "none: no random numbers"}},
                 {}};
  for (const Option& p : used.all())
    if (p.name != "threads" && p.name != "out" && p.name != "output")
      out.parameters.emplace_back(p.name, p.used());
  return out;
}

/**
## A run

A job on a shared machine must not take more cores than it was given. Beside the cores that the
system grants we obey Slurm, which may have given the task fewer. */
std::size_t granted_by_slurm() {
  const char* share = std::getenv("SLURM_CPUS_PER_TASK");
  const auto number = share ? parse_number(share) : std::nullopt;
  const std::size_t cores = granted_cores();
  return number && *number >= 1 && *number < double(cores) ? std::size_t(*number) : cores;
}

/// What every program keeps of its line.
struct Invocation {
  const Program& program;
  std::string command, out{}, output{};
  std::size_t threads = 0;
  bool quick = false;
  std::deque<Offer> offers{};  ///< of the program and, after it, of its commands

  Invocation(const Program& of, int argc, char** argv);
  void run(const std::vector<std::string>& words);
  /// Where the tables go unless `--out` says so.
  std::string folder(bool coarse) const {
    return (coarse ? "build/quick/data/" : "build/data/") + program.name;
  }
  void print(const Offer& of);
  void reproduce(const Offer& full);
};

/**
The program and its commands share some options. */
Invocation::Invocation(const Program& of, int argc, char** argv)
    : program(of), command(command_text(of.name, argc, argv)) {
  const auto add_threads = [this](Parameters& p) {
    p.add("threads", threads,
          "number of threads; no effect on results (default: the available cores)", {1, 1024});
  };
  Offer& full = offers.emplace_back();
  full.meaning = of.title;
  full.note = "Without a command the program computes all tables of the section.";
  full.parameters.add("out", out, "folder for the tables of a full run", not_empty()).standard =
      folder(false) + ", with --quick " + folder(true);
  full.parameters.add("quick", quick, "coarse parameters, for a trial run of seconds");
  add_threads(full.parameters);
  for (const Command& one : of.commands) {
    Offer& offer = offers.emplace_back();
    offer.name = one.title.name, offer.meaning = one.title.meaning, offer.note = one.title.note;
    offer.parameters.add("output", output, "file to write (default: standard output)", not_empty());
    add_threads(offer.parameters);
    offer.compute = one.declare(offer.parameters);
  }
}

/// Prints a text, whole.
void say(const std::string& text) {
  if (!(std::cout << text << std::flush)) throw Failure("cannot write to standard output");
}

/// Reads the line and does what was asked for.
void Invocation::run(const std::vector<std::string>& words) {
  const Asked asked = read_line(offers, words);
  if (asked.what == Asked::What::help) return say(help_text(program.name, offers, *asked.of));
  if (asked.what == Asked::What::version)
    return say(program.name + " " LATTICE_VERSION " (" LATTICE_BUILD "; " LATTICE_LIBRARIES ")\n");
  if (asked.what == Asked::What::describe) return say(to_text(description(program.name, offers)));
  set_threads(threads > 0 ? threads : granted_by_slurm());
  return asked.of->compute ? print(*asked.of) : reproduce(*asked.of);
}

/// Throws UsageError unless `file` can be written in `folder`.
void need_writable(const std::filesystem::path& folder, const std::string& file,
                   const std::string& option) {
  const std::string reason = why_not_writable(folder, file);
  if (!reason.empty())
    throw UsageError(option + ": cannot write to '" + (folder / file).string() + "': " + reason +
                     " (allowed: a writable place)");
}

/**
A command prints its table or writes it to `--output`. */
void Invocation::print(const Offer& of) {
  if (!output.empty()) {
    const std::filesystem::path path(output), parent = path.parent_path();
    std::error_code ignored;
    if (path.filename().empty() || std::filesystem::is_directory(path, ignored))
      throw UsageError("--output: '" + output + "' is a folder (allowed: a file)");
    need_writable(parent.empty() ? "." : parent, path.filename().string(), "--output");
  }
  std::optional<Heartbeat> alive(program.name + " " + of.name);
  const Table table = of.compute();  // may say more of its parameters
  alive.reset();
  Provenance all = provenance(program, command, of.parameters);
  for (const auto& [key, value] : build()) all.set(key, value);
  const Table signed_table = all.sign(table);
  if (output.empty()) return say(to_text(signed_table));
  write(output, signed_table);
}

/**
Where summary and figures look for the tables of a full run, coarse ones with fresh checksums would pass for them. So
they have a folder of their own, and another one is refused if its tables say that they are not coarse. */
bool holds_full_run(const std::filesystem::path& folder) try {
  const Sums sums = sums_in(folder);
  return !sums.empty() && !is_quick(read(folder / sums.begin()->first));
} catch (const std::exception&) {
  return false;  // with broken tables it is not complete
}

/**
A full run removes the old `SHA256SUMS` before it begins: as long as there is none, the folder is
not complete. */
void Invocation::reproduce(const Offer& full) {
  if (out.empty()) out = folder(quick);
  if (quick && holds_full_run(out))
    throw UsageError(
        "--out: '" + out +
        "' holds the tables of a full run, which --quick would replace by coarse ones" +
        " (allowed: another folder, such as " + folder(true) + ")");
  need_writable(out, "SHA256SUMS", "--out");
  std::error_code ignored;
  std::filesystem::remove(std::filesystem::path(out) / "SHA256SUMS", ignored);
  Output tables(out, provenance(program, command, full.parameters));
  Report report{tables, quick};
  {
    const Heartbeat alive(program.name);
    program.reproduce(report);
  }
  tables.finish();
}

}  // namespace

/// Fills the places of channels that a shell has closed (`2>&-`), so that writing to them fails: the first file that is
/// opened would take the place of one of them. A file that grows beyond the system's limit is a writing that fails.
static void guard_channels() {
  for (int channel = STDIN_FILENO; channel <= STDERR_FILENO; ++channel)
    if (fcntl(channel, F_GETFD) == -1 && open("/dev/null", O_RDONLY) != channel) break;
  std::signal(SIGXFSZ, SIG_IGN);
}

/**
All that can go wrong arrives here as an exception, and this is the only place that knows exit
codes: 2 for input that cannot be used, 1 for a computation that failed. */
int exit_code(const std::string& program, const std::function<void()>& work) {
  guard_channels();
  gsl_set_error_handler_off();  // its errors are ours to report, not a reason to abort
  const auto complain = [&](std::string message, int code) {
    std::replace(message.begin(), message.end(), '\n', ' ');
    std::cerr << program << ": " << message << '\n';
    return code;
  };
  try {
    work();
    return 0;
  } catch (const UsageError& error) {
    return complain(error.what(), 2);
  } catch (const std::exception& error) {
    return complain(error.what(), 1);
  }
}

int run(const Program& program, int argc, char** argv) {
  return exit_code(program.name, [&] {
    Invocation(program, argc, argv).run({argv + 1, argv + argc});
  });
}

}  // namespace report
