/* libvbm: unions of balls from anywhere: exact measures, and closed surfaces (thesis 7.9, 8.3).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Included by vbm.h, whose conventions hold here. Balls are count x 3 centres and count radii: a pruned
 * model's, a file's, a molecule's. They may overlap, touch, hide each other or be far apart, in any
 * numbers; radii may be 0, which makes a point that is left out and counted.
 */
#ifndef VBM_BALLS_H
#define VBM_BALLS_H

#include "vbm.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Measures of a union ----------------------------------------------------------------------- */

typedef struct vbm_measures vbm_measures;

typedef struct vbm_measures_report {
  size_t struct_size;
  uint64_t balls;        /* given                                                                */
  uint64_t hidden;       /* that have no share: within others, duplicates, points                */
  double volume, area;   /* of the union, in the balls' units                                    */
} vbm_measures_report;

/* Volume and area of the union of balls, and each ball's share of both: the part that lies in its cell
 * of the balls' power diagram. Shares sum up to the whole. Closed forms, good to about 1e-12 of the whole;
 * of balls that are the same one has the whole share.
 *   centers  count x 3
 *   radii    count, none negative
 * Errors: ARGUMENT, INPUT (kind "ball": not finite, negative radius), LIMIT, MEMORY, CANCELLED.
 * Source: Edelsbrunner, "The union of balls and its dual shape" (1995). */
VBM_API vbm_status vbm_union_measures(vbm_context *context, const double *centers,
                                      const double *radii, size_t count, vbm_measures **out);

VBM_API void vbm_measures_free(vbm_measures *measures);

VBM_API vbm_status vbm_measures_get_report(const vbm_measures *measures,
                                           vbm_measures_report *report);

/* Per ball given, its share of the volume, and of the area. */
VBM_API const double *vbm_measures_ball_volumes(const vbm_measures *measures, size_t *count);
VBM_API const double *vbm_measures_ball_areas(const vbm_measures *measures, size_t *count);

/* ---- Surfaces from balls (8.3) ------------------------------------------------------------------ */

typedef enum vbm_ball_style {
  VBM_BALL_STYLE_SINGULAR_POINTS = 0, /* polygons through the points where three balls meet (8.3)    */
  VBM_BALL_STYLE_SKIN = 1,            /* smooth, round the balls (Edelsbrunner 1999)                  */
  VBM_BALL_STYLE_POWER_CRUST = 2      /* power crust of those points (8.5)                            */
} vbm_ball_style;

typedef struct vbm_ball_surface_options {
  size_t struct_size;
  int32_t style;  /* vbm_ball_style; default SINGULAR_POINTS                                       */
  int32_t errors; /* 1: measure how far surface and union are apart, both ways, for the report; takes
                     several times as long as a surface of singular points; default 0              */
  double bulge;   /* where the middle of a polygon would be farther from its ball's sphere than this
                     share of the radius, vertices on the sphere are added, and on long arcs; skin: where
                     the middle of an edge would be as far from the skin, and edges shorter than a
                     third of it may go; default 0.15, 0.001 to 1. Singular points: no triangle's
                     middle is farther from its sphere than about twice this. Both: where most of the
                     union's area is of balls bare of more than half a steradian, for these it is
                     divided by 5 at the default and above, by less at smaller ones                  */
  double bridge;  /* not of the skin: balls whose radii would meet if they were larger by this share
                     are joined (8.3.5); default 0, 0 to 1                                           */
  double shrink;  /* skin: the shrink factor. Near 1 it is the balls with narrow creases, smaller ones
                     round creases more and bridge wider gaps; default 0.9, 0.05 to 0.99             */
  double narrow;  /* singular points: what is bare of a ball and narrower than this share of the
                     distance between faces (the root of the area there is for a ball), than `bulge`
                     and than 0.15 radii, is closed: its neighbours' faces meet. Without it balls in
                     a tube make faces a hundred times longer than wide. Where most of the area is of
                     such wide balls nothing is closed; default 0.37, 0 to 1                         */
} vbm_ball_surface_options;

VBM_API void vbm_ball_surface_options_init(vbm_ball_surface_options *options, size_t struct_size);

/* A closed surface, oriented outward and manifold, from any balls, without samples or outer balls.
 *
 * SINGULAR_POINTS: about a polygon for each ball. It has the topology of the union's boundary, by
 * construction: of the dual shape of the balls, their radii grown by 1e-8 so that balls that touch do
 * meet. Isolated balls, chains, rings and sheets are fine. Where the surface touches itself, vertices
 * stand twice (split_vertices). Four balls or more through one point give one vertex. What is closed
 * by `narrow` or has other diagonals because of needles changes places, not topology.
 *
 * SKIN: triangles, smooth where balls meet; the balls are inside and touch it. It has the topology of the
 * union of larger balls, radii divided by sqrt(shrink), which may join balls that are apart and close
 * holes between them; so the notes say. Of balls less than about 1e-6 of the whole it may be wrong.
 *
 * POWER_CRUST: the faces between the balls and outer ones, which are the outer polar balls of the
 * singular-point surface's vertices. Its topology is checked against that surface's; where it is another,
 * it is made again with vertices closer together, and if that does not help, the notes say so.
 *
 * vbm_surface_polygon_ball() counts the balls given; vbm_surface_vertex_sample() is -1.
 * Errors: ARGUMENT, INPUT (kind "ball"), NO_INTERIOR (no ball with a radius), LIMIT, MEMORY, CANCELLED.
 * Source: thesis 8.3, 8.5; Edelsbrunner, "The union of balls and its dual shape" (1995), "Deformable
 * smooth surface design" (1999). */
VBM_API vbm_status vbm_surface_from_balls(vbm_context *context, const double *centers,
                                          const double *radii, size_t count,
                                          const vbm_ball_surface_options *options,
                                          vbm_surface **out);

/* The same of a model's inner balls, or of those with 1 in `keep` (one byte per inner ball, or NULL for
 * all). The samples that balls touch are known: duplicate points are told by them (7.4), and
 * vertices that are samples carry exactly their coordinates. Polygon balls count the model's. */
VBM_API vbm_status vbm_model_ball_surface(vbm_context *context, const vbm_model *model,
                                          const uint8_t *keep, size_t keep_count,
                                          const vbm_ball_surface_options *options,
                                          vbm_surface **out);

#ifdef __cplusplus
}
#endif

#endif /* VBM_BALLS_H */
