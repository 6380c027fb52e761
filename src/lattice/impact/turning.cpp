#include "lattice/impact/turning.hpp"

namespace lattice {

// Follow the packet to its first stop, out to the apex, and back to where it rebounds. It has turned once it has come back
// by `back` sites, which is more than it moves to and fro while it is caught between two sites, and rebounded once it then
// moves out by `again` sites. The first stop is sought beyond site `clear`, where the packet has left the end
Turn find_turn(const Path& path) {
  constexpr double back = 5, again = 3, clear = 8;
  Turn turn;
  std::size_t far = 0, near = 0;
  bool turned = false;
  const std::vector<double> x = path.all(&PathSample::centre);
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (!turn.stop.found() && x[i - 1] > clear && x[i] < x[i - 1]) turn.stop = vertex(path, i - 1);
    // On the way out it is caught and released, so only a retreat by `back` sites makes an apex
    if (!turned) {
      if (x[i] > x[far]) far = i;
      turned = x[i] < x[far] - back;
      near = i;
      if (turned) turn.apex = vertex(path, far);
    } else if (x[i] < x[near]) {
      near = i;
    } else if (x[i] > x[near] + again) {
      turn.rebound = vertex(path, near);
      break;
    }
  }
  return turn;
}

Turn turn_of(const Path& path, double width) {
  return find_turn(smooth(path, width));
}

// Two errors for every turning point: from the step, and from the width of the smoothing
TurnEstimate estimate_turn(const Path& coarse, const Path& fine) {
  const Turn a = turn_of(coarse), b = turn_of(fine), c = turn_of(fine, path_smoothing / 2);
  const auto both = [&](auto of) {
    Estimate e = with_error(of(a), of(b));
    e.error += std::abs(of(c) - of(b));
    return e;
  };
  return {both([](const Turn& t) { return t.stop.time; }),
          both([](const Turn& t) { return t.stop.site; }),
          both([](const Turn& t) { return t.apex.time; }),
          both([](const Turn& t) { return t.apex.site; }),
          both([](const Turn& t) { return t.rebound.time; }),
          both([](const Turn& t) { return t.rebound.site; })};
}

}  // namespace lattice
