/* libvbm: unions of balls from anywhere: exact measures (thesis 7.9, 8.3).
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

#ifdef __cplusplus
}
#endif

#endif /* VBM_BALLS_H */
