// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 7.5.1. It differs in that growth needs no seeds in a random order: parts are the connected
// pieces across edges of two triangles whatever they begin with, and their level is found
// afterwards, breadth first. Axes may have curves, too, where a shape is a tube: those are parts
// without triangles.
#include "medial/axis_parts.h"

#include "core/progress.h"
#include "medial/cell_lists.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

class Finder {
public:
  Finder(const AxisCells &cells, const AxisState &state, Progress &progress)
      : cells_(cells), state_(state), progress_(progress) {}

  AxisParts run() {
    count();
    grow_sheets();
    grow_curves();
    settle();
    find_contacts();
    find_levels();
    measure();
    return std::move(out_);
  }

private:
  static constexpr int32_t kNothing = AxisParts::kNothing, kContact = AxisParts::kContact;
  static constexpr int32_t kSeam = 1 << 30; // added to `count`: never 2, then

  /// Of the triangles left at an edge: how many, the sum of their numbers (so that of two, each
  /// knows the other), and their part.
  struct Use {
    int32_t count = 0;
    uint32_t sum = 0;
    int32_t part = kNothing;
  };

  void count() {
    use_.resize(cells_.edge.size());
    for (std::size_t e = 0; e < use_.size(); ++e)
      if (cells_.seam[e]) use_[e].count = kSeam;
    for (std::size_t t = 0; t < cells_.triangle.size(); ++t) {
      progress_.tick(0, 1);
      if (!state_.triangle[t]) continue;
      for (int32_t e : cells_.triangle_edges[t]) {
        ++use_[e].count;
        use_[e].sum += uint32_t(t);
      }
    }
  }

  int32_t triangles_at(int32_t e) const { return use_[e].count & ~kSeam; }
  bool is_curve(int32_t e) const { return state_.edge[e] && triangles_at(e) == 0; }

  int32_t new_part() {
    out_.list.push_back(vbm_part{});
    return int32_t(out_.list.size()) - 1;
  }

  static void join(int32_t &at, int32_t part) {
    if (at == kNothing)
      at = part;
    else if (at != part)
      at = kContact;
  }

  void grow_sheets() {
    out_.of_triangle.assign(cells_.triangle.size(), kNothing);
    std::vector<int32_t> &list =
        out_.triangles.index; // of a part: its triangles, as they are found
    for (int32_t first = 0; first < int32_t(cells_.triangle.size()); ++first) {
      if (!state_.triangle[first] || out_.of_triangle[first] >= 0) continue;
      const int32_t part = new_part();
      out_.of_triangle[first] = part;
      list.push_back(first);
      for (std::size_t i = out_.triangles.offset.back(); i < list.size(); ++i) {
        progress_.tick(0, 1);
        const int32_t t = list[i];
        for (int32_t e : cells_.triangle_edges[t]) {
          Use &use = use_[e];
          join(use.part, part);
          if (triangles_at(e) == 1) out_.list[part].level = 1; // a border, seam or not
          if (use.count != 2) continue;
          const auto next = int32_t(use.sum - uint32_t(t));
          if (out_.of_triangle[next] >= 0) continue;
          out_.of_triangle[next] = part;
          list.push_back(next);
        }
      }
      out_.triangles.offset.push_back(list.size());
    }
  }

  void grow_curves() {
    const auto edges = int32_t(cells_.edge.size());
    out_.curve_edges.offset.assign(out_.list.size() + 1, 0);
    int32_t first = 0;
    while (first < edges && !is_curve(first)) ++first;
    if (first == edges) return;
    std::vector<int32_t> edges_at(cells_.ball.size(), 0);
    for (std::size_t e = 0; e < cells_.edge.size(); ++e)
      if (state_.edge[e])
        for (int32_t v : cells_.edge[e]) ++edges_at[v];
    std::vector<int32_t> &list = out_.curve_edges.index;
    for (; first < edges; ++first) {
      if (!is_curve(first) || use_[first].part >= 0) continue;
      const int32_t part = new_part();
      use_[first].part = part;
      list.push_back(first);
      for (std::size_t i = out_.curve_edges.offset.back(); i < list.size(); ++i) {
        progress_.tick(0, 1);
        for (int32_t v : cells_.edge[list[i]]) {
          if (edges_at[v] == 1) out_.list[part].level = 1;
          if (edges_at[v] != 2) continue;
          for (uint64_t k = cells_.vertex_edges.offset[v]; k < cells_.vertex_edges.offset[v + 1];
               ++k) {
            const int32_t next = cells_.vertex_edges.index[k];
            if (!is_curve(next) || use_[next].part >= 0) continue;
            use_[next].part = part;
            list.push_back(next);
          }
        }
      }
      out_.curve_edges.offset.push_back(list.size());
      out_.triangles.offset.push_back(out_.triangles.index.size());
    }
  }

  /// What each edge and vertex belongs to, and how many each part has to itself.
  void settle() {
    out_.euler.assign(out_.list.size(), 0);
    out_.of_edge.resize(cells_.edge.size());
    out_.of_vertex.assign(cells_.ball.size(), kNothing);
    for (std::size_t e = 0; e < cells_.edge.size(); ++e) {
      progress_.tick(0, 1);
      const int32_t part = out_.of_edge[e] = use_[e].part;
      if (part == kNothing) continue;
      if (part >= 0) --out_.euler[part];
      for (int32_t v : cells_.edge[e]) join(out_.of_vertex[v], part);
    }
    for (int32_t part : out_.of_vertex)
      if (part >= 0) ++out_.euler[part];
    for (std::size_t p = 0; p < out_.list.size(); ++p) {
      out_.list[p].triangles = out_.triangles.offset[p + 1] - out_.triangles.offset[p];
      out_.list[p].curve_edges = out_.curve_edges.offset[p + 1] - out_.curve_edges.offset[p];
      out_.euler[p] += int32_t(out_.list[p].triangles);
    }
  }

  /// Where parts are neighbours: edges, and vertices where one of them is a curve.
  void find_contacts() {
    std::vector<int32_t> here;
    const auto triangles_of = [&](int32_t e) {
      for (uint64_t k = cells_.edge_triangles.offset[e]; k < cells_.edge_triangles.offset[e + 1];
           ++k)
        if (state_.triangle[cells_.edge_triangles.index[k]])
          here.push_back(out_.of_triangle[cells_.edge_triangles.index[k]]);
    };
    const auto enter = [&] {
      std::sort(here.begin(), here.end());
      here.erase(std::unique(here.begin(), here.end()), here.end());
      contact_.index.insert(contact_.index.end(), here.begin(), here.end());
      contact_.offset.push_back(contact_.index.size());
      here.clear();
    };
    for (int32_t e = 0; e < int32_t(cells_.edge.size()); ++e) {
      if (out_.of_edge[e] != kContact) continue;
      triangles_of(e);
      enter();
    }
    std::vector<int32_t> ends;
    for (int32_t e : out_.curve_edges.index)
      for (int32_t v : cells_.edge[e])
        if (out_.of_vertex[v] == kContact) ends.push_back(v);
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (int32_t v : ends) {
      for (uint64_t k = cells_.vertex_edges.offset[v]; k < cells_.vertex_edges.offset[v + 1]; ++k) {
        const int32_t e = cells_.vertex_edges.index[k];
        if (out_.of_edge[e] >= 0)
          here.push_back(out_.of_edge[e]);
        else if (out_.of_edge[e] == kContact)
          triangles_of(e);
      }
      enter();
    }
  }

  void find_levels() {
    const Incidence contacts_of = lists_of(out_.list.size(), contact_);
    std::vector<uint8_t> passed(contact_.offset.size() - 1, 0);
    std::vector<int32_t> todo;
    for (std::size_t p = 0; p < out_.list.size(); ++p)
      if (out_.list[p].level == 1) todo.push_back(int32_t(p));
    for (std::size_t i = 0; i < todo.size(); ++i) {
      const int32_t p = todo[i];
      for (uint64_t k = contacts_of.offset[p]; k < contacts_of.offset[p + 1]; ++k) {
        const int32_t contact = contacts_of.index[k];
        if (passed[contact]) continue;
        passed[contact] = 1;
        for (uint64_t j = contact_.offset[contact]; j < contact_.offset[contact + 1]; ++j) {
          vbm_part &near = out_.list[contact_.index[j]];
          if (near.level) continue;
          near.level = out_.list[p].level + 1;
          todo.push_back(contact_.index[j]);
        }
      }
    }
  }

  void measure() {
    const std::size_t count = out_.list.size();
    std::vector<Vec3> sum(count), plain(count); // of middles, by size and as they are
    std::vector<double> sine(count, 0);         // of half the angle
    for (std::size_t t = 0; t < cells_.triangle.size(); ++t) {
      progress_.tick(0, 1);
      const int32_t p = out_.of_triangle[t];
      if (p < 0) continue;
      const auto &v = cells_.triangle[t];
      const Ball &a = cells_.ball[v[0]], &b = cells_.ball[v[1]], &c = cells_.ball[v[2]];
      const double area = length(cross(b.center - a.center, c.center - a.center)) / 2;
      const Vec3 middle = a.center + b.center + c.center;
      out_.list[p].area += area;
      sum[p] += middle * (area / 3);
      plain[p] += middle * (1.0 / 3);
      out_.list[p].width = std::max(out_.list[p].width, cells_.width[t]);
      sine[p] = std::max(sine[p], 1.5 * cells_.width[t] / (a.radius + b.radius + c.radius));
    }
    for (std::size_t p = 0; p < count; ++p)
      for (uint64_t k = out_.curve_edges.offset[p]; k < out_.curve_edges.offset[p + 1]; ++k) {
        const int32_t e = out_.curve_edges.index[k];
        const Ball &a = cells_.ball[cells_.edge[e][0]], &b = cells_.ball[cells_.edge[e][1]];
        const double size = distance(a.center, b.center);
        out_.list[p].length += size;
        sum[p] += (a.center + b.center) * (0.5 * size);
        plain[p] += (a.center + b.center) * 0.5;
        out_.list[p].width = std::max(out_.list[p].width, cells_.curve_width[e]);
        sine[p] = std::max(sine[p], cells_.curve_width[e] / (a.radius + b.radius));
      }
    for (std::size_t v = 0; v < cells_.ball.size(); ++v)
      if (out_.of_vertex[v] >= 0) out_.list[out_.of_vertex[v]].volume += cells_.volume[v];
    const double unit = cells_.unit, degrees = 360 / std::acos(-1.0);
    out_.middle.resize(count);
    for (std::size_t p = 0; p < count; ++p) {
      vbm_part &part = out_.list[p];
      const double size = part.area + part.length; // one of them is 0
      out_.middle[p] = size > 0 ? sum[p] * (1 / size)
                                : plain[p] * (1.0 / double(part.triangles + part.curve_edges));
      part.area *= unit * unit;
      part.length *= unit;
      part.width *= unit;
      part.angle = std::asin(std::min(1.0, sine[p])) * degrees;
    }
  }

  const AxisCells &cells_;
  const AxisState &state_;
  Progress &progress_;
  std::vector<Use> use_; // per edge
  Incidence contact_;    // per place of contact: the parts there
  AxisParts out_;
};

} // namespace

AxisState whole_axis(const AxisCells &cells) {
  AxisState state;
  state.triangle.assign(cells.triangle.size(), 1);
  state.edge.assign(cells.edge.size(), 1);
  state.vertex.assign(cells.ball.size(), 1);
  state.twig.assign(cells.twigs.size(), 1);
  return state;
}

std::vector<uint8_t> kept_balls(const AxisCells &cells, const AxisState &state) {
  std::vector<uint8_t> kept(cells.vertex_of_ball.size());
  for (std::size_t b = 0; b < kept.size(); ++b) {
    const int32_t v = cells.vertex_of_ball[b];
    kept[b] = state.twig[b] && (v < 0 || state.vertex[v]);
  }
  return kept;
}

AxisParts find_axis_parts(const AxisCells &cells, const AxisState &state, Progress &progress) {
  return Finder(cells, state, progress).run();
}

} // namespace vbm::impl
