/**
# How a statement reads and compares */

#include "report/statement.hpp"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "report/sums.hpp"

namespace report {

static Estimate joined(const Estimate& a, const Estimate& b, double value, double error) {
  return a.is_exact && b.is_exact ? exact(value) : Estimate(value, error);
}

Estimate operator+(const Estimate& a, const Estimate& b) {
  return joined(a, b, a.value + b.value, a.error + b.error);
}
Estimate operator-(const Estimate& a, const Estimate& b) {
  return joined(a, b, a.value - b.value, a.error + b.error);
}
Estimate operator*(const Estimate& a, const Estimate& b) {
  return joined(a, b, a.value * b.value,
                std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error);
}
Estimate operator/(const Estimate& a, const Estimate& b) {
  if (!(b.error < std::abs(b.value))) throw Unresolved{"a denominator may be zero"};
  const double value = a.value / b.value;
  return joined(a, b, value, (a.error + std::abs(value) * b.error) / (std::abs(b.value) - b.error));
}
Estimate operator-(const Estimate& a) {
  return joined(a, a, -a.value, a.error);
}
Estimate abs(const Estimate& a) {
  return joined(a, a, std::abs(a.value), a.error);
}

/**
## Tables

A program has run if it has listed its tables, and only these count, with the bytes that it wrote. */
const Table& Tables::of(const std::string& program, const std::string& name) {
  const auto known = read_.find({program, name});
  if (known != read_.end()) return known->second;
  const auto path = folder_ / program / (name + ".ecsv");
  const Sums sums = sums_in(folder_ / program);
  if (sums.empty()) throw NotRun{program};
  const auto listed = sums.find(name + ".ecsv");
  if (listed == sums.end()) throw Unresolved{program + " has no table '" + name + "'"};
  if (listed->second != sha256_of(path))
    throw Unresolved{path.string() + " is not the table that its program wrote"};
  Table table = read(path);
  if (table.rows.empty()) throw Unresolved{program + "/" + name + " has no rows"};
  return read_[{program, name}] = std::move(table);
}

void Tables::cut(const std::string& program, const std::string& name, std::size_t rows) {
  Table part = whole_[{program, name}] = of(program, name);
  part.rows.resize(std::min(rows, part.rows.size()));
  read_[{program, name}] = std::move(part);
}

void Tables::restore() {
  for (auto& [name, table] : whole_) read_[name] = std::move(table);
  whole_.clear();
}

double Tables::changed(const Source& from, const std::string& column, std::size_t row,
                       double value) const {
  const bool is_meant = change && change->column == column && change->table == from.name &&
                        change->program == from.program && change->row.value_or(row) == row;
  return is_meant ? change->factor * value + change->offset : value;
}

/**
## The name of a value

A cell is named by its table, its column, and as many of the first cells of its row as no other row has;
results, which have errors, do not name a row. */
static bool is_result(const Table& table, const std::string& column) {
  const std::string error = column + "_error";
  return std::ranges::any_of(table.columns, [&](const Column& c) { return c.name == error; });
}

static std::string shown(const Cell& cell) {
  const auto* real = std::get_if<double>(&cell);
  if (!real) return ecsv::cell_text(cell);
  std::ostringstream out;
  out << *real;
  return out.str();
}

static std::string name_of(const CellRead& cell, const Table& table) {
  const auto& row = table.rows[cell.row];
  std::vector<const std::vector<Cell>*> alike;
  for (const auto& other : table.rows) alike.push_back(&other);
  std::string which;
  for (std::size_t c = 0; c < row.size() && alike.size() > 1; ++c) {
    const std::string& name = table.columns[c].name;
    if (is_result(table, name) || name.ends_with("_error")) continue;
    const auto before = alike.size();
    std::erase_if(alike, [&](const auto* other) { return (*other)[c] != row[c]; });
    if (alike.size() < before)
      which += (which.empty() ? "" : ", ") + table.columns[c].name + " = " + shown(row[c]);
  }
  return cell.table + "." + cell.column + (which.empty() ? "" : " (" + which + ")");
}

/**
## Rows */
Data::Data(Source source) : source_(std::make_shared<const Source>(std::move(source))) {
  for (std::size_t i = 0; i < source_->table.rows.size(); ++i) rows_.push_back({source_, i});
}

std::size_t Source::find(const std::string& column) const try {
  return table.find(column);
} catch (const std::out_of_range&) {
  throw Unresolved{program + "/" + name + " has no column '" + column + "'"};
}

// A cell as a number and as a key
static double number_in(const Cell& cell, const std::string& column) {
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return double(*count);
  if (const auto* real = std::get_if<double>(&cell)) return *real;
  throw Unresolved{"the column '" + column + "' holds texts"};
}

static bool is_same(double a, double b) {
  const double size = std::max(std::abs(a), std::abs(b));
  return a == b || (std::isfinite(size) && std::abs(a - b) <= std::max(1e-9 * size, 1e-12));
}

// Rows by their keys
Data Data::chosen(const std::string& column, const std::function<bool(const Cell&)>& is,
                  const std::string& wanted) const {
  Data out(*this);
  if (rows_.empty()) return out;
  const std::size_t c = source_->find(column);
  std::erase_if(out.rows_, [&](const Row& row) { return !is(source_->table.rows[row.at][c]); });
  if (out.rows_.empty())
    throw Unresolved{source_->program + "/" + source_->name + " has no row with " + column +
                     wanted};
  return out;
}

Data Data::where(const std::string& column, const Key& key) const {
  if (const auto* text = std::get_if<std::string>(&key)) {
    const auto is = [&](const Cell& cell) {
      const auto* other = std::get_if<std::string>(&cell);
      return other && *other == *text;
    };
    return chosen(column, is, " = " + *text);
  }
  const double wanted = std::get<double>(key);
  const auto is = [&](const Cell& cell) { return is_same(number_in(cell, column), wanted); };
  return chosen(column, is, " = " + shown(wanted));
}

Data Data::where(const std::string& column, double low, double high) const {
  for (const double end : {low, high})
    if (std::isfinite(end)) where(column, end);
  const auto is = [&](const Cell& cell) {
    const double x = number_in(cell, column);
    return (x > low || is_same(x, low)) && (x < high || is_same(x, high));
  };
  return chosen(column, is, " from " + shown(low) + " to " + shown(high));
}

// One row
Data::Row Data::only() const {
  if (rows_.size() != 1)
    throw Unresolved{source_->program + "/" + source_->name + " has " +
                     std::to_string(rows_.size()) + " rows instead of one"};
  return rows_.front();
}

const Cell& Data::Row::cell(const std::string& column) const {
  return source->table.rows[at][source->find(column)];
}

double Data::Row::operator()(const std::string& column) const {
  if (is_result(source->table, column))
    throw Unresolved{"'" + column + "' is a result with an error, and was read as a given number"};
  return number_in(cell(column), column);
}

// The number and its error, after the change that a test makes
Quantity Data::Row::operator[](const std::string& column) const {
  const auto& [table, program, name, reading] = *source;
  const std::size_t here = source->find(column);
  const double value = number_in(table.rows[at][here], column),
               now = reading.tables->changed(*source, column, at, value);
  // Who changes a cell asks for the verdict alone
  if (!reading.tables->change) {
    reading.all.insert({program, name, column, at});
    reading.latest.insert({program, name, column, at});
  }

  const Column& heading = table.columns[here];
  const std::string with_error = column + "_error";
  const double error = heading.kind == Kind::integer ? 0 : number_in(cell(with_error), with_error);
  if (!std::isfinite(now) || !std::isfinite(error) || error < 0)
    throw Unresolved{program + ": " + name_of({program, name, column, at}, table) +
                     " is not a number, or has no error"};
  if (error == 0) return {{exact(now)}, heading.unit};
  return {{Estimate(now, now == value ? error : std::abs(now / value) * error)}, heading.unit};
}

/**
## Reductions */
static Estimate from_ends(double value, double low, double high) {
  return {value, std::max(value - low, high - value)};
}

static Estimate extreme(const std::vector<Estimate>& all, double sign) {
  if (all.empty()) throw Unresolved{"nothing to choose from"};
  double value = HUGE_VAL, low = HUGE_VAL, high = HUGE_VAL;
  bool is_exact = true;
  for (const Estimate& e : all) {
    if (!std::isfinite(e.value) || !std::isfinite(e.error))
      throw Unresolved{"one of several values is not a number"};
    value = std::min(value, sign * e.value), is_exact = is_exact && e.is_exact;
    low = std::min(low, sign * e.value - e.error), high = std::min(high, sign * e.value + e.error);
  }
  return is_exact ? exact(sign * value) : sign * from_ends(value, low, high);
}

Estimate least_of(const std::vector<Estimate>& all) {
  return extreme(all, 1);
}

Estimate largest_of(const std::vector<Estimate>& all) {
  return extreme(all, -1);
}

/**
## Comparisons */
Estimate Comparison::left() const {
  Estimate out = large - small;
  if (!is_flipped) return out;
  out.value = may_be_equal ? -std::abs(out.value) - 2 * out.error : -out.value;
  return out;
}

bool Comparison::holds() const {
  const Estimate e = left();
  return is_decided() && (may_be_equal ? e.value >= -e.error : e.value > 0);
}

bool Comparison::is_decided() const {
  const Estimate e = left();
  if (!std::isfinite(e.value) || !std::isfinite(e.error)) return false;
  const double largest = std::max(std::abs(small.value), std::abs(large.value));
  return e.is_exact || (may_be_equal ? e.error < 0.01 * largest : std::abs(e.value) > e.error);
}

Estimate Comparison::margin() const {
  const Estimate e = left();
  const double size = std::max({std::abs(small.value), std::abs(large.value), 1e-300});
  return {e.value / size, e.error / size};
}

// Six digits of a value, one of its error
static std::string text_of(const Estimate& e) {
  std::ostringstream out;
  out.precision(6);
  out << e.value;
  out.precision(1);
  const double rounding = 4e-16 * std::abs(e.value);
  if (e.error > rounding && e.error > 1e-300) out << " +- " << e.error;
  return out.str();
}

std::string Comparison::text() const {
  return what + ": " + text_of(small) + (may_be_equal ? " <= " : " < ") + text_of(large);
}

bool Comparison::fails() const {
  return is_decided() && !holds();
}

// Of several comparisons
Outcome outcome_of(const std::vector<Comparison>& all) {
  const auto hold = std::ranges::count_if(all, &Comparison::holds),
             fail = std::ranges::count_if(all, &Comparison::fails);
  if (hold > 0 && fail > 0) return Outcome::in_part;
  if (hold + fail < std::ssize(all)) return Outcome::undecided;
  return fail > 0 ? Outcome::fails : Outcome::holds;
}

int Judged::failures() const {
  return int(std::ranges::count_if(comparisons, &Comparison::fails));
}

const Comparison* Judged::lost_control() const {
  const auto at = std::ranges::find_if_not(controls, &Comparison::holds);
  return at == controls.end() ? nullptr : &*at;
}

bool Judged::is_sensitive() const {
  const Outcome ours = outcome_of(comparisons);
  return std::ranges::any_of(
      readings, [&](const OtherReading& other) { return other.outcome && *other.outcome != ours; });
}

// In words
const Comparison* Judged::closest() const {
  const auto slack = [](const Comparison& c) {
    const Estimate m = c.margin();
    return c.may_be_equal ? m.value + m.error : m.value - m.error;
  };
  const auto at = std::min_element(comparisons.begin(), comparisons.end(),
                                   [&](auto& a, auto& b) { return slack(a) < slack(b); });
  return at == comparisons.end() ? nullptr : &*at;
}

std::string Judged::text() const {
  if (!lost.empty()) return lost;
  if (!not_run.empty()) return not_run + " has not run";
  if (lost_control()) return "a control fails: " + lost_control()->text();
  if (answer) return text_of(*answer) + (answer->unit.empty() ? "" : " " + answer->unit);
  const auto failed = std::ranges::find_if(comparisons, &Comparison::fails);
  const auto worst = std::ranges::min_element(
      comparisons, {}, [](const Comparison& c) { return c.fails() ? c.margin().value : HUGE_VAL; });

  if (outcome_of(comparisons) == Outcome::in_part)
    return "fails " + std::to_string(failures()) + " of " + std::to_string(comparisons.size()) +
           " comparisons; first " + failed->text() +
           (failed == worst ? "" : "; by most " + worst->text());
  if (comparisons.size() > 3)
    return closest()->text() + " (the closest of " + std::to_string(comparisons.size()) + ")";
  std::string out;
  for (const Comparison& c : comparisons) out += (out.empty() ? "" : "; ") + c.text();
  return out;
}

/**
## Statements

What a comparison is about is told by the cells that were read for it. */
std::string Statement::cells_read() {
  const std::size_t most = 3, all = reading_.latest.size();
  std::string out;
  std::string before;
  for (const CellRead& cell : reading_.latest) {
    const std::string name = name_of(cell, reading_.tables->of(cell.program, cell.table));
    const std::string column = name.substr(0, name.find(" ("));
    // Of the same column only the row is said
    const bool has_row = name.size() > column.size();
    out += out.empty() ? "" : ", ";
    out += has_row && column == before ? name.substr(column.size() + 1) : name;
    before = column;
    if (all > most) break;
  }
  reading_.latest.clear();
  return all > most ? out + " and " + std::to_string(all - 1) + " other values" : out;
}

void Statement::note(const Estimate& a, const Estimate& b, bool may_be_equal) {
  const std::string what = cells_read();
  const auto& before = judged_.comparisons;
  judged_.comparisons.push_back(
      {what.empty() && !before.empty() ? before.back().what : what, a, b, may_be_equal});
}

// The comparisons
void Statement::less(const Estimate& a, const Estimate& b) {
  note(a, b, false);
}
void Statement::not_more(const Estimate& a, const Estimate& b) {
  note(a, b, true);
}
void Statement::near(const Estimate& a, const Estimate& b, const Estimate& distance) {
  note(abs(a - b), distance, false);
  judged_.comparisons.back().what += " away from " + text_of(b);
}
void Statement::increases(const Data& rows, const std::string& along, const std::string& column) {
  if (rows.size() < 2) throw Unresolved{"nothing can increase in one row"};
  for (const Data::Row* row = rows.begin() + 1; row < rows.end(); ++row) {
    if (!(row[-1](along) < row[0](along))) throw Unresolved{"the rows do not follow " + along};
    less(row[-1][column], row[0][column]);
  }
}
void Statement::within(const Estimate& a, const Estimate& low, const Estimate& high) {
  less(low, a);
  less(a, high);
}

/**
## Choices of ours

A bound is known by its place in the source, so that one in a loop is one bound. */
Estimate Statement::bound(double ours, std::source_location at) {
  const Place place{at.line(), at.column()};
  bounds_.emplace(place, ours);
  return ours * (place == changed_ ? factor_ : 1);
}

std::vector<Comparison> Statement::apart(const std::function<void()>& compare) {
  std::vector<Comparison> ours = std::exchange(judged_.comparisons, {});
  compare();
  if (judged_.comparisons.empty()) throw Unresolved{"nothing is compared"};
  return std::exchange(judged_.comparisons, std::move(ours));
}

void Statement::control(const std::function<void()>& compare) {
  std::ranges::move(apart(compare), std::back_inserter(judged_.controls));
}

void Statement::reading(const std::string& name, const std::function<void()>& compare) {
  judged_.readings.push_back({name, {}, outcome_of(apart(compare))});
}

void Statement::reading(const std::string& name, const Quantity& value) {
  judged_.readings.push_back({name, value, {}});
  reading_.latest.clear();
}

void Statement::answer(const Quantity& found) {
  if (judged_.answer) throw std::logic_error("a statement has two answers");
  judged_.answer = found;
  judged_.answered_by = cells_read();
}

// What a statement reads
Data Statement::table(const std::string& program, const std::string& name) {
  const Table& found = reading_.tables->of(program, name);
  judged_.is_quick = judged_.is_quick || is_quick(found);
  return Data({found, program, name, reading_});
}
Data Statement::table(const std::string& name) {
  return table(program_, name);
}

// How it is judged, and how it comes to be known
Judged Statement::judged_once(Tables& tables, const std::string& program) {
  judged_ = {}, reading_ = {&tables}, program_ = program;
  judged_.program = program;
  try {
    judge();
    for (const OtherReading& other : judged_.readings)
      if (other.value.has_value() != judged_.answer.has_value())
        throw std::logic_error("the reading '" + other.name +
                               "' is of another kind than its statement");
    if (!judged_.answer == judged_.comparisons.empty())
      judged_.lost = judged_.answer ? "both an answer and comparisons" : "nothing is compared";
  } catch (const NotRun& it) {
    judged_.not_run = it.program;
  } catch (const Unresolved& it) {
    judged_.lost = it.why;
  }
  judged_.cells = std::move(reading_.all);
  return judged_;
}

// Once with our bounds, and once more with each of them halved and doubled
Judged Statement::judged(Tables& tables, const std::string& program) {
  bounds_.clear(), factor_ = 1;
  Judged ours = judged_once(tables, program);
  for (const auto& [place, value] : bounds_)
    for (const double factor : {0.5, 2.0}) {
      changed_ = place, factor_ = factor;
      const Judged other = judged_once(tables, program);
      std::ostringstream name;
      name << factor * value << " in the place of " << value;
      const bool is_lost = !other.lost.empty() || !other.not_run.empty() || other.lost_control();
      if (ours.answer && is_lost)
        ours.lost = "without a bound of ours it cannot be measured: " + name.str();
      if (!ours.answer)
        ours.readings.push_back(
            {name.str(), {}, is_lost ? Outcome::undecided : outcome_of(other.comparisons), true});
    }
  return ours;
}

static std::map<std::string, Registered>& registered() {
  static std::map<std::string, Registered> all;
  return all;
}

const std::map<std::string, Registered>& statements() {
  return registered();
}

// All that are linked, for a chapter of one's own
bool all_hold(const std::filesystem::path& folder) {
  Tables tables(folder);
  bool all = !statements().empty();
  for (const auto& [id, statement] : statements()) {
    const Judged found = statement.judge(tables);
    const bool holds = found.lost.empty() && found.not_run.empty() && !found.lost_control() &&
                       outcome_of(found.comparisons) == Outcome::holds;
    std::cout << id << (holds ? " holds: " : " FAILS: ") << found.text() << '\n';
    all = all && holds;
  }
  return all;
}

Register::Register(const std::string& id, const char* file,
                   Judged (*judge)(Tables&, const std::string&)) {
  const std::string program = std::filesystem::path(file).stem().string();
  const bool is_new =
      registered().insert({id, {program, [=](Tables& t) { return judge(t, program); }}}).second;
  if (!is_new) throw std::logic_error("the statement " + id + " is judged twice");
}

}  // namespace report
