// A defect: a packet meets beads of another radius, and its energy is divided.
(() => {
  "use strict";
  const { Panel, drawMap } = Live;

  Live.kinds.defect = class extends Panel {
    verb() { return "Strike"; }
    fields() {
      return [["radius", "radius of the defect's beads over the others'", 1.6, 0.3, 3, "R₁₀₀/R"], ["velocity", "impact velocity in m/s", 1, 0.01, 10, "V"]];
    }
    request() { return [this.ask.radius, this.ask.velocity, 300]; }
    commands() { return `build/bin/sec36_cantilever_defect run --ratio ${this.ask.radius} --velocity ${this.ask.velocity}`; }

    progress(t) { this.say(t < 74.9 ? `computing: ${t.toFixed(0)} of 75 ms` : "the map is drawn; computing the fractions at two steps …"); }

    report() {
      this.say(`computed in ${this.seconds.toFixed(2)} s; the errors are the differences of two runs with steps 0.1 and 0.05 of the time scale`);
      this.fact("net_reflected", "reflected fraction of the arriving energy");
      this.fact("net_near", "fraction of the arriving energy near the defect");
      this.fact("net_transmitted", "transmitted fraction of the arriving energy");
      this.fact("reflected", "fraction of the total energy before the defect");
      this.fact("near", "fraction of the total energy near the defect");
      this.fact("transmitted", "fraction of the total energy behind the defect");
      this.fact("budget", "sum of the fractions less one");
    }

    draw() {
      if (this.rows?.length) drawMap(this.map, this.rows, [0, 75], "contact n", "time t (ms)", "Map of the contact forces in newtons", "contact force in newtons");
    }
  };
})();
