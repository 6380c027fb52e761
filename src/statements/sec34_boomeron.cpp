/**
# Statements of section 3.4: Packets that reverse their direction in hard wells */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("boomeron.reversal") {
  const Data ways = table("acceleration").where("s", 1).where("velocity", 1.9);
  less(ways.at("part", "out")["acceleration"], 0);
  less(ways.at("part", "back")["acceleration"], 0);

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
  const Data turns = table("turns").where("s", 1), quarters = table("slowing");
  const auto turn = turns.at("velocity", 1.5);
  less(1000, turn["apex_time"]);  // the end of the figure
  for (int quarter : {1, 2, 3})
    less(quarters.at("quarter", quarter + 1)["speed"], quarters.at("quarter", quarter)["speed"]);
  less(0, quarters.at("quarter", 4)["speed"]);
  const Data out = table("acceleration").where("s", 1).where("part", "out");
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
  const Estimate stop = least(table("printed_range").where("velocity", 1.865, 1.875), "stop_time");
  reading("first stop", [&] {
    for (double t : {238.0, 241.0}) less(stop - exact(t), part * stop);
  });
  reading("speed", [&] {
    for (const auto& then : near) less(then["speed"] / then["first_speed"], exact(0.25));
  });
}

STATEMENT("boomeron.any_s") {
  const Data turns = table("turns"), weak = table("weakly_hard");
  const Estimate back = bound(5);
  const auto on = [&](double s, double velocity) {
    less(weak.at("s", s, "velocity", velocity)["fallen_back"], back);
    less(0, weak.at("s", s, "velocity", velocity)["speed"]);
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
  const Data spread = table("spread");
  const auto becomes_erratic = [&](double noise) {
    const Data part = spread.where("noise", noise);
    less(part.at("part", "out_and_back")["deviation"], bound(0.25));
    less(bound(3), part.at("part", "late")["deviation"]);
  };
  becomes_erratic(1e-6);
  reading("noise of 1e-4", [&] { becomes_erratic(1e-4); });
  reading("noise of 1e-8", [&] { becomes_erratic(1e-8); });
}

STATEMENT("boomeron.constant_force") {
  const Data hard = table("acceleration").where("s", 1);
  const auto over_out = [&](double velocity, const char* part) {
    const Data ways = hard.where("velocity", velocity);
    return ways.at("part", part)["acceleration"] / ways.at("part", "out")["acceleration"];
  };
  answer(over_out(1.9, "between"), "");
  reading("out and back", over_out(1.9, "back"));
  reading("digits of 1.9", over_out(1.93, "between"));
  const Data arcs = table("arcs");
  reading("parabola", arcs.at("arc", 1)["deviation"]);
  reading("second arc", arcs.at("arc", 2)["deviation"]);
}

STATEMENT("boomeron.force_grows") {
  const Data all = table("acceleration");
  const auto grows = [&](const char* part, const char* measure) {
    const Data out = all.where("part", part);
    const auto from_each_to_the_next = [&](const Data& rows, const char* along) {
      for (const auto& one : rows) {
        const Data::Row* next = nullptr;
        for (const auto& other : rows)
          if (one(along) < other(along) && (!next || other(along) < (*next)(along))) next = &other;
        if (next) less(abs(one[measure]), abs((*next)[measure]));
      }
    };
    from_each_to_the_next(out.where("s", 1).where("velocity", 1.1, 2), "velocity");
    from_each_to_the_next(out.where("velocity", 1.9).where("s", 0.005, 1), "s");
  };
  grows("out", "acceleration");
  reading("earlier", [&] { grows("earlier", "acceleration"); });
  reading("later", [&] { grows("later", "acceleration"); });
  reading("speeds", [&] { grows("out", "mean_change"); });
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
