// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_axis.h"

#include "check_surface.h"
#include "snapshot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

namespace {

template <class T> struct View {
  const T *data = nullptr;
  size_t size = 0;
};

template <class T> View<T> view(const vbm_axis *axis, const T *(*get)(const vbm_axis *, size_t *)) {
  View<T> v;
  v.data = get(axis, &v.size);
  return v;
}

using Pair = std::array<int32_t, 2>;

Pair sorted(int32_t a, int32_t b) { return {std::min(a, b), std::max(a, b)}; }

template <class Row> bool all_different(std::vector<Row> rows) {
  std::sort(rows.begin(), rows.end());
  return std::adjacent_find(rows.begin(), rows.end()) == rows.end();
}

int32_t root(std::vector<int32_t> &parent, int32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

bool all_below(const int32_t *data, size_t count, size_t limit) {
  return std::all_of(data, data + count, [&](int32_t i) { return i >= 0 && size_t(i) < limit; });
}

/// Every triangle or curve's edge has a width and an angle, of which its part has the largest.
void check_sizes(const vbm_axis *axis, const int32_t *(*get_part)(const vbm_axis *, size_t *),
                 const double *(*get_width)(const vbm_axis *, size_t *),
                 const double *(*get_angle)(const vbm_axis *, size_t *), Problems &problems) {
  const auto parts = view(axis, vbm_axis_parts);
  const auto part = view(axis, get_part);
  const auto width = view(axis, get_width), angle = view(axis, get_angle);
  problems.require(width.size == part.size && angle.size == part.size, "widths or angles missing");
  if (width.size != part.size || angle.size != part.size) return;
  std::vector<double> widest(parts.size, 0), largest(parts.size, 0);
  std::vector<uint8_t> there(parts.size, 0);
  for (size_t i = 0; i < part.size; ++i) {
    problems.require(width.data[i] >= 0 && angle.data[i] >= 0 && angle.data[i] <= 180,
                     "a width or an angle out of range", i);
    const auto p = size_t(part.data[i]);
    there[p] = 1;
    widest[p] = std::max(widest[p], width.data[i]);
    largest[p] = std::max(largest[p], angle.data[i]);
  }
  for (size_t p = 0; p < parts.size; ++p)
    problems.require(!there[p] || (std::fabs(parts.data[p].width - widest[p]) <= 1e-9 * widest[p] &&
                                   std::fabs(parts.data[p].angle - largest[p]) <= 1e-5),
                     "a part's width or angle is not its largest", p);
}

/// Contact curves are edges of the axis, each of triangles of two parts or more, and all of those.
void check_contacts(const vbm_axis *axis, Problems &problems) {
  const auto triangles = view(axis, vbm_axis_triangles);
  const auto part = view(axis, vbm_axis_triangle_part);
  const auto edges = view(axis, vbm_axis_contact_edges);
  const auto node = view(axis, vbm_axis_contact_node);
  const auto nodes = view(axis, vbm_axis_nodes);
  problems.require(node.size == edges.size && all_below(node.data, node.size, nodes.size),
                   "nodes of contact edges do not fit");
  std::map<Pair, std::pair<int32_t, bool>> sides; // per edge: a part, and whether there are more
  for (size_t t = 0; t < part.size; ++t)
    for (int i = 0; i < 3; ++i) {
      const Pair e = sorted(triangles.data[3 * t + i], triangles.data[3 * t + (i + 1) % 3]);
      auto &side = sides.emplace(e, std::pair(part.data[t], false)).first->second;
      side.second |= side.first != part.data[t];
    }
  size_t expected = 0;
  for (const auto &[e, side] : sides) expected += side.second;
  problems.require(edges.size == expected, "not all contact edges are listed");
  std::vector<int32_t> at(view(axis, vbm_axis_radii).size, -1); // per vertex: its node
  for (size_t e = 0; e < edges.size; ++e) {
    const int32_t a = edges.data[2 * e], b = edges.data[2 * e + 1];
    const auto found = sides.find(sorted(a, b));
    problems.require(found != sides.end() && found->second.second, "no contact at an edge", e);
    if (found == sides.end()) continue;
    found->second.second = false; // not twice
    for (int32_t v : {a, b}) {
      problems.require(at[v] < 0 || at[v] == node.data[e], "a contact vertex of two nodes", e);
      at[v] = node.data[e];
    }
  }
}

void check_parts(const vbm_axis *axis, const vbm_axis_report &report, size_t inner,
                 Problems &problems) {
  const auto parts = view(axis, vbm_axis_parts);
  problems.require(parts.size == report.parts, "parts and report differ");
  uint64_t triangles = 0, curves = 0;
  double volume = 0;
  for (size_t p = 0; p < parts.size; ++p) {
    const vbm_part &part = parts.data[p];
    triangles += part.triangles;
    curves += part.curve_edges;
    volume += part.volume;
    problems.require((part.triangles == 0) != (part.curve_edges == 0), "neither sheet nor curve",
                     p);
    problems.require(part.level >= 0 && part.lock >= VBM_LOCK_NONE && part.lock <= VBM_LOCK_LAST,
                     "level or lock out of range", p);
    problems.require(part.lock != VBM_LOCK_NONE || part.level == 1, "an inner part may go", p);
    for (double x : {part.length, part.volume, part.width, part.angle, part.position[0],
                     part.position[1], part.position[2]})
      problems.require(std::isfinite(x), "a part's number is not finite", p);
    // In an input of 1e200 units an area is more than a double can hold.
    problems.require(part.area >= 0, "a part's area", p);
  }
  problems.require(triangles == report.triangles, "parts' triangles are not the whole's");
  problems.require(curves == report.curve_edges, "parts' edges are not the whole's");
  check_sizes(axis, vbm_axis_triangle_part, vbm_axis_triangle_width, vbm_axis_triangle_angle,
              problems);
  check_sizes(axis, vbm_axis_curve_part, vbm_axis_curve_width, vbm_axis_curve_angle, problems);
  problems.require(volume <= 1 + 1e-6, "parts have more volume than there is");
  const uint64_t *offsets = nullptr;
  size_t count = 0;
  const int32_t *balls = vbm_axis_part_balls(axis, &offsets, &count);
  problems.require(offsets && offsets[0] == 0 && offsets[parts.size] == count,
                   "offsets of balls do not fit");
  problems.require(all_below(balls, count, inner), "a part's ball is not there");
  problems.require(all_different(std::vector<int32_t>(balls, balls + count)),
                   "a ball goes with two parts");
  const int32_t *nodes = vbm_axis_part_nodes(axis, &offsets, &count);
  problems.require(offsets && offsets[parts.size] == count, "offsets of nodes do not fit");
  problems.require(all_below(nodes, count, view(axis, vbm_axis_nodes).size),
                   "a part's node is not there");
  const int32_t *locks = nullptr;
  const int32_t *stayed = vbm_axis_stayed(axis, &locks, &count);
  problems.require(all_below(stayed, count, parts.size), "a part that stayed is not there");
  for (size_t i = 0; i < count; ++i)
    problems.require(locks[i] == parts.data[stayed[i]].lock && locks[i] != VBM_LOCK_NONE,
                     "a part stayed for another reason", i);
}

/// One step from axis to axis: checked, recorded, and taken on.
class Steps {
public:
  Steps(vbm_context *context, const vbm_model *model, std::string *bytes)
      : context_(context), model_(model), bytes_(bytes) {}
  ~Steps() { vbm_axis_free(axis_); }

  Problems run() {
    if (!find_topology()) return problems_;
    vbm_axis *made = nullptr;
    if (!take("medial axis", vbm_model_medial_axis(context_, model_, nullptr, &made), made))
      return problems_;
    const double *shares = nullptr;
    size_t count = 0;
    const vbm_status status = vbm_axis_part_ball_volumes(context_, axis_, &shares, &count);
    if (status != VBM_OK) problems_.add("volumes of balls: " + message());
    double sum = 0;
    for (size_t p = 0; status == VBM_OK && p < count; ++p) sum += shares[p];
    problems_.require(std::isfinite(sum) && sum <= 1 + 1e-6, "shares of balls are more than all");
    const std::pair<vbm_measure, double> measures[] = {{VBM_MEASURE_TRIANGLES, 5},
                                                       {VBM_MEASURE_WIDTH, 0.02},
                                                       {VBM_MEASURE_VOLUME, 0.05},
                                                       {VBM_MEASURE_BALLS, 0.05},
                                                       {VBM_MEASURE_ANGLE, 60}};
    for (const auto &[measure, threshold] : measures)
      if (!prune(measure, threshold)) return problems_;
    if (!remove_one()) return problems_;
    surface(0);
    if (!prune_all()) return problems_;
    surface(1);
    return problems_;
  }

private:
  std::string message() const { return vbm_context_message(context_); }

  bool find_topology() {
    vbm_surface *surface = nullptr;
    if (vbm_model_surface(context_, model_, &surface) != VBM_OK) {
      problems_.add("surface: " + message());
      return false;
    }
    vbm_surface_report report;
    report.struct_size = sizeof report;
    vbm_surface_get_report(surface, &report);
    euler_ = report.euler;
    surfaces_ = report.components;
    vbm_surface_free(surface);
    return true;
  }

  bool take(const char *what, vbm_status status, vbm_axis *&made) { // after the call
    if (status != VBM_OK) {
      problems_.add(std::string(what) + ": " + message());
      if (made) problems_.add("an axis beside a failure");
      return false;
    }
    vbm_axis_report report;
    report.struct_size = sizeof report;
    vbm_axis_get_report(made, &report);
    if (!axis_) pieces_ = report.components;
    problems_.require(pieces_ <= surfaces_, "an axis in more pieces than the surface");
    const Problems found = check_axis(made, model_, euler_ / 2, pieces_);
    if (!found.none()) problems_.add(std::string(what) + ":\n" + found.text());
    if (bytes_) *bytes_ += snapshot(made);
    vbm_axis_free(axis_);
    axis_ = made;
    return true;
  }

  bool prune(vbm_measure measure, double threshold) {
    vbm_prune_options options;
    vbm_prune_options_init(&options, sizeof options);
    options.measure = measure;
    options.threshold = threshold;
    options.iterations = 2;
    vbm_axis *made = nullptr;
    return take("pruning", vbm_axis_prune(context_, axis_, &options, &made), made);
  }

  /// By two measures in one call.
  bool prune_all() {
    vbm_prune_options first, second;
    vbm_prune_options_init(&first, sizeof first);
    vbm_prune_options_init(&second, sizeof second);
    first.iterations = second.iterations = 2;
    first.measure = VBM_MEASURE_BALLS;
    first.threshold = 0.05;
    second.threshold = 1e9;
    const vbm_prune_options *steps[] = {&first, &second};
    vbm_axis *made = nullptr;
    return take("pruning in steps", vbm_axis_prune_steps(context_, axis_, steps, 2, &made), made);
  }

  bool remove_one() {
    const auto parts = view(axis_, vbm_axis_parts);
    const auto of = view(axis_, vbm_axis_triangle_part);
    for (size_t p = 0; p < parts.size; ++p) {
      vbm_axis *made = reinterpret_cast<vbm_axis *>(this);
      if (parts.data[p].lock != VBM_LOCK_NONE) {
        const auto number = int32_t(p);
        if (vbm_axis_remove_parts(context_, axis_, &number, 1, &made) != VBM_ERROR_INPUT || made)
          problems_.add("a locked part went");
        continue;
      }
      if (parts.data[p].triangles == 0) continue;
      const auto t = int32_t(std::find(of.data, of.data + of.size, int32_t(p)) - of.data);
      return take("removing", vbm_axis_remove_triangles(context_, axis_, &t, 1, &made), made);
    }
    return true;
  }

  void surface(int32_t drop_outer) {
    vbm_axis_surface_options options;
    vbm_axis_surface_options_init(&options, sizeof options);
    options.drop_outer = drop_outer;
    vbm_surface *made = nullptr;
    if (vbm_axis_surface(context_, axis_, &options, &made) != VBM_OK) {
      problems_.add("surface of an axis: " + message());
      return;
    }
    Topology topology;
    const Problems found = check_surface(made, model_, &topology);
    if (!found.none()) problems_.add("surface of an axis:\n" + found.text());
    vbm_surface_report report;
    report.struct_size = sizeof report;
    vbm_surface_get_report(made, &report);
    problems_.require(report.euler == euler_ && report.components == surfaces_,
                      "the surface of an axis has another topology than the solid's");
    if (bytes_) *bytes_ += snapshot(made);
    vbm_surface_free(made);
  }

  vbm_context *context_;
  const vbm_model *model_;
  std::string *bytes_;
  vbm_axis *axis_ = nullptr;
  int64_t euler_ = 0; // of the solid's surface: twice its own
  uint64_t surfaces_ = 0, pieces_ = 0;
  Problems problems_;
};

} // namespace

Problems check_axis(const vbm_axis *axis, const vbm_model *model, int64_t euler,
                    uint64_t components) {
  Problems problems;
  vbm_axis_report report;
  report.struct_size = sizeof report;
  if (vbm_axis_get_report(axis, &report) != VBM_OK) problems.add("no report");
  const auto vertices = view(axis, vbm_axis_vertices);
  const auto radii = view(axis, vbm_axis_radii);
  const auto triangles = view(axis, vbm_axis_triangles);
  const auto samples = view(axis, vbm_axis_triangle_samples);
  const auto part = view(axis, vbm_axis_triangle_part);
  const auto curves = view(axis, vbm_axis_curves);
  const auto curve_part = view(axis, vbm_axis_curve_part);
  const auto kept = view(axis, vbm_axis_kept_balls);
  problems.require(vertices.size == report.vertices && radii.size == report.vertices &&
                       triangles.size == report.triangles && samples.size == report.triangles &&
                       part.size == report.triangles && curves.size == report.curve_edges &&
                       curve_part.size == report.curve_edges &&
                       kept.size == vbm_model_inner_count(model),
                   "sizes of views and report differ");
  size_t sample_count = 0;
  vbm_model_samples(model, &sample_count);
  problems.require(report.vertices > 0, "no vertex is left");
  problems.require(all_below(triangles.data, 3 * triangles.size, vertices.size) &&
                       all_below(curves.data, 2 * curves.size, vertices.size) &&
                       all_below(samples.data, 2 * samples.size, sample_count) &&
                       all_below(part.data, part.size, report.parts) &&
                       all_below(curve_part.data, curve_part.size, report.parts),
                   "an index is out of range");
  if (!problems.none()) return problems;
  for (size_t i = 0; i < 3 * vertices.size; ++i)
    problems.require(std::isfinite(vertices.data[i]), "a vertex is not finite", i / 3);
  for (size_t v = 0; v < radii.size; ++v)
    problems.require(std::isfinite(radii.data[v]) && radii.data[v] >= 0, "no radius", v);

  std::vector<std::array<int32_t, 3>> faces(triangles.size);
  std::vector<Pair> edges;
  for (size_t t = 0; t < triangles.size; ++t) {
    std::copy_n(triangles.data + 3 * t, 3, faces[t].begin());
    std::sort(faces[t].begin(), faces[t].end());
    const auto [a, b, c] = faces[t];
    problems.require(a != b && b != c, "a triangle with a corner twice", t);
    edges.insert(edges.end(), {{a, b}, {b, c}, {a, c}});
  }
  problems.require(all_different(faces), "a triangle is there twice");
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (size_t e = 0; e < curves.size; ++e)
    edges.push_back(sorted(curves.data[2 * e], curves.data[2 * e + 1]));
  problems.require(all_different(edges), "an edge is there twice");
  problems.require(edges.size() == report.edges, "edges and report differ");
  std::vector<int32_t> parent(vertices.size);
  std::iota(parent.begin(), parent.end(), 0);
  uint64_t pieces = vertices.size;
  for (const auto &[a, b] : edges) {
    const int32_t i = root(parent, a), j = root(parent, b);
    pieces -= i != j;
    parent[std::max(i, j)] = std::min(i, j);
  }
  problems.require(pieces == report.components && pieces == components,
                   "connected pieces are not the solid's");
  const int64_t counted = int64_t(vertices.size) - int64_t(edges.size()) + int64_t(triangles.size);
  problems.require(counted == report.euler && counted == euler,
                   "Euler's number is not the solid's");
  check_parts(axis, report, kept.size, problems);
  check_contacts(axis, problems);
  return problems;
}

Problems exercise_axis(vbm_context *context, const vbm_model *model, std::string *bytes) {
  return Steps(context, model, bytes).run();
}
