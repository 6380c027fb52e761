/**
# Statements of section 3.4: Packets that reverse their direction in hard wells */

#include <vector>

#include "report/statement.hpp"

using namespace report;

STATEMENT("boomeron.reversal") {
  const Data out = table("acceleration").where("s", 1).where("velocity", 1.9);
  less(out.at("t", 160)["acceleration"], 0);

  // It comes back, to the end that was hit, and moves out again
  const Data turns = table("turns").where("s", 1);
  const auto bounces = [&](double velocity) {
    const auto packet = turns.at("velocity", velocity);
    less(packet["return_site"] + bound(5), packet["apex_site"]);
    less(packet["return_site"], bound(3));
    less(packet["apex_time"], packet["return_time"]);
    less(packet["return_site"] + bound(3), packet["out_again"]);
  };
  bounces(1.9);
  reading("digits of 1.9", [&] { bounces(1.85), bounces(1.95); });
}

STATEMENT("boomeron.moderate") {
  const Data turns = table("turns").where("s", 1), hard = table("acceleration").where("s", 1);
  const auto turn = turns.at("velocity", 1.5);
  less(1000, turn["apex_time"]);  // the end of the figure
  // Slower and slower, from the middle of one quarter to that of the next
  const Data path = hard.where("velocity", 1.5);
  for (double t : {120, 370, 620}) less(path.at("t", t + 250)["speed"], path.at("t", t)["speed"]);
  less(0, path.at("t", 870)["speed"]);
  const Data out = hard.where("t", 160);
  const auto turning = out.at("velocity", 1.9)["acceleration"];
  for (double velocity : {1.1, 1.3, 1.5}) {
    const auto moderate = out.at("velocity", velocity)["acceleration"];
    less(moderate, 0);
    less(moderate / turning, bound(0.5));
  }
  reading("time to the turn",
          [&] { less(2 * turns.at("velocity", 1.9)["apex_time"], turn["apex_time"]); });
}

STATEMENT("boomeron.turning_time") {
  // In place: nearer to its turning point than half of the seven sites on which a packet lives
  const Data near = table("close_to_turning");
  const auto turn = table("turns").at("s", 1, "velocity", 1.87);
  const Estimate half = bound(3.5), part = bound(0.1);
  for (double t : {238.0, 241.0}) less(near.at("t", t)["distance"], half);

  reading("in time", [&] {
    for (double t : {238.0, 241.0}) less(turn["apex_time"] - exact(t), part * turn["apex_time"]);
  });
  const Estimate stop =
      least(table("turns").where("s", 1).where("velocity", 1.865, 1.875), "stop_time");
  reading("first stop", [&] {
    for (double t : {238.0, 241.0}) less(stop - exact(t), part * stop);
  });
  reading("speed", [&] {
    for (const auto& then : near) less(then["speed"] / then["first_speed"], exact(0.25));
  });
}

STATEMENT("boomeron.any_s") {
  const Data turns = table("turns"), weak = table("onward");
  const Estimate back = bound(5);
  const auto on = [&](double s, double velocity) {
    less(weak.at("s", s, "velocity", velocity)["fallen_back"], back);
  };
  const auto turns_round = [&](double velocity) {
    less(back, weak.at("s", 0.005, "velocity", velocity)["fallen_back"]);
  };
  for (double s : {0.005, 0.02, 0.1, 0.5}) {
    const auto packet = turns.at("s", s);
    less(packet["return_site"] + back, packet["apex_site"]);
  }
  on(0, 132);
  on(0, 1.9);
  reading("printed impacts", [&] { on(0, 1.5), on(0, 1.9), turns_round(1.5), turns_round(1.9); });
  reading("strong impacts", [&] { turns_round(5), turns_round(27), turns_round(60); });
}

STATEMENT("boomeron.erratic") {
  const auto spread = table("predictable").at("noise", 1e-6);
  less(spread["early"], bound(0.25));
  less(bound(3), spread["late"]);
}

STATEMENT("boomeron.constant_force") {
  const Data out = table("acceleration").where("s", 1).where("t", 160),
             turns = table("turns").where("s", 1);
  const auto over_out = [&](double velocity) {
    return turns.at("velocity", velocity)["at_turn"] / out.at("velocity", velocity)["acceleration"];
  };
  answer(over_out(1.9), "");
  reading("digits of 1.9", over_out(1.93));
  reading("parabola", turns.at("velocity", 1.9)["parabola"]);
}

STATEMENT("boomeron.force_grows") {
  const auto grows = [&](double t) {
    const Data all = table("acceleration").where("t", t);
    const auto from_each_to_the_next = [&](const Data& rows, const char* along,
                                           const std::vector<double>& values) {
      for (std::size_t i = 1; i < values.size(); ++i)
        less(abs(rows.at(along, values[i - 1])["acceleration"]),
             abs(rows.at(along, values[i])["acceleration"]));
    };
    from_each_to_the_next(all.where("s", 1), "velocity",
                          {1.1, 1.3, 1.5, 1.6, 1.7, 1.8, 1.87, 1.9, 2});
    from_each_to_the_next(all.where("velocity", 1.9), "s", {0.005, 0.05, 0.25, 0.5, 0.75, 1});
  };
  grows(160);
  reading("earlier", [&] { grows(120); });
}

STATEMENT("boomeron.waves") {
  // Farther than five sites from the centre, which is near site 21
  const Data profiles = table("turning_profiles");
  for (double t : {238.0, 241.0}) {
    const Data then = profiles.where("t", t);
    const auto largest_speed = [&](double from, double to) {
      return largest(then.where("n", from, to), [](const auto& bead) { return abs(bead["v"]); });
    };
    const Estimate behind = largest_speed(1, 15), ahead = largest_speed(27, 40);
    less(bound(0.05) * largest_speed(1, 40), behind);
    less(ahead, bound(0.1) * behind);
  }
}
