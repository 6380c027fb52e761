#pragma once
/**
# How the command line is read

CLI11 reads the command line, and only this file knows it. It takes longer to compile than a chapter, so
our own programs share one compiled copy (tools/once_frame.cpp) and define LATTICE_ONCE_COMPILED; any other
program that includes this file compiles it itself. */

#include <gsl/gsl_errno.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>

#include "lattice/model/model.hpp"
#include "lattice/report/potential_options.hpp"
#include "lattice/report/program.hpp"

namespace lattice {

/**
A number is refused with the range that is allowed. */
LATTICE_ONCE Check in_range(double lo, double hi, const std::string& unit) {
  const std::string range =
      "[" + short_text(lo) + ", " + short_text(hi) + "]" + (unit.empty() ? "" : " " + unit);
  const auto complaint = [lo, hi, range](const std::string& value) {
    const auto x = parse_number(value);
    if (!x) return "'" + value + "' is not a number (allowed: " + range + ")";
    const bool good = *x >= lo && *x <= hi;
    return good ? "" : "'" + short_text(*x) + "' is not in the allowed range " + range;
  };
  return {complaint, range};
}

/**
Names are free, or some of a list. */
LATTICE_ONCE Check not_empty() {
  return {[](const std::string& value) { return value.empty() ? "'' is not a name" : ""; }, ""};
}

LATTICE_ONCE Check one_of(const std::vector<std::string>& names) {
  const auto complaint = [names](const std::string& value) {
    for (const std::string& name : names)
      if (name == value) return std::string();
    return "'" + value + "' is not one of the allowed names " + comma_list(names);
  };
  return {complaint, "{" + comma_list(names) + "}"};
}

/**
Our options and checks are CLI11's in other words. */
namespace detail {
inline CLI::Validator validator(const Check& check) {
  return CLI::Validator([check](std::string& value) { return check.complaint(value); },
                        check.allowed);
}
inline CLI::App& app_of(void* app) {
  return *static_cast<CLI::App*>(app);
}
inline CLI::Option& option_of(void* option) {
  return *static_cast<CLI::Option*>(option);
}
}  // namespace detail

/**
What a chapter may say of an option. */
LATTICE_ONCE Option* Option::check(const Check& check) {
  detail::option_of(option_).check(detail::validator(check));
  return this;
}
LATTICE_ONCE Option* Option::shows(const std::string& value) {
  detail::option_of(option_).default_str(value);
  return this;
}
LATTICE_ONCE Option* Option::excludes(const Option* other) {
  detail::option_of(option_).excludes(&detail::option_of(other->option_));
  return this;
}
LATTICE_ONCE bool Option::given() const {
  return detail::option_of(option_).count() > 0;
}

/**
A chapter holds on to its options by address, so they do not move. */
LATTICE_ONCE Option* Command::kept(void* option) {
  return &options_.emplace_back(option);
}
LATTICE_ONCE Option* Command::add_option(const std::string& name, double& value,
                                         const std::string& meaning) {
  return kept(detail::app_of(app_).add_option(name, value, meaning));
}
LATTICE_ONCE Option* Command::add_option(const std::string& name, std::size_t& value,
                                         const std::string& meaning) {
  return kept(detail::app_of(app_).add_option(name, value, meaning));
}
LATTICE_ONCE Option* Command::add_option(const std::string& name, std::string& value,
                                         const std::string& meaning) {
  return kept(detail::app_of(app_).add_option(name, value, meaning));
}
LATTICE_ONCE Option* Command::add_option(const std::string& name,
                                         std::function<void(const std::string&)> take,
                                         const std::string& meaning) {
  return kept(detail::app_of(app_).add_option_function<std::string>(name, take, meaning));
}
/**
A flag has no value, and what follows from several options waits for the whole line. */
LATTICE_ONCE void Command::add_flag(const std::string& name, bool& value,
                                    const std::string& meaning) {
  detail::app_of(app_).add_flag(name, value, meaning);
}
LATTICE_ONCE void Command::when_read(std::function<void()> then) {
  detail::app_of(app_).parse_complete_callback(std::move(then));
}

/**
CLI11 would read `031` as octal, refuse `1e+06` for a count and round a number twice. So each number
is read by us first and handed on in a form without doubt. The library names the type of an option
and what is allowed in one text, `UINT:[2, 100000]`. */
inline void read_numbers_ourselves(CLI::Option& option) {
  const std::string text = option.get_type_name(), type = text.substr(0, text.find(':'));
  const bool whole = type == "UINT" || type == "INT";
  if (!whole && type != "FLOAT") return;
  const std::string allowed =
      text.find(':') == std::string::npos ? "" : " (allowed: " + text.substr(type.size() + 1) + ")";
  option.transform(CLI::Validator(
      [whole, allowed](std::string& value) {
        const auto x = parse_number(value);
        if (!x) return "'" + value + "' is not a number" + allowed;
        if (whole && !(*x == std::floor(*x) && std::abs(*x) < 1e15))
          return "'" + value + "' is not a whole number" + allowed;
        value = whole ? short_text(*x) : number_text(*x);
        return std::string();
      },
      ""));
}

/**
Help must show every default, also one that is no plain value, such as a length that follows from
another option. Such a default stands in the description, `(default: as long as needed)`, and is
taken out of it here, so that it is shown, and recorded, like all the others. */
inline void take_default_from_description(CLI::Option& option) {
  const std::string text = option.get_description(), mark = " (default: ";
  const auto at = text.find(mark);
  if (at == std::string::npos || text.back() != ')') return;
  option.default_str(text.substr(at + mark.size(), text.size() - at - mark.size() - 1));
  option.description(text.substr(0, at));
}

/// Makes all options of `app` as this file promises; to be called when all of them are there.
inline void settle_options(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    take_default_from_description(*option);
    read_numbers_ourselves(*option);
  }
}

/**
The two readers of the defaults follow: help, for those who ask before a run, and the header of a
table, for those who ask afterwards which parameters a number belongs to. A flag has no value and
shows none. */
inline bool is_flag(const CLI::Option* option) {
  return option->get_items_expected_max() == 0;
}

/// Help that ends each option with its default.
struct Help : CLI::Formatter {
  std::string make_option_opts(const CLI::Option* option) const override {
    return is_flag(option) ? "" : " " + option->get_type_name();
  }
  std::string make_option_desc(const CLI::Option* option) const override {
    const std::string value = is_flag(option) ? "" : option->get_default_str();
    return option->get_description() + (value.empty() ? "" : " (default: " + value + ")");
  }
};

/**
A header must be the same for the same result. So it holds the options that decide a result, each
with its value, the one typed or the default, and leaves out the number of threads and the place
of the output, on which no digit depends. */
inline Meta recorded_options(const CLI::App& app) {
  Meta out;
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = option->get_single_name();
    if (name == "help" || name == "version" || name == "threads" || name == "out" ||
        name == "output")
      continue;
    std::string value = option->get_default_str();
    if (is_flag(option))
      value = option->count() > 0 ? "yes" : "no";
    else if (option->count() > 0)
      value = option->results().back();
    if (const auto x = parse_number(value)) value = short_text(*x);
    out.emplace_back(name, value);
  }
  return out;
}

/**
## The program

What `Program` keeps to itself. */
struct Program::Frame {
  Frame(Identity program, std::string line)
      : identity(std::move(program)),
        app(identity.title, identity.name),
        command(std::move(line)) {}

  Identity identity;
  CLI::App app;
  std::string command, out{}, output{};
  std::size_t threads = 0;
  std::deque<Command> commands{};
  std::vector<std::pair<CLI::App*, std::function<Table()>>> computations{};

  void add_threads(CLI::App& to);
  static std::size_t granted();
  int complain(std::string message, int code) const;
  Provenance provenance(const CLI::App& of) const;
  static void need_writable(const std::filesystem::path& folder, const std::string& file,
                            const std::string& option);
  int print(const CLI::App& sub, const std::function<Table()>& compute);
  int run_everything(const std::function<void(Report&)>& everything, bool quick);
};

/**
Every program has these options for its full run. */
LATTICE_ONCE Program::Program(Identity identity, int argc, char** argv)
    : frame_(std::make_unique<Frame>(identity, command_text(identity.name, argc, argv))) {
  gsl_set_error_handler_off();  // its errors are ours to report, not a reason to abort
  CLI::App& app = frame_->app;
  app.option_defaults()->always_capture_default();
  app.formatter(std::make_shared<Help>());
  app.set_version_flag("--version", identity.name + " " LATTICE_VERSION " (" LATTICE_BUILD
                                                    "; " LATTICE_LIBRARIES ")");
  app.add_option("--out", frame_->out, "folder for the tables of a full run")
      ->check(detail::validator(not_empty()))
      ->default_str("build/data/" + identity.name);
  app.add_flag("--quick", quick, "coarse parameters: seconds, for trying out");
  frame_->add_threads(app);
  app.require_subcommand(0, 1);
}

LATTICE_ONCE Program::~Program() = default;

/**
Subcommands share the options that every command has. */
LATTICE_ONCE Command* Program::command(const std::string& name, const std::string& help,
                                       std::function<Table()> compute) {
  CLI::App* sub = frame_->app.add_subcommand(name, help);
  sub->add_option("--output", frame_->output, "file to write (default: standard output)")
      ->check(detail::validator(not_empty()));
  frame_->add_threads(*sub);
  sub->footer(
      "A quantity that does not exist, such as the speed of a packet that never left, is "
      "nan.");
  frame_->computations.emplace_back(sub, std::move(compute));
  return &frame_->commands.emplace_back(sub);
}

/**
All that can go wrong arrives here as an exception, and this is the only place that knows exit
codes: 2 for input that cannot be used, 1 for a computation that failed. */
LATTICE_ONCE int Program::run(int argc, char** argv) {
  Frame& frame = *frame_;
  try {
    settle_options(frame.app);
    for (const auto& [sub, compute] : frame.computations) settle_options(*sub);
    frame.app.parse(argc, argv);
    set_threads(frame.threads > 0 ? frame.threads : Frame::granted());
    for (const auto& [sub, compute] : frame.computations)
      if (sub->parsed()) return frame.print(*sub, compute);
    return frame.run_everything(everything, quick);
  } catch (const CLI::Success& success) {
    return frame.app.exit(success);
  } catch (const CLI::ParseError& error) {
    return frame.complain(error.what(), 2);
  } catch (const UsageError& error) {
    return frame.complain(error.what(), 2);
  } catch (const std::exception& error) {
    return frame.complain(error.what(), 1);
  }
}

/**
A job on a shared machine must not take more cores than it was given. Beside the cores that the
system grants we obey Slurm, which may have given the task fewer. */
LATTICE_ONCE void Program::Frame::add_threads(CLI::App& to) {
  to.add_option("--threads", threads,
                "threads, on which no result depends (default: the cores granted)")
      ->check(detail::validator(in_range(1, 1024)));
}

LATTICE_ONCE std::size_t Program::Frame::granted() {
  const char* share = std::getenv("SLURM_CPUS_PER_TASK");
  const auto number = share ? parse_number(share) : std::nullopt;
  const std::size_t cores = granted_cores();
  return number && *number >= 1 && *number < double(cores) ? std::size_t(*number) : cores;
}

LATTICE_ONCE int Program::Frame::complain(std::string message, int code) const {
  for (char& c : message)
    if (c == '\n') c = ' ';
  std::cerr << identity.name << ": " << message << '\n';
  return code;
}

/**
Who made the table: everything needed to make it again, and no clock time, which would make equal
runs differ. */
LATTICE_ONCE Provenance Program::Frame::provenance(const CLI::App& of) const {
  const char* revision = std::getenv("LATTICE_REVISION");
  return {{{"program", identity.name},
           {"section", identity.section},
           {"command", command},
           {"seed", "none: no random numbers"},
           {"revision", revision && *revision ? revision : LATTICE_VERSION},
           {"build", LATTICE_BUILD},
           {"libraries", LATTICE_LIBRARIES}},
          recorded_options(of)};
}

/**
Nobody wants to learn after hours of work that `file` in `folder` cannot be written, so we make the
folder and try at once, under a temporary name. What exists and is no ordinary file (a device, a
pipe) is taken as it is. */
LATTICE_ONCE void Program::Frame::need_writable(const std::filesystem::path& folder,
                                                const std::string& file,
                                                const std::string& option) {
  std::error_code error, ignored;
  std::filesystem::create_directories(folder, error);
  const std::filesystem::path path = folder / file, part = path.string() + ".part";
  if (!error && std::filesystem::exists(path, error) &&
      !std::filesystem::is_regular_file(path, ignored))
    return;
  if (!error) {
    const bool known = std::filesystem::exists(part, ignored);
    errno = 0;
    if (!std::ofstream(part, std::ios::app)) error.assign(errno, std::generic_category());
    if (!known) std::filesystem::remove(part, ignored);
  }
  if (error)
    throw UsageError(option + ": cannot write to '" + path.string() + "': " + error.message() +
                     " (allowed: a place where you may write)");
}

/**
A subcommand prints its table or writes it to `--output`; options of a full run mean nothing to it,
and rather than ignore them we say so. */
LATTICE_ONCE int Program::Frame::print(const CLI::App& sub, const std::function<Table()>& compute) {
  for (const char* option : {"--out", "--quick"})
    if (app.count(option) > 0)
      throw UsageError(std::string(option) + ": has no meaning before '" + sub.get_name() +
                       "' (allowed: in a full run, without a subcommand)");
  if (!output.empty()) {
    const std::filesystem::path path(output), parent = path.parent_path();
    std::error_code ignored;
    if (path.filename().empty() || std::filesystem::is_directory(path, ignored))
      throw UsageError("--output: '" + output + "' is a folder (allowed: a file)");
    need_writable(parent.empty() ? "." : parent, path.filename().string(), "--output");
  }
  const Table table = [&] {
    const Heartbeat alive(identity.name + " " + sub.get_name());
    return provenance(sub).sign(compute());
  }();
  if (!output.empty()) {
    write(output, table);
  } else if (!(std::cout << to_text(table) << std::flush)) {
    throw Failure("cannot write to standard output");
  }
  return 0;
}

/**
A full run removes the old `results.ecsv` before it begins: as long as there is none, the folder is
not complete. */
LATTICE_ONCE int Program::Frame::run_everything(const std::function<void(Report&)>& everything,
                                                bool quick) {
  if (out.empty()) out = "build/data/" + identity.name;
  need_writable(out, "results.ecsv", "--out");
  std::error_code ignored;
  std::filesystem::remove(std::filesystem::path(out) / "results.ecsv", ignored);
  Output output(out, provenance(app));
  Report report{output, quick};
  {
    const Heartbeat alive(identity.name);
    everything(report);
  }
  output.add("facts", report.facts.table);
  output.finish(report.results);
  return 0;
}

}  // namespace lattice
