// A driven end: nothing below a threshold, breathers above it.
(() => {
  "use strict";
  const { Panel, drawMap } = Live;

  Live.kinds.drive = class extends Panel {
    verb() { return "Drive"; }
    fields() {
      return [["frequency", "drive frequency in Hz", 7000, 500, 20000, "f"], ["amplitude", "drive amplitude in micrometres", 5, 0, 200, "a"],
        ["lifetime", "lifetime of the energy of a beam in ms", 10, 0.5, 1e6, "τ"], ["time", "duration in ms", 60, 20, 500, "t"]];
    }
    choices() { return [["by", "what is driven", [["piston", "a piston that touches the first bead"], ["base", "the base of the first beam"]]]]; }
    request() { return [this.ask.frequency, this.ask.amplitude, this.ask.by === "base" ? 1 : 0, this.ask.lifetime, this.ask.time, 300]; }
    commands() {
      const a = this.ask;
      return `build/bin/sec5_experiment drive --frequency ${a.frequency} --amplitude ${a.amplitude} --by ${a.by} --lifetime ${a.lifetime} --time ${a.time}`;
    }

    progress(t) {
      const { time } = this.ask;
      this.say(t < 0.995 * time ? `computing: ${t.toFixed(0)} of ${time} ms` : "the map is drawn; computing the emission at two steps …");
    }

    report() {
      const f = this.facts, law = f.threshold_law;
      const result = f.outcome.value ? "the array emits breathers" : "nothing passes bead 20";
      this.say(`${result}; computed in ${this.seconds.toFixed(2)} s; the errors are the differences of two runs with steps 0.04 and 0.02 of the time scale`);
      this.fact("outcome", "whether packets pass bead 20", "", f.outcome.value ? "yes" : "no");
      this.fact("emitted_per_second", "packets that pass bead 20", "1/s");
      this.fact("power", "mean power of the drive in the second half", "W");
      this.fact("response", "largest displacement of the first bead in the second half", "µm");
      this.fact("budget", "energy plus losses minus work, relative");
      if (law) this.fact("threshold_law", "asymptotic threshold of the DpS limit, with the error of the limit", "µm");
    }

    draw() {
      if (this.rows?.length) drawMap(this.map, this.rows, [0, this.ask.time], "bead n", "time t (ms)", "Map of the energy of the beads in joules", "energy of a bead in joules");
    }
  };
})();
