// SPDX-License-Identifier: GPL-3.0-or-later
#include "balls/describe.h"

#include <limits>
#include <string>

namespace vbm::impl {

namespace {

void fill_arrays(Model &model, Progress &progress) {
  const Frame &frame = model.samples.frame;
  const std::size_t balls = model.balls.size(), samples = model.samples.position.size();
  model.centers.reserve(3 * balls);
  model.radii.reserve(balls);
  for (std::size_t b = 0; b < balls; ++b) {
    progress.tick(b, balls);
    const Vec3 c = frame.to_input(model.balls[b].center);
    model.centers.insert(model.centers.end(), {c.x, c.y, c.z});
    model.radii.push_back(frame.length_to_input(model.balls[b].radius));
  }
  model.ball_inside.assign(balls, 0);
  std::fill_n(model.ball_inside.begin(), model.inner, uint8_t(1));
  model.sample_positions.reserve(3 * samples);
  progress.tick_slow(1, 1);
  for (const Vec3 &p : model.samples.input_position)
    model.sample_positions.insert(model.sample_positions.end(), {p.x, p.y, p.z});
}

/// The closing box stands for infinity: an outer polar ball that touches it is a half-space.
bool touches_box(const Model &model, int32_t ball) {
  const Ball &b = model.balls[ball];
  for (const Vec3 &corner : model.cells.corner)
    if (distance(corner, b.center) <= b.radius * (1 + 1e-9)) return true;
  return false;
}

void fill_medial_radii(Model &model, Progress &progress) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::size_t samples = model.samples.position.size();
  std::vector<double> inner(samples, nan), outer(samples, nan);
  for (std::size_t s = 0; s < samples; ++s) {
    progress.tick(1, 1);
    if (const int32_t b = model.inner_pole[s]; b >= 0) inner[s] = model.radii[b];
    if (const int32_t b = model.outer_pole[s]; b >= 0)
      outer[s] = touches_box(model, b) ? infinity : model.radii[b];
  }
  if (model.samples.input_is_samples) {
    model.inner_radius = std::move(inner);
    model.outer_radius = std::move(outer);
    return;
  }
  const auto &sample = model.samples.input_sample;
  model.inner_radius.assign(sample.size(), nan);
  model.outer_radius.assign(sample.size(), nan);
  for (std::size_t i = 0; i < sample.size(); ++i)
    if (sample[i] >= 0) {
      model.inner_radius[i] = inner[sample[i]];
      model.outer_radius[i] = outer[sample[i]];
    }
}

void fill_report(Model &model) {
  const Samples &s = model.samples;
  vbm_model_report &r = model.report;
  r.struct_size = sizeof r;
  r.rule = s.rule;
  r.flipped = s.flipped;
  r.input_points = s.input_points;
  r.dropped = s.dropped;
  r.merged = s.merged;
  r.added = s.added;
  r.samples = s.position.size();
  r.cells = model.cells.size();
  r.inner_balls = model.inner;
  r.outer_balls = model.balls.size() - model.inner;
  r.undersampled = model.undersampled.size();
  r.skipped_faces = s.skipped_faces;
  r.open_loops = s.open_loops;
  r.inconsistent_edges = s.inconsistent_edges;
  r.spacing = s.spacing;
  Vec3 low = s.position[0], high = low;
  for (const Vec3 &p : s.position)
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  r.diagonal = s.frame.length_to_input(distance(low, high));
}

std::string counted(uint64_t n, const char *one, const char *many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

void fill_notes(Model &model) {
  const vbm_model_report &r = model.report;
  for (const std::string &note : model.samples.notes) model.notes += note + "\n";
  if (model.samples.refined)
    model.notes += counted(model.samples.refined, "sample was", "samples were") +
                   " added where balls still held a piece of the mesh.\n";
  if (model.wrong_topology)
    model.notes +=
        "The surface has not the mesh's components and handles: the mesh has parts too thin "
        "for the spacing.\n";
  if (r.unused_samples)
    model.notes += counted(r.unused_samples, "sample is", "samples are") +
                   " not on the surface: the sampling there is too thin or noisy.\n";
  if (r.undersampled)
    model.notes += "The sampling is too thin to trust the surface at " +
                   counted(r.undersampled, "sample", "samples") + " of " +
                   std::to_string(r.samples) + ".\n";
}

} // namespace

void describe(Model &model, Progress &progress) {
  fill_arrays(model, progress);
  fill_medial_radii(model, progress);
  progress.tick_slow(1, 1);
  fill_report(model);
  fill_notes(model);
}

} // namespace vbm::impl
