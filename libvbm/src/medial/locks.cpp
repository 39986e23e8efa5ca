// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis looks for loops in a graph of parts. Here a part P goes if and only if its cells
// collapse onto those it shares with the rest, C. That can be counted:
//   - P has a border, so free edges take all its triangles along, one after another; what is left
//     of it is a graph, and H2(P, C) = 0.
//   - P hangs together and touches C, so H0(P, C) = 0.
//   - Then Euler's number of the cells that P has to itself is -dim H1(P, C). If that is 0, the
//     graph is trees that each hang on C by one vertex, and their ends take their edges along.
// What a locked part holds together is seen in the graph of parts and contact nodes: without P it
// falls into some number of pieces more, found for all parts in one depth-first search (Hopcroft
// and Tarjan, "Efficient algorithms for graph manipulation", 1973). If that is all that H1(P, C) is
// for, P is a bridge; otherwise a tunnel goes through it or ends at it.
#include "medial/locks.h"

#include "medial/cell_lists.h"

#include <algorithm>

namespace vbm::impl {
namespace {

/// For every part how many pieces more there are without it.
class Pieces {
public:
  explicit Pieces(const Incidence &part_nodes, std::size_t nodes)
      : parts_(int32_t(part_nodes.offset.size() - 1)), part_nodes_(part_nodes),
        node_parts_(lists_of(nodes, part_nodes)) {}

  std::vector<int32_t> run(std::size_t &pieces) {
    const std::size_t count = std::size_t(parts_) + node_parts_.offset.size() - 1;
    entered_.assign(count, 0);
    low_.assign(count, 0);
    more_.assign(count, 0);
    pieces = 0;
    for (int32_t p = 0; p < parts_; ++p) {
      if (entered_[p]) continue;
      ++pieces;
      search(p);
      --more_[p]; // the first piece below the root is what there was
    }
    more_.resize(parts_);
    return std::move(more_);
  }

private:
  struct Step {
    int32_t at, from;
    uint64_t next; // of the neighbours of `at`
  };

  const int32_t *neighbors(int32_t i, uint64_t &count) const {
    const Incidence &lists = i < parts_ ? part_nodes_ : node_parts_;
    const int32_t k = i < parts_ ? i : i - parts_;
    count = lists.offset[k + 1] - lists.offset[k];
    return lists.index.data() + lists.offset[k];
  }

  void enter(int32_t i, int32_t from) {
    entered_[i] = low_[i] = ++time_;
    path_.push_back({i, from, 0});
  }

  void search(int32_t root) {
    enter(root, -1);
    while (!path_.empty()) {
      Step &step = path_.back();
      uint64_t count;
      const int32_t *near = neighbors(step.at, count);
      if (step.next < count) {
        const int32_t next = near[step.next++] + (step.at < parts_ ? parts_ : 0);
        if (next == step.from) continue;
        if (entered_[next])
          low_[step.at] = std::min(low_[step.at], entered_[next]);
        else
          enter(next, step.at);
        continue;
      }
      const Step done = step;
      path_.pop_back();
      if (done.from < 0) continue;
      low_[done.from] = std::min(low_[done.from], low_[done.at]);
      if (low_[done.at] >= entered_[done.from]) ++more_[done.from];
    }
  }

  int32_t parts_;
  const Incidence &part_nodes_;
  Incidence node_parts_;
  std::vector<int32_t> entered_, low_, more_; // parts, then nodes
  std::vector<Step> path_;
  int32_t time_ = 0;
};

} // namespace

std::size_t find_locks(const TopologyGraph &graph, AxisParts &parts) {
  std::size_t pieces = 0;
  const std::vector<int32_t> more = Pieces(graph.part_nodes, graph.node.size()).run(pieces);
  for (std::size_t p = 0; p < parts.list.size(); ++p) {
    const bool touches = graph.part_nodes.offset[p + 1] > graph.part_nodes.offset[p];
    const int32_t euler = parts.euler[p];
    int32_t &lock = parts.list[p].lock;
    if (parts.list[p].level > 1)
      lock = VBM_LOCK_INNER;
    else if (parts.list[p].level == 0) // nothing near has a border
      lock = VBM_LOCK_TUNNEL;
    else if (!touches)
      lock = euler == 1 ? VBM_LOCK_LAST : VBM_LOCK_TUNNEL;
    else if (may_go(euler, touches))
      lock = VBM_LOCK_NONE;
    else
      lock = more[p] == -euler ? VBM_LOCK_BRIDGE : VBM_LOCK_TUNNEL;
  }
  return pieces;
}

} // namespace vbm::impl
