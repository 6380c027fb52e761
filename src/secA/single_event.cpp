#include "secA/single_event.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lattice/events/event_driven.hpp"

namespace lattice {
namespace {

Chain two_beads() {
  Chain chain{2, Quartic{1}};
  vary(chain, {1, 4}, {});
  return chain;
}

// From the event back to the start, turned round and rounded, then forward
Passage passage(const Event& event, double before) {
  const Chain chain = two_beads();
  State<long double> state(2);
  state.y = {0.7 + event.overlap, 0.7};
  state.v = {-event.rate, 0};
  flow(chain, state, before);
  Passage out;
  for (std::size_t n = 0; n < 2; ++n) {
    state.y[n] = out.start.y[n] = double(state.y[n]);
    state.v[n] = out.start.v[n] = -double(state.v[n]);
  }
  state.t = 0;
  flow(chain, state, 1);
  for (const long double y : state.y) out.end.push_back(double(y));
  return out;
}

}  // namespace

// The golden ratio spreads the starts
std::vector<Passage> passages_of(const Event& event, int count) {
  std::vector<Passage> out;
  for (int k = 0; k < count; ++k)
    out.push_back(passage(event, 0.4 + 0.2 * std::fmod(k * std::numbers::phi, 1)));
  return out;
}

double passage_error(const EventCorrected& method, const std::vector<Passage>& passages) {
  double squares = 0;
  for (const Passage& passage : passages) {
    State<double> state = passage.start;
    evolve(method, two_beads(), state, 1, 1);
    double largest = 0;
    for (std::size_t n = 0; n < 2; ++n)
      largest = std::max(largest, std::abs(state.y[n] - passage.end[n]));
    squares += largest * largest;
  }
  return std::sqrt(squares / double(passages.size()));
}

}  // namespace lattice
