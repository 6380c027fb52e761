/**
# The report

Compares every answer under the data folder with the article's statements, writes the table
*published against reproduced* and prints its summary. */

#include <cstdio>
#include <iostream>
#include <map>

#include "lattice/report/claims.hpp"
#include "lattice/report/program.hpp"

using namespace lattice;

namespace {

Table compare_all(const std::vector<Claim>& claims, const std::filesystem::path& data) {
  const auto answers = read_answers(data);
  Table table{
      {label("id", "identifier"), label("where", "place in the article"),
       label("quantity", "what is claimed"), label("published", "value or statement as printed"),
       number("reproduced", "converged value; 1 or 0 for a statement"),
       number("error", "error of the reproduced value"),
       label("unit", "unit of both values; claim for a statement"),
       label("verdict", "reproduced, discrepant, claim (holds), unresolved or open"),
       label("program", "program that answers"), label("reason", "likely cause of a discrepancy")}};
  for (const Claim& c : claims) {
    const auto found = answers.find({c.program, c.id});
    const bool open = found == answers.end();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    table.add({c.id, c.where, c.quantity, c.printed, open ? nan : found->second.value,
               open ? nan : found->second.error,
               !open && found->second.unit == "claim" ? found->second.unit : c.unit,
               open ? std::string("open") : verdict(c, found->second), c.program, c.reason});
  }
  return table;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Published against reproduced", "report"};
  std::string data = "build/data", published = "paper/published.ecsv", out = "build/report";
  app.add_option("--data", data, "folder with one folder of tables a program");
  app.add_option("--published", published, "the article's statements");
  app.add_option("--out", out, "folder for published.ecsv");
  try {
    app.parse(argc, argv);
    Table table = compare_all(read_claims(published), data);
    table.meta = {{"program", "report"}, {"build", LATTICE_BUILD}};
    std::filesystem::create_directories(out);
    write(std::filesystem::path(out) / "published.ecsv", table);
    std::map<std::string, int> tally;
    for (const auto& v : table.texts("verdict")) ++tally[v];
    std::printf("claims     : %d reproduced, %d hold, %d discrepant, %d unresolved, %d open\n",
                tally["reproduced"], tally["claim"], tally["discrepant"], tally["unresolved"],
                tally["open"]);
    const auto id = table.texts("id"), verdicts = table.texts("verdict");
    const auto printed = table.texts("published"), unit = table.texts("unit");
    const auto value = table.numbers("reproduced"), error = table.numbers("error");
    for (std::size_t i = 0; i < id.size(); ++i)
      if (verdicts[i] == "discrepant" && unit[i] == "claim")
        std::printf("  %-10s %-22s printed %s, does not hold by our criterion\n",
                    verdicts[i].c_str(), id[i].c_str(), printed[i].c_str());
      else if (verdicts[i] == "discrepant" || verdicts[i] == "unresolved")
        std::printf("  %-10s %-22s printed %s, converged %.6g +- %.1g %s\n", verdicts[i].c_str(),
                    id[i].c_str(), printed[i].c_str(), value[i], error[i], unit[i].c_str());
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    std::cerr << "report: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "report: " << error.what() << '\n';
    return 1;
  }
}
