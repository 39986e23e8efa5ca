// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball_io.h"

#include "../filters/layer.h"
#include "../filters/text.h"
#include "../host/mesh_copy.h"
#include "files/ball_file.h"

#include <QFile>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <limits>

namespace vbm_meshlab {

using vbm_filters::Failure;

namespace {

std::filesystem::path path_of(const QString &path) { return QFile::encodeName(path).toStdString(); }

std::vector<double> plain(const std::vector<double> &values) {
  std::vector<double> result;
  result.reserve(values.size());
  for (double value : values) result.push_back(vbm_filters::as_written(static_cast<float>(value)));
  return result;
}

// That there are balls, with a layer's numbers, which are smaller ones than a file's.
void check_balls(const vbm::files::BallFile &file) {
  const auto beyond = [](double value) {
    return std::abs(value) > double(std::numeric_limits<Scalarm>::max());
  };
  if (file.radii.empty()) throw Failure("This file holds no balls.");
  for (std::size_t i = 0; i < file.radii.size(); ++i)
    if (beyond(file.radii[i]) ||
        std::any_of(&file.centers[3 * i], &file.centers[3 * i] + 3, beyond))
      throw Failure("Ball " + std::to_string(i) +
                    " of this file is beyond the numbers that MeshLab's layers can hold.");
}

using Edge = std::pair<std::int32_t, std::int32_t>; // the lower index first

std::vector<Edge> sorted(std::vector<Edge> edges) {
  for (Edge &edge : edges) edge = std::minmax({edge.first, edge.second});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<Edge> pairs(const std::vector<std::int32_t> &indices) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i + 1 < indices.size(); i += 2)
    edges.emplace_back(indices[i], indices[i + 1]);
  return sorted(std::move(edges));
}

std::vector<Edge> sides_of(const std::vector<std::int32_t> &triangles) {
  std::vector<Edge> edges;
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3)
    for (int k = 0; k < 3; ++k) edges.emplace_back(triangles[t + k], triangles[t + (k + 1) % 3]);
  return sorted(std::move(edges));
}

// Only a Failure leaves.
template <class Work> auto guarded(Work work) -> decltype(work()) {
  try {
    return work();
  } catch (const Failure &) {
    throw;
  } catch (const std::bad_alloc &) {
    throw Failure("There is not enough memory for this file.");
  } catch (const std::exception &error) {
    throw Failure(error.what());
  } catch (...) {
    throw Failure("The file failed for an unknown reason.");
  }
}

} // namespace

const std::vector<BallFormat> &ball_formats() {
  static const std::vector<BallFormat> all = {
      {"csv", "Balls: x, y, z, radius", true},
      {"ma", "Balls of a medial mesh", true},
      {"urdf", "Balls as collision spheres", false},
  };
  return all;
}

BallsRead read_balls(const QString &path, MeshModel &layer) {
  return guarded([&] {
    vbm::files::BallFile file = vbm::files::read_balls(path_of(path));
    check_balls(file);
    vbm_filters::NewLayer balls;
    balls.points = std::move(file.centers);
    balls.radius = std::move(file.radii);
    balls.quality = balls.radius;
    balls.triangles = std::move(file.triangles);
    fill(layer, balls);

    using vcg::tri::io::Mask;
    BallsRead result;
    result.mask = Mask::IOM_VERTCOORD | Mask::IOM_VERTRADIUS | Mask::IOM_VERTQUALITY;
    if (!balls.triangles.empty()) result.mask |= Mask::IOM_FACEINDEX;
    // Edges of triangles come with those.
    std::vector<Edge> curves = pairs(file.edges), sides = sides_of(balls.triangles), alone;
    std::set_difference(curves.begin(), curves.end(), sides.begin(), sides.end(),
                        std::back_inserter(alone));
    if (!alone.empty())
      result.warning = QString::fromStdString(
          "MeshLab's layers have no edges: " +
          vbm_filters::count(alone.size(), "edge of no face is", "edges of no face are") +
          " left out, their balls are there.");
    return result;
  });
}

void write_balls(const QString &path, MeshModel &layer) {
  guarded([&] {
    const Source source = copy_out(layer);
    if (source.layer.radius.empty())
      throw Failure("The vertices of this layer have no radius, so they are no balls to save: "
                    "\"Build Ball Model\" makes a layer of balls from a shape.");
    vbm::files::BallFile file;
    file.centers = plain(source.layer.points);
    file.radii = plain(source.layer.radius);
    file.triangles = source.layer.triangles;
    vbm::files::write_balls(path_of(path), file);
  });
}

} // namespace vbm_meshlab
