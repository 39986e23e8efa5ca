/* libvbm: clustering: fewer balls for a shape (thesis 4.4.1).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Included by vbm.h, whose conventions hold here. Clusters keep a copy of the balls they were made
 * of, are immutable, and may be read from any thread.
 */
#ifndef VBM_CLUSTER_H
#define VBM_CLUSTER_H

#include "vbm.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct vbm_clusters vbm_clusters;

/* What tells how well one ball stands for the balls of a cluster. */
typedef enum vbm_cluster_measure {
  VBM_CLUSTER_ENCLOSING = 0, /* the cluster's largest ball in the ball that encloses the cluster
                                (thesis 4.4.1)                                                     */
  VBM_CLUSTER_UNION = 1      /* the union of all balls round the enclosing ball's sphere: as exact,
                                and fewer balls; takes longer                                      */
} vbm_cluster_measure;

typedef struct vbm_cluster_options {
  size_t struct_size;
  double sphericity; /* 0.01 to 1, default 0.95: each cluster's is at least this                   */
  uint64_t count;    /* not 0: the best so many balls, and sphericity is not used; default 0       */
  int32_t measure;   /* vbm_cluster_measure; default ENCLOSING                                     */
  int32_t reserved; /* 0; room for what may be added, so that no byte is left without a meaning */
} vbm_cluster_options;

VBM_API void vbm_cluster_options_init(vbm_cluster_options *options, size_t struct_size);

/* Replace groups of balls by one ball each that encloses them. The largest ball left and as many others
 * as fit make a cluster, until none is left.
 *
 * The sphericity of a cluster is r / R, with r the radius of its largest ball and R that of the
 * smallest ball that encloses it (Figure 4.2); 1 for a ball alone. By the UNION measure it is
 * 1 - gap / (2 R), with `gap` how far from the union of all balls the enclosing ball's sphere goes:
 * never less, because the largest ball alone leaves a gap of at most 2 (R - r).
 *
 * With a `count` the largest error is made as small as it can be found: every R exceeds its r by at
 * most the same length (every gap is at most twice that), which is sought. Where fewer balls are as
 * good, fewer there are, and vbm_clusters_notes() says so.
 *   centers  count x 3
 *   radii    count; 0 is a point
 *   options  NULL for defaults
 * Disks lie in a plane: give their centres a common z.
 * Errors: ARGUMENT; INPUT (no balls, a centre that is not finite, a radius that is not finite or
 * negative: kind "ball"), MEMORY, CANCELLED.
 * Source: thesis 4.4.1; Ranjan, Fournier, "Matching and interpolation of shapes using unions of
 * circles" (1996); enclosing balls by Fischer, Gärtner, "The smallest enclosing ball of balls" (2004). */
VBM_API vbm_status vbm_cluster_balls(vbm_context *context, const double *centers,
                                     const double *radii, size_t count,
                                     const vbm_cluster_options *options, vbm_clusters **out);

/* The same of a model's inner balls. Errors: as vbm_cluster_balls(), and NO_INTERIOR (no inner ball). */
VBM_API vbm_status vbm_model_cluster(vbm_context *context, const vbm_model *model,
                                     const vbm_cluster_options *options, vbm_clusters **out);

VBM_API void vbm_clusters_free(vbm_clusters *clusters);

typedef struct vbm_clusters_report {
  size_t struct_size;
  uint64_t balls;       /* given                                                                   */
  uint64_t clusters;
  uint64_t singles;     /* clusters of one ball                                                    */
  double sphericity;    /* least of all clusters'                                                  */
  double largest;       /* radius of the largest ball given                                        */
  double gap;           /* largest of vbm_clusters_gap(): no point of the clusters' boundary is
                           farther than this from the given balls' union                           */
  double bound;         /* Theorem 3.3's for `gap`: 2 r (1 - s) / s with r `largest` and s the sphericity
                           asked for; by UNION 2 R (1 - s) with R the largest cluster's radius. With
                           a count the largest of the clusters' own such bounds. That `gap` does not
                           exceed it is checked every time                                         */
} vbm_clusters_report;

VBM_API vbm_status vbm_clusters_get_report(const vbm_clusters *clusters,
                                           vbm_clusters_report *report);

/* What a user should know about these clusters, as vbm_model_notes(). */
VBM_API const char *vbm_clusters_notes(const vbm_clusters *clusters);

/* The balls, one a cluster: centres (count x 3) and radii (count); in the order they were made, which
 * without a count is that of their largest balls. */
VBM_API const double *vbm_clusters_centers(const vbm_clusters *clusters, size_t *count);
VBM_API const double *vbm_clusters_radii(const vbm_clusters *clusters, size_t *count);
/* Sphericity of every cluster, by the measure asked for. */
VBM_API const double *vbm_clusters_sphericity(const vbm_clusters *clusters, size_t *count);
/* For every cluster a length that no point of its ball's sphere is farther than from the union of the
 * given balls: with c the centre of its ball and a that of its largest, |c - a| + R - r; by the UNION
 * measure, that union's own distance. */
VBM_API const double *vbm_clusters_gap(const vbm_clusters *clusters, size_t *count);
/* For every given ball its cluster. */
VBM_API const int32_t *vbm_clusters_ball_cluster(const vbm_clusters *clusters, size_t *count);
/* The given balls of every cluster, in the form of vbm_model_ball_samples(): the largest first, then
 * the rest ascending. */
VBM_API const int32_t *vbm_clusters_balls(const vbm_clusters *clusters, const uint64_t **offsets,
                                          size_t *count);

/* ---- How far the boundary moved ------------------------------------------------------------------ */

/* Distances between the boundary of the union of the given balls and that of the union of the clusters'
 * balls, both ways, at points of either. */
typedef struct vbm_cluster_error {
  size_t struct_size;
  uint64_t outward_points, inward_points; /* points looked at on the clusters', the given boundary */
  double outward, outward_mean;           /* from the clusters' boundary to the given one: the largest
                                             and the mean. Exact at each point; Theorem 3.3 bounds it */
  double inward, inward_mean;             /* from the given boundary to the clusters'. Not bounded by
                                             the theorem: large where a narrow gap was closed. At a
                                             point it is never less than the distance               */
  double outward_position[3], inward_position[3]; /* where the largest are                           */
} vbm_cluster_error;

/* Measure them at about `points` points (1 to 100 million; at least one for every ball) of each
 * boundary. Each point is where a ray from a ball's centre first leaves the union; there are more of
 * them where balls are many, and means are over the points.
 * error->struct_size must be set by the caller; *error is only written on success.
 * Errors: ARGUMENT, MEMORY, CANCELLED. */
VBM_API vbm_status vbm_clusters_measure(vbm_context *context, const vbm_clusters *clusters,
                                        size_t points, vbm_cluster_error *error);

#ifdef __cplusplus
}
#endif

#endif /* VBM_CLUSTER_H */
