/* libvbm: medial meshes: an axis of a given number of balls, and curve skeletons.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Included by axis.h, and so by vbm.h, whose conventions hold here. A medial mesh is a simplicial complex whose
 * vertices are balls. It stands for its envelope: the union of its balls, of what a ball sweeps that
 * grows or shrinks steadily along an edge (a truncated cone), and of what it sweeps over a triangle
 * (the convex hull of three balls). A medial mesh is immutable; the axis it was made of may be freed
 * first.
 */
#ifndef VBM_MEDIAL_MESH_H
#define VBM_MEDIAL_MESH_H

#include "axis.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct vbm_medial_mesh vbm_medial_mesh;

/* ---- The axis of N balls ------------------------------------------------------------------------ */

typedef struct vbm_simplify_options {
  size_t struct_size;
  uint64_t count;     /* balls; default 1000, at least 1                                             */
  int32_t iterations; /* how often balls are fitted to the samples they stand for; default 8,
                         0 to 100                                                                    */
  int32_t reserved; /* 0; room for what may be added, so that no byte is left without a meaning */
} vbm_simplify_options;

VBM_API void vbm_simplify_options_init(vbm_simplify_options *options, size_t struct_size);

/* An axis of `count` balls, or of all it has if that is fewer. Its topology is the axis's: every
 * step joins two neighbouring balls under the link condition, which keeps the homotopy type. So no
 * face is there twice, every vertex is used, and a hollow tetrahedron only encloses a cavity of the
 * shape. Then balls are fitted to the samples: each to those the cells at it are nearest to. Of
 * counts of 64 and more, and with at most 16 samples to a ball, there is a second candidate: a
 * quarter as many balls, fitted, with balls put in the middle of edges until there are `count`,
 * fitted again. The one with the smaller errors (the largest times the mean, both ways) is the
 * result.
 *   options  NULL for defaults
 * Errors: ARGUMENT (also for a count that the topology does not allow: says how few balls do),
 * MEMORY, CANCELLED.
 * Source: Dey, Edelsbrunner, Guha, Nekhayev, "Topology preserving edge contraction" (1999); Thiery,
 * Guy, Boubekeur, "Sphere-meshes" (2013); Li et al., "Q-MAT" (2015). */
VBM_API vbm_status vbm_axis_simplify(vbm_context *context, const vbm_axis *axis,
                                     const vbm_simplify_options *options, vbm_medial_mesh **out);

/* ---- Curve skeletons ----------------------------------------------------------------------------- */

typedef struct vbm_curve_skeleton_options {
  size_t struct_size;
  double spur;    /* a branch stays if it is longer than the shape is wide at it by this share of the
                     bounding-box diagonal, ...; default 0.03, 0 to 1                                */
  double ratio;   /* ... and by this many times that width; default 0.5, at least 0                  */
  double spacing; /* neighbouring balls are about this many times half the shape's width apart;
                     default 0.5, 0.05 to 100                                                        */
} vbm_curve_skeleton_options;

VBM_API void vbm_curve_skeleton_options_init(vbm_curve_skeleton_options *options,
                                             size_t struct_size);

/* The axis collapsed to curves. It burns from its border at even speed, so that curves are what fire
 * reaches from two sides at once: well inside, and as long as the shape is where it is longer than
 * wide. Topology is the axis's: it burns by elementary collapses only. Sheets round cavities cannot
 * burn and stay as triangles. Balls are the largest that fit at their places, inside the
 * interpolating surface.
 *   options  NULL for defaults
 * Errors: ARGUMENT, MEMORY, CANCELLED.
 * Source: Yan, Sykes, Chambers, Letscher, Ju, "Erosion thickness on medial axes of 3D shapes" (2016).
 */
VBM_API vbm_status vbm_axis_curve_skeleton(vbm_context *context, const vbm_axis *axis,
                                           const vbm_curve_skeleton_options *options,
                                           vbm_medial_mesh **out);

/* ---- Reading a medial mesh ----------------------------------------------------------------------- */

VBM_API void vbm_medial_mesh_free(vbm_medial_mesh *mesh);

typedef struct vbm_medial_mesh_report {
  size_t struct_size;
  uint64_t vertices, triangles;
  uint64_t edges;       /* in all, those of triangles too                                           */
  uint64_t curve_edges; /* of no triangle                                                           */
  uint64_t components;  /* connected pieces: Betti number 0                                         */
  int64_t euler;        /* vertices - edges + triangles                                             */
  double diagonal;      /* bounding-box diagonal of the samples, which errors are shares of         */
  /* From the samples on the shape's surface to the boundary of the envelope ("one-sided").          */
  double sample_error_max, sample_error_mean;
  /* From the boundary of the envelope to the interpolating surface; of points spread evenly over it. */
  double envelope_error_max, envelope_error_mean;
  /* Two-sided: the larger of the largest, the mean of the means.                                    */
  double error_max, error_mean;
} vbm_medial_mesh_report;

VBM_API vbm_status vbm_medial_mesh_get_report(const vbm_medial_mesh *mesh,
                                              vbm_medial_mesh_report *report);

/* What making this mesh has to say, as vbm_model_notes(). */
VBM_API const char *vbm_medial_mesh_notes(const vbm_medial_mesh *mesh);

/* Vertices: centres (count x 3) and radii (count). */
VBM_API const double *vbm_medial_mesh_vertices(const vbm_medial_mesh *mesh, size_t *count);
VBM_API const double *vbm_medial_mesh_radii(const vbm_medial_mesh *mesh, size_t *count);
/* Triangles, count x 3 vertex indices. */
VBM_API const int32_t *vbm_medial_mesh_triangles(const vbm_medial_mesh *mesh, size_t *count);
/* Curves: edges of no triangle, count x 2 vertex indices. */
VBM_API const int32_t *vbm_medial_mesh_edges(const vbm_medial_mesh *mesh, size_t *count);

#ifdef __cplusplus
}
#endif

#endif /* VBM_MEDIAL_MESH_H */
