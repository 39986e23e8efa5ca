// SPDX-License-Identifier: GPL-3.0-or-later
// Thesis 7.5.1. It differs in that growth needs no seeds in a random order: parts are the connected
// pieces across edges of two triangles whatever they begin with, and their level is found
// afterwards, breadth first. Axes may have curves, too, where a shape is a tube: those are parts
// without triangles.
#include "medial/axis_parts.h"

#include "core/progress.h"

#include <algorithm>
#include <cmath>

namespace vbm::impl {
namespace {

class Finder {
public:
  Finder(const AxisCells &cells, const AxisState &state, Progress &progress)
      : cells_(cells), state_(state), progress_(progress) {}

  AxisParts run() {
    out_.of_triangle.assign(cells_.triangle.size(), -1);
    out_.of_edge.assign(cells_.edge.size(), -1);
    count();
    grow_sheets();
    grow_curves();
    settle_vertices();
    find_levels();
    measure();
    return std::move(out_);
  }

private:
  void count() {
    triangles_at_.assign(cells_.edge.size(), 0);
    edges_at_.assign(cells_.ball.size(), 0);
    for (std::size_t t = 0; t < cells_.triangle.size(); ++t)
      if (state_.triangle[t])
        for (int32_t e : cells_.triangle_edges[t]) ++triangles_at_[e];
    for (std::size_t e = 0; e < cells_.edge.size(); ++e)
      if (state_.edge[e])
        for (int32_t v : cells_.edge[e]) ++edges_at_[v];
  }

  int32_t new_part() {
    vbm_part part{};
    out_.list.push_back(part);
    return int32_t(out_.list.size()) - 1;
  }

  void grow_sheets() {
    std::vector<int32_t> todo;
    for (int32_t first = 0; first < int32_t(cells_.triangle.size()); ++first) {
      progress_.tick(0, 1);
      if (!state_.triangle[first] || out_.of_triangle[first] >= 0) continue;
      const int32_t part = new_part();
      out_.of_triangle[first] = part;
      todo.push_back(first);
      while (!todo.empty()) {
        const int32_t t = todo.back();
        todo.pop_back();
        for (int32_t e : cells_.triangle_edges[t]) {
          if (triangles_at_[e] == 1) out_.list[part].level = 1;
          if (triangles_at_[e] != 2 || cells_.seam[e]) continue;
          for (uint64_t k = cells_.edge_triangles.offset[e];
               k < cells_.edge_triangles.offset[e + 1]; ++k) {
            const int32_t next = cells_.edge_triangles.index[k];
            if (!state_.triangle[next] || out_.of_triangle[next] >= 0) continue;
            out_.of_triangle[next] = part;
            todo.push_back(next);
          }
        }
      }
    }
  }

  bool is_curve(int32_t e) const { return state_.edge[e] && triangles_at_[e] == 0; }

  void grow_curves() {
    std::vector<int32_t> todo;
    for (int32_t first = 0; first < int32_t(cells_.edge.size()); ++first) {
      progress_.tick(0, 1);
      if (!is_curve(first) || out_.of_edge[first] >= 0) continue;
      const int32_t part = new_part();
      out_.of_edge[first] = part;
      todo.push_back(first);
      while (!todo.empty()) {
        const int32_t e = todo.back();
        todo.pop_back();
        for (int32_t v : cells_.edge[e]) {
          if (edges_at_[v] == 1) out_.list[part].level = 1;
          if (edges_at_[v] != 2) continue;
          for (uint64_t k = cells_.vertex_edges.offset[v]; k < cells_.vertex_edges.offset[v + 1];
               ++k) {
            const int32_t next = cells_.vertex_edges.index[k];
            if (!is_curve(next) || out_.of_edge[next] >= 0) continue;
            out_.of_edge[next] = part;
            todo.push_back(next);
          }
        }
      }
    }
  }

  /// call(vertex, part) for every vertex of every cell of a part.
  template <class Call> void visit_vertices(const Call &call) const {
    for (std::size_t t = 0; t < cells_.triangle.size(); ++t)
      if (state_.triangle[t])
        for (int32_t v : cells_.triangle[t]) call(v, out_.of_triangle[t]);
    for (std::size_t e = 0; e < cells_.edge.size(); ++e)
      if (out_.of_edge[e] >= 0)
        for (int32_t v : cells_.edge[e]) call(v, out_.of_edge[e]);
  }

  void settle_vertices() {
    out_.of_vertex.assign(cells_.ball.size(), AxisParts::kNothing);
    visit_vertices([&](int32_t v, int32_t part) {
      int32_t &at = out_.of_vertex[v];
      if (at == AxisParts::kNothing)
        at = part;
      else if (at != part)
        at = AxisParts::kContact;
    });
  }

  /// Neighbours share an edge, or a vertex where one of them is a curve.
  void find_levels() {
    std::vector<std::pair<int32_t, int32_t>> contact; // contact cell, part
    const auto edges = int32_t(cells_.edge.size());
    std::vector<uint8_t> curve_end(cells_.ball.size(), 0);
    for (std::size_t e = 0; e < cells_.edge.size(); ++e)
      if (out_.of_edge[e] >= 0)
        for (int32_t v : cells_.edge[e]) curve_end[v] = 1;
    for (std::size_t t = 0; t < cells_.triangle.size(); ++t) {
      if (!state_.triangle[t]) continue;
      for (int32_t e : cells_.triangle_edges[t])
        if (triangles_at_[e] > 2 || cells_.seam[e]) contact.push_back({e, out_.of_triangle[t]});
      for (int32_t v : cells_.triangle[t])
        if (curve_end[v]) contact.push_back({edges + v, out_.of_triangle[t]});
    }
    for (std::size_t e = 0; e < cells_.edge.size(); ++e)
      if (out_.of_edge[e] >= 0)
        for (int32_t v : cells_.edge[e])
          if (out_.of_vertex[v] == AxisParts::kContact)
            contact.push_back({edges + v, out_.of_edge[e]});
    std::sort(contact.begin(), contact.end());
    std::vector<std::vector<int32_t>> near(out_.list.size());
    for (std::size_t i = 0; i < contact.size();) {
      std::size_t end = i;
      while (end < contact.size() && contact[end].first == contact[i].first) ++end;
      for (std::size_t k = i; k + 1 < end; ++k)
        if (contact[k].second != contact[k + 1].second) { // a chain joins them all ...
          near[contact[k].second].push_back(contact[k + 1].second);
          near[contact[k + 1].second].push_back(contact[k].second);
        }
      if (end - i > 2 && contact[i].second != contact[end - 1].second) { // ... a ring for three
        near[contact[i].second].push_back(contact[end - 1].second);
        near[contact[end - 1].second].push_back(contact[i].second);
      }
      i = end;
    }
    std::vector<int32_t> todo;
    for (std::size_t p = 0; p < out_.list.size(); ++p)
      if (out_.list[p].level == 1) todo.push_back(int32_t(p));
    for (std::size_t i = 0; i < todo.size(); ++i)
      for (int32_t q : near[todo[i]])
        if (out_.list[q].level == 0) {
          out_.list[q].level = out_.list[todo[i]].level + 1;
          todo.push_back(q);
        }
  }

  void measure() {
    for (std::size_t t = 0; t < cells_.triangle.size(); ++t) {
      progress_.tick(0, 1);
      if (!state_.triangle[t]) continue;
      vbm_part &part = out_.list[out_.of_triangle[t]];
      const auto &v = cells_.triangle[t];
      const Vec3 &a = cells_.ball[v[0]].center;
      ++part.triangles;
      part.area += length(cross(cells_.ball[v[1]].center - a, cells_.ball[v[2]].center - a)) / 2 *
                   (cells_.unit * cells_.unit);
      part.width = std::max(part.width, cells_.width[t] * cells_.unit);
      double radius = 0;
      for (int32_t corner : v) radius += cells_.ball[corner].radius / 3;
      const double sine = std::min(1.0, cells_.width[t] / (2 * radius));
      part.angle = std::max(part.angle, std::asin(sine) * (360 / std::acos(-1.0)));
    }
    for (std::size_t e = 0; e < cells_.edge.size(); ++e) {
      if (out_.of_edge[e] < 0) continue;
      const Ball &a = cells_.ball[cells_.edge[e][0]], &b = cells_.ball[cells_.edge[e][1]];
      ++out_.list[out_.of_edge[e]].curve_edges;
      out_.list[out_.of_edge[e]].length += distance(a.center, b.center) * cells_.unit;
    }
    for (std::size_t v = 0; v < cells_.ball.size(); ++v)
      if (out_.of_vertex[v] >= 0) out_.list[out_.of_vertex[v]].volume += cells_.volume[v];
  }

  const AxisCells &cells_;
  const AxisState &state_;
  Progress &progress_;
  std::vector<int32_t> triangles_at_, edges_at_; // per edge, per vertex: those left
  AxisParts out_;
};

} // namespace

AxisState whole_axis(const AxisCells &cells) {
  AxisState state;
  state.triangle.assign(cells.triangle.size(), 1);
  state.edge.assign(cells.edge.size(), 1);
  state.vertex.assign(cells.ball.size(), 1);
  return state;
}

AxisParts find_axis_parts(const AxisCells &cells, const AxisState &state, Progress &progress) {
  return Finder(cells, state, progress).run();
}

} // namespace vbm::impl
