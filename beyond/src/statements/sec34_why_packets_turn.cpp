/**
# Statements of section 3.4: Why packets turn round */

#include <utility>

#include "report/statement.hpp"

using namespace lattice;
using namespace report;

STATEMENT("turning.momentum") {
  const Data momenta = table("momenta");
  const char* const runs[] = {"all waves", "wiped at 200", "absorbed beyond 20",
                              "absorbed beyond 10", "isolated at 60"};
  for (const char* name : runs) {
    const auto run = momenta.at("run", name);
    less(1 - bound(0.1), run["momentum"]);
    less(run["envelope"], -0.9);
    less(run["opposite"], 1);
  }
  for (const auto& packet : table("inertia").where("s", 0, 3)) {
    less(0, packet["mass"]);
    less(packet["envelope_mass"], 0);
  }

  // The measure can fail: the sum of the velocities does not follow the speed; and the balance closes
  control([&] {
    for (const char* name : runs) less(abs(momenta.at("run", name)["beads"]), 0.1);
    for (const auto& row : table("balance").where("t", 298)) less(abs(row["residual"]), 0.01);
  });
}

STATEMENT("turning.slowing") {
  // Isolated packets: less energy than the breather of their action, by the kinetic energy of a negative inertia
  for (const auto& packet : table("deficits").where("s", 0, 1)) {
    near(packet["deficit"], packet["kinetic"], packet["kinetic"] * 0.2);
    within(packet["emitted"], 0.85, 1.1);
    less(packet["emitted"] + 0.3, packet["frequency"]);
  }

  // Packets that turn: both ways
  for (const auto& packet : table("exchange").where("velocity", 1.86, 1.94)) {
    less(packet["lost"], 0);
    within(packet["out"], 0.9, 1.1);
    less(0, packet["gained"]);
    within(packet["back"], 0.9, 1.1);
    less(packet["out"] + 0.3, packet["frequency"]);

    // The inner sites too, and by enough for their motion
    less(0, packet["core_gained"]);
    less(packet["kinetic"], (packet["frequency"] - 1) * -packet["core_lost"]);
  }
}

STATEMENT("turning.return") {
  // Wiped once, all return; without the end, fewer
  const Data fates = table("fates");
  for (const char* all : {"nothing", "wiped at 100", "wiped at 200"})
    less(8, fates.at("taken", all)["least"]);
  for (const char* few : {"absorbed at the end", "isolated at 100", "isolated at 200"})
    less(fates.at("taken", few)["most"], 6);

  // Isolated late, they stop where they would have turned
  near(fates.at("taken", "isolated at 200")["furthest"], fates.at("taken", "nothing")["furthest"],
       2);
}

STATEMENT("turning.pull") {
  // The harder the well, the more is blocked and the stronger is the pull
  const Data beside = table("beside");
  for (const auto& [soft, harder] : {std::pair{0.3, 0.6}, {0.6, 1.0}}) {
    less(beside.at("s", soft)["pull"], beside.at("s", harder)["pull"]);
    less(beside.at("s", harder)["passed"], beside.at("s", soft)["passed"]);
  }
  less(0, beside.at("s", 0)["pull"]);
  less(8 * beside.at("s", 0)["pull"], beside.at("s", 1)["pull"]);
  less(beside.at("s", 1)["passed"], 0.5);

  // Uphill
  for (const auto& trial : table("hill").where("s", 0, 1)) {
    if (trial("slope") > 0)
      less(1, trial["moved"]);
    else
      less(trial["moved"], -1);
  }
}

STATEMENT("turning.waves") {
  // Without the waves behind it each of four packets goes at least twice as far as with them, and is not back
  const Data range = table("range_of_waves");
  for (const auto& [s, velocity] : {std::pair{1.0, 1.9}, {0.8, 2.2}, {1.0, 1.7}, {0.6, 2.5}}) {
    const Data packet = range.where("s", s).where("velocity", velocity);
    const auto without = packet.at("behind", 6);
    less(2 * packet.at("behind", 0)["furthest"], without["furthest"]);
    for (const char* fate : {"fate", "fate_coarse"}) less(without[fate], 0.5);

    // Beyond 20 sites they do not matter to the packets that turn early, and do to the others
    const auto all = packet.at("behind", 0)["furthest"],
               near_by = packet.at("behind", 20)["furthest"];
    if (velocity == 1.9 || velocity == 2.2)
      near(near_by, all, 0.1);
    else
      less(all + 3, near_by);
  }
}
