// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/mesh.h"

#include "core/error.h"
#include "core/progress.h"
#include "sampling/buried.h"
#include "sampling/checks.h"
#include "sampling/face_normals.h"
#include "sampling/faces.h"
#include "sampling/fill.h"
#include "sampling/holes.h"
#include "sampling/mesh_queries.h"
#include "sampling/orientation.h"
#include "sampling/parts.h"
#include "sampling/tolerances.h"

namespace vbm::impl {
namespace {

void check_labels(const vbm_build_options &options) {
  const auto refuse = [](const char *message) {
    throw Error(VBM_ERROR_ARGUMENT, message, "option", {}, 0);
  };
  if (options.labels == VBM_LABELS_VOXELS)
    refuse("option labels is VOXELS, which needs a volume, but the input is a mesh");
  if (options.labels == VBM_LABELS_SCAN)
    refuse("option labels is SCAN, which needs scanner positions, but the input is a mesh");
}

/// Edges of three or more faces whose directions do not cancel.
std::size_t branching_edges(const TriangleMesh &mesh) {
  std::size_t count = 0;
  for (const Edge &e : mesh.edge) count += e.faces() > 2 && e.balance != 0;
  return count;
}

/// Make the faces agree and say whether their normals can be used for labels.
bool settle_normals(TriangleMesh &mesh, const vbm_build_options &options, Samples &samples,
                    Progress &progress) {
  const bool wanted = options.labels != VBM_LABELS_PROPAGATION;
  const Orientation found = make_consistent(mesh, samples.position, wanted, progress);
  samples.inconsistent_edges = found.inconsistent_edges;
  if (!wanted) return false;
  if (found.turned_edges)
    samples.notes.push_back(counted(found.turned_edges, "edge", "edges") +
                            " had faces of contradicting direction; faces were turned");
  std::string reason;
  if (!found.orientable)
    reason = "the mesh is not orientable: no way to turn its faces makes all neighbours agree";
  else if (const std::size_t n = branching_edges(mesh);
           double(n) > kMostBranching * double(mesh.edge.size()))
    reason = counted(n, "edge joins", "edges join") + " three or more faces of the mesh";
  if (reason.empty()) return true;
  if (options.labels == VBM_LABELS_NORMALS)
    throw Error(VBM_ERROR_NO_INTERIOR,
                reason + ", so its normals cannot tell inside from outside as option labels asks");
  samples.notes.push_back(reason + "; labels come from propagation");
  return false;
}

void note_defects(const TriangleMesh &mesh, const Parts &parts, bool normals, Samples &samples) {
  std::size_t crowded = 0;
  for (const Edge &e : mesh.edge) crowded += e.faces() > 2;
  if (crowded)
    samples.notes.push_back(counted(crowded, "edge has", "edges have") + " three or more faces");
  if (samples.open_loops)
    samples.notes.push_back(
        "the mesh is open: " + counted(samples.open_loops, "boundary loop", "boundary loops") +
        (parts.usable ? ", small enough to tell inside from outside as if closed"
         : normals    ? "; inside and outside are told by the faces' fronts and backs alone"
                      : ""));
  if (parts.usable && parts.overlap)
    samples.notes.push_back(
        "parts of the mesh lie within or across each other: inside is where they "
        "wind round at least once");
}

} // namespace

Samples sample_mesh(const double *vertices, std::size_t vertex_count, const uint32_t *face_sizes,
                    const int32_t *corners, std::size_t corner_count, std::size_t face_count,
                    const vbm_build_options &options, Progress &progress) {
  check_labels(options);
  Samples samples;
  TriangleMesh mesh;
  mesh.triangle =
      read_faces({vertices, vertex_count, face_sizes, corners, corner_count, face_count}, options,
                 samples, progress);
  if (mesh.triangle.empty())
    throw Error(
        VBM_ERROR_DEGENERATE,
        "none of the mesh's " + counted(face_count, "face", "faces") +
            " is usable, so there are 0 samples; at least 4 that span 3 dimensions are needed");
  if (find_edges(mesh, samples.position.size(), progress)) {
    drop_double_faces(mesh.triangle, samples);
    find_edges(mesh, samples.position.size(), progress);
  }

  const bool normals = settle_normals(mesh, options, samples, progress);
  progress.tick_slow(0, 1);
  const Holes holes = find_holes(mesh);
  samples.open_loops = holes.loops;
  Parts parts;
  if (normals) {
    parts = find_parts(mesh, samples.position, holes, progress);
    turn_upright(mesh, parts, samples);
  }
  note_defects(mesh, parts, normals, samples);
  if (parts.usable && !parts.overlap && !samples.open_loops && !samples.inconsistent_edges) {
    samples.components = parts.part.size();
    samples.euler = int64_t(samples.position.size()) - int64_t(mesh.edge.size()) +
                    int64_t(mesh.triangle.size());
  }

  const std::vector<Vec3> face_normal = face_normals(mesh.triangle, samples.position, progress);
  samples.rule = normals ? VBM_LABELS_NORMALS : VBM_LABELS_PROPAGATION;
  if (normals)
    samples.normal = vertex_normals(mesh.triangle, samples.position, face_normal, progress);
  std::shared_ptr<const BuriedTest> buried;
  if (parts.usable && parts.overlap && parts.part.size() <= kManyParts)
    buried = std::make_shared<const BuriedTest>(mesh.triangle, parts, progress);
  const auto tree = mesh_tree(mesh.triangle, normals ? std::move(parts.position) : samples.position,
                              parts, progress);
  fill_gaps(mesh, face_normal, *tree, buried.get(), options, samples, progress);
  if (buried) drop_buried(*buried, samples, progress);
  set_mesh_queries(tree, parts, std::move(buried), samples);
  return samples;
}

} // namespace vbm::impl
