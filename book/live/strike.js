// Strike the chain: a map that grows while it is computed, and the velocities at the end.
(() => {
  "use strict";
  const { Panel, Plot, drawMap } = Live;

  Live.kinds.strike = class extends Panel {
    verb() { return "Strike"; }
    fields() {
      return [["velocity", "impact velocity", 1.87, 1e-6, 100, "v₀"], ["s", "anharmonicity", -1 / 6, -10, 10, "s"],
        ["precompression", "precompression", 0, 0, 100, "d"], ["time", "time", 587, 1, 5000, "t"], ["sites", "number of beads", 160, 2, 1500, "N"]];
    }
    choices() {
      return [["well", "well", Object.keys(Live.wells).map((name) => [name, name]), "quartic"],
        ["show", "the map shows", [["density", "energy density"], ["force", "contact force"]]]];
    }

    hasS() { return Live.wells[this.ask.well].includes("s"); }

    request() {
      const a = this.ask;
      return [a.velocity, Object.keys(Live.wells).indexOf(a.well), a.s, a.precompression, a.time, a.sites, 1e-4, a.show === "force" ? 1 : 0, 420];
    }

    commands() {
      const a = this.ask;
      return `build/bin/sec34_impact run --velocity ${a.velocity} --time ${a.time} --sites ${a.sites}`
        + ` --well ${a.well}` + (this.hasS() ? ` --s ${a.s}` : "") + (a.precompression ? ` --precompression ${a.precompression}` : "");
    }

    canvases() { return ["map", "profile"]; }

    begin() { this.inputs.s.disabled = !this.hasS(); }

    progress(t) {
      this.say(`computing with step 0.2${this.level ? `/${2 ** this.level}` : ""}: t = ${t.toFixed(0)} of ${this.ask.time}`);
    }

    report() {
      this.say(`computed in ${this.seconds.toFixed(2)} s; two runs, the finer with step 0.2/${2 ** this.level}, agree to 10⁻⁴`);
      this.fact("speed", "speed of the foremost packet beyond site 20", "sites per unit of time");
      this.fact("centre", "position of the foremost packet at the end", "(site)");
      this.fact("peak_energy_density", "largest maximum of the packet's energy density");
      this.fact("packet_energy_fraction", "fraction of the energy in the foremost packet");
      this.fact("boundary_energy_fraction", "fraction that stays on the first five beads");
      this.fact("energy_drift", "relative drift of the energy");
    }

    draw() {
      if (!this.rows?.length) return;
      const { sites, time } = this.ask, force = this.ask.show === "force", rows = this.rows;
      drawMap(this.map, rows, [0, time], force ? "contact n" : "site n", "time t", `Map of the ${force ? "contact force" : "energy density"}`,
        `${force ? "contact force" : "energy density"} (dimensionless)`);
      const v = this.lists.v || [], most = 1.05 * v.reduce((m, x) => Math.max(m, Math.abs(x)), 0) || 1;
      const profile = new Plot(this.profile, 170, [0.5, sites + 0.5], [-most, most]);
      if (!v.length) return;
      profile.line([...v].map((x, n) => [n + 1, x]));
      profile.axes(`site n, at t = ${time}`, "velocity");
      this.profile.setAttribute("aria-label", "Velocities of all beads at the end");
    }
  };
})();
