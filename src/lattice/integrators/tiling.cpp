#include "lattice/integrators/tiling.hpp"

#include <algorithm>
#include <barrier>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

#include "lattice/model/typed.hpp"

namespace lattice {
namespace {

/**
Threads share the chain in the same spirit. Many stages done together are called a pass. Each thread
copies its part of the chain into memory of its own, together with as many sites on either side as a pass
has stages. The outermost of these *ghosts* lack a neighbour, so they are wrong after one stage. The error
creeps inwards by one site per stage and is about to reach the part when the pass ends; then the threads
exchange the sites near the edges of their parts and go on.

There are no ghosts beyond an end of the chain, where the boundary condition holds. On a ring they come
from the other side, even if there is only one part. */
struct Strip {
  std::size_t first = 0, last = 0;    ///< sites that belong to the thread
  std::size_t before = 0, after = 0;  ///< ghosts on either side
  bool begins = false, ends = false;  ///< whether an end of an open chain belongs to it
  std::size_t size() const { return before + (last - first) + after; }
};

/// Part `k` of `count`, with `depth` ghosts. The caller sees to it that no part has fewer sites than
/// ghosts (`Tiled::parts_of`).
Strip part_of(std::size_t sites, bool ring, std::size_t k, std::size_t count, std::size_t depth) {
  Strip part{sites * k / count, sites * (k + 1) / count};
  part.begins = k == 0 && !ring;
  part.ends = k + 1 == count && !ring;
  part.before = part.begins ? 0 : depth;
  part.after = part.ends ? 0 : depth;
  return part;
}

/**
A tile is a part of the chain together with its copies. The state itself serves as the board on which
threads leave the sites near their edges for each other; it is complete again after `store`. */
template <class T>
class Tile {
 public:
  Tile(const Chain& chain, const Strip& part, std::size_t depth)
      : chain_(chain),
        move_(detail::bare_kick_drifter<T>(chain)),
        part_(part),
        left_(depth),
        room_(std::make_unique_for_overwrite<T[]>(2 * stride() + line)) {
    y_ = room_.get();
    while (reinterpret_cast<std::uintptr_t>(y_) % (line * sizeof(double)) != 0) ++y_;
    v_ = y_ + stride();
    for (std::size_t i = 0; i < part.size() && !chain.mass.empty(); ++i) {
      mass_.push_back(chain.mass[site(i)]);
      inverse_mass_.push_back(chain.inverse_mass[site(i)]);
    }
    for (std::size_t i = 0; i < part.size() && !chain.eta.empty(); ++i)
      eta_.push_back(chain.eta_of(site(i)));
    if (!chain.eta.empty()) eta_.push_back(chain.eta[site(part.size() - 1) + 1]);
  }

  Tile(const Tile&) = delete;
  Tile& operator=(const Tile&) = delete;

  /**
  A thread reads its part once and writes it once; in between it passes on only what its neighbours need.
  Ghosts are read before a pass, and the sites that are ghosts elsewhere are written after it: `depth` of
  them, as many as the stages of a pass can spoil. */
  void load(const State<T>& state) { read(state, 0, part_.size()); }
  void store(State<T>& state) const { write(state, part_.first, part_.last); }

  void refresh(const State<T>& state) {
    read(state, 0, part_.before);
    read(state, part_.size() - part_.after, part_.size());
  }
  void publish(State<T>& state, std::size_t depth) const {
    if (part_.before > 0) write(state, part_.first, part_.first + depth);
    if (part_.after > 0) write(state, part_.last - depth, part_.last);
  }

  /// Carries the part through the stages of one pass, block by block.
  void pass(const std::vector<Stage<T>>& stages, std::size_t block);

 private:
  /**
  The placing of the copies in memory decides the speed. A cache line holds eight numbers, and positions
  begin with one. Velocities begin half a page of 4 kB further on: a processor first compares only the
  place of an address in its page, and waits where a read and a write agree in it. */
  static constexpr std::size_t line = 8, page = 512;
  std::size_t stride() const { return (part_.size() / page + 1) * page + page / 2; }

  /// The site of the chain that is kept at place `i`.
  std::size_t site(std::size_t i) const {
    return (part_.first + chain_.sites - part_.before + i) % chain_.sites;
  }
  void read(const State<T>& state, std::size_t from, std::size_t to) {
    for (std::size_t i = from, n = site(from); i < to; ++i, n = n + 1 < chain_.sites ? n + 1 : 0)
      y_[i] = state.y[n], v_[i] = state.v[n];
  }
  void write(State<T>& state, std::size_t from, std::size_t to) const {
    for (std::size_t n = from, i = part_.before + from - part_.first; n < to; ++n, ++i)
      state.y[n] = y_[i], state.v[n] = v_[i];
  }
  /**
  A part is swept like a chain, so it must say what its ends are. A cut is a free end; so are both ends of
  a part of a ring, whose ghosts come from around it. */
  Boundary boundary() const {
    const auto end = [&](bool real) { return real ? chain_.ends : Ends::free; };
    return {part_.size(), end(part_.begins), end(part_.ends)};
  }
  T push(std::size_t i) const;
  void sweep(std::size_t from, std::size_t to, T left, T right, const Stage<T>& stage);

  const Chain& chain_;
  detail::BareKickDrift<T> move_;
  Strip part_;
  std::vector<T> left_;  ///< for every stage the contact at the edge where the last block stopped
  std::unique_ptr<T[]> room_;
  T *y_, *v_;  ///< in `room_`
  std::vector<double> eta_{}, mass_{}, inverse_mass_{};
};

/**
The sweep needs the pushes at its edges. Here is that of the contact to the left of place `i`. Beyond the
outermost ghost there is nothing, and the error that this makes stays among the ghosts. */
template <class T>
T Tile<T>::push(std::size_t i) const {
  const Boundary here = boundary();
  if (!here.pushes(i)) return T(0);
  return (eta_.empty() ? T(1) : T(eta_[i])) * chain_.contact.force(here.stretch(y_, i));
}

template <class T>
void Tile<T>::sweep(std::size_t from, std::size_t to, T left, T right, const Stage<T>& stage) {
  T *y = y_ + from, *v = v_ + from;
  const auto at = [&](const std::vector<double>& all) {
    return all.empty() ? nullptr : all.data() + from;
  };
  move_(chain_, y, v, {at(eta_), at(mass_), at(inverse_mass_)}, to - from, left, right, stage.kick,
        stage.drift);
}

/**
Now the stages of a pass. A shift of one site per stage would do; with eight, the vectors of all stages
begin at the same place in a cache line. The last block reaches the end of the part in every stage. */
constexpr std::size_t tile_shift = 8;

template <class T>
void Tile<T>::pass(const std::vector<Stage<T>>& stages, std::size_t block) {
  const std::size_t count = part_.size(), reach = tile_shift * stages.size();
  const auto edge = [](std::size_t at, std::size_t shift) { return at > shift ? at - shift : 0; };
  for (std::size_t lo = 0, hi = 0; hi < count; lo = hi) {
    hi = count - lo > block + reach ? lo + block : count;
    for (std::size_t s = 0; s < stages.size(); ++s) {
      const std::size_t from = edge(lo, tile_shift * s);
      const std::size_t to = hi < count ? edge(hi, tile_shift * s) : count;
      if (from == to) continue;
      const T left = from > 0 ? left_[s] : push(0);
      left_[s] = push(to);
      sweep(from, to, left, left_[s], stages[s]);
    }
  }
}

/**
Starting a thread and filling its copies takes time, so each gets at least `least` sites, and never
fewer than it has ghosts. */
std::size_t parts_of(const Tiled& how, std::size_t sites) {
  const std::size_t most = sites / std::max(how.least, how.depth);
  return std::max<std::size_t>(1, std::min(how.threads, most));
}

/**
All threads make the same passes and wait for each other twice in each: none may write the sites near
its edges before all have read them, and none may read them before all have written. After the last pass
each thread writes its whole part, and ghosts are no longer needed. */

/// Carries one tile through the stages `first <= k < last`.
template <class T, class StageAt, class Barrier>
void carry(const Tiled& how, Tile<T>& tile, State<T>& state, std::size_t first, std::size_t last,
           const StageAt& stage, Barrier& meet) {
  tile.load(state);
  std::vector<Stage<T>> pass;
  for (std::size_t next = first; next < last;) {
    for (pass.clear(); next < last && pass.size() < how.depth; ++next) pass.push_back(stage(next));
    meet.arrive_and_wait();  // everybody has read
    tile.pass(pass, how.block);
    if (next == last) break;
    tile.publish(state, how.depth);
    meet.arrive_and_wait();  // everybody has written
    tile.refresh(state);
  }
  tile.store(state);
}

/**
The parts are of equal length, so that no thread waits long for the others. The caller's own thread takes
the first one; a chain of one part needs no other. */
template <class T, class StageAt>
void share(const Tiled& how, const Chain& chain, State<T>& state, std::size_t first,
           std::size_t last, StageAt stage) {
  const std::size_t parts = parts_of(how, chain.sites);
  const bool ring = chain.ends == Ends::periodic;
  std::barrier meet{std::ptrdiff_t(parts)};
  const auto work = [&](std::size_t k) {
    Tile<T> tile(chain, part_of(chain.sites, ring, k, parts, how.depth), how.depth);
    carry(how, tile, state, first, last, stage, meet);
  };
  std::vector<std::jthread> others;
  for (std::size_t k = 1; k < parts; ++k) others.emplace_back(work, k);
  work(0);
}

}  // namespace

template <class T>
double Tiled::advance(const Chain& chain, State<T>& state, Window& window, double h,
                      std::size_t count) const {
  const std::size_t stages = stage_count(scheme, count);
  const bool fit = chain.sites >= std::max({least, depth, std::size_t(2)});
  const auto move = detail::plain_kick_drifter<T>(chain);
  double work = 0;
  std::size_t k = 0;
  for (; k < stages && !(fit && window == Window{0, chain.sites}); ++k) {
    const Stage<T> stage = stage_at<T>(scheme, h, count, k);
    move(chain, state, window, stage.kick, stage.drift, {});
    work += double(window.last - window.first);
  }
  const auto stage = [&](std::size_t i) { return stage_at<T>(scheme, h, count, i); };
  if (k < stages) share(*this, chain, state, k, stages, stage);
  return work + double(stages - k) * double(chain.sites);
}

template double Tiled::advance<double>(const Chain&, State<double>&, Window&, double,
                                       std::size_t) const;
template double Tiled::advance<long double>(const Chain&, State<long double>&, Window&, double,
                                            std::size_t) const;

}  // namespace lattice
