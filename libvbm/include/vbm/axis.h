/* libvbm: the medial axis of a ball model, its parts, and simplification (thesis 7).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Included by vbm.h, whose conventions hold here. An axis is immutable: pruning gives a new one, and
 * undoing is going back to the one before. An axis keeps what it needs of its model; the model may
 * be freed first.
 */
#ifndef VBM_AXIS_H
#define VBM_AXIS_H

#include "vbm.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- The medial axis (7.3, 7.4) ---------------------------------------------------------------- */

typedef struct vbm_axis vbm_axis;

/* How an axis is constructed. */
typedef enum vbm_axis_method {
  VBM_AXIS_VORONOI = 0,    /* from the Voronoi diagram of the samples                                */
  VBM_AXIS_POWER_SHAPE = 1 /* from the power shape: the Voronoi diagram of the singular points of the
                              model's balls (7.3.1, 7.4); slower                                     */
} vbm_axis_method;

typedef struct vbm_axis_options {
  size_t struct_size;
  double angle; /* degrees, 0 to 180, default 45: a piece of the Voronoi diagram is axis where the two
                   samples it is equidistant from are seen under at least this angle, ...            */
  double ratio; /* ... or are at least this many times farther apart than neighbouring samples;
                   default 8, at least 1                                                             */
  int32_t method; /* vbm_axis_method; default VORONOI                                                */
  int32_t reserved; /* 0; room for what may be added, so that no byte is left without a meaning */
} vbm_axis_options;

VBM_API void vbm_axis_options_init(vbm_axis_options *options, size_t struct_size);

/* The medial axis: a Voronoi diagram inside the shape, with all that tells nothing about the shape
 * collapsed away. With VORONOI it is that of the samples; with POWER_SHAPE that of the singular points,
 * where three balls of the model's power shape meet, and of the samples: the axis of the union of the
 * balls. Where that union has another topology than the shape, fewer singular points are used, which
 * vbm_axis_notes() says. It has the Betti numbers of the solid (of the open interior of its tetrahedra),
 * because every step is an elementary collapse. Vertices are balls: no two share a place's cell, every
 * face is a triangle, edges that are not a triangle's are curves.
 *   options  NULL for defaults
 * Errors: ARGUMENT, MEMORY, CANCELLED.
 * Source: thesis 7.3, 7.4; Dey, Zhao, "Approximating the medial axis from the Voronoi diagram with a
 * convergence guarantee" (2004), for what is kept; Amenta, Kolluri, "The medial axis of a union of
 * balls" (2001), for POWER_SHAPE. */
VBM_API vbm_status vbm_model_medial_axis(vbm_context *context, const vbm_model *model,
                                         const vbm_axis_options *options, vbm_axis **out);

VBM_API void vbm_axis_free(vbm_axis *axis);

typedef struct vbm_axis_report {
  size_t struct_size;
  uint64_t vertices, triangles;
  uint64_t edges;      /* in all, those of triangles too                                        */
  uint64_t curve_edges; /* of no triangle                                                       */
  uint64_t parts;
  uint64_t components; /* connected pieces: Betti number 0                                      */
  int64_t euler;       /* vertices - edges + triangles                                          */
  double volume;       /* share of the solid's tetrahedra that the balls left stand for, 0 to 1 */
} vbm_axis_report;

VBM_API vbm_status vbm_axis_get_report(const vbm_axis *axis, vbm_axis_report *report);

/* What the operation that made this axis has to say, as vbm_model_notes(). */
VBM_API const char *vbm_axis_notes(const vbm_axis *axis);

/* Vertices: centres (count x 3) and radii (count). */
VBM_API const double *vbm_axis_vertices(const vbm_axis *axis, size_t *count);
VBM_API const double *vbm_axis_radii(const vbm_axis *axis, size_t *count);
/* Triangles, count x 3 vertex indices; for each the two samples it is equidistant from (count x 2,
 * samples of the model; with POWER_SHAPE those nearest to the two singular points), and its part. */
VBM_API const int32_t *vbm_axis_triangles(const vbm_axis *axis, size_t *count);
VBM_API const int32_t *vbm_axis_triangle_samples(const vbm_axis *axis, size_t *count);
/* For each triangle the two places it is exactly equidistant from (count x 6): its samples', or with
 * POWER_SHAPE those of its singular points. */
VBM_API const double *vbm_axis_triangle_points(const vbm_axis *axis, size_t *count);
VBM_API const int32_t *vbm_axis_triangle_part(const vbm_axis *axis, size_t *count);
/* The feature's width at each triangle: the distance of the two places, in the input's units. The object
 * angle, degrees, 0 to 180: that under which they are seen from the triangle's ball, the mean of its
 * corners'; 2 asin(width / (2 radius)). The largest of a part's are vbm_part.width and angle. */
VBM_API const double *vbm_axis_triangle_width(const vbm_axis *axis, size_t *count);
VBM_API const double *vbm_axis_triangle_angle(const vbm_axis *axis, size_t *count);
/* Curves: edges of no triangle, count x 2 vertex indices, and the part of each. */
VBM_API const int32_t *vbm_axis_curves(const vbm_axis *axis, size_t *count);
VBM_API const int32_t *vbm_axis_curve_part(const vbm_axis *axis, size_t *count);
/* Their widths and object angles, as of triangles. A curve's edge is equidistant from three samples; its
 * width is the smallest distance of two of them (about 1.7 radii in a round tube). */
VBM_API const double *vbm_axis_curve_width(const vbm_axis *axis, size_t *count);
VBM_API const double *vbm_axis_curve_angle(const vbm_axis *axis, size_t *count);

/* ---- Parts (7.5.1) ------------------------------------------------------------------------------ */

/* Why a part cannot be removed now. */
typedef enum vbm_lock {
  VBM_LOCK_NONE = 0,   /* it can                                                              */
  VBM_LOCK_INNER = 1,  /* it has no border, so the parts around it must go first              */
  VBM_LOCK_TUNNEL = 2, /* a tunnel or cavity of the shape would be lost                       */
  VBM_LOCK_BRIDGE = 3, /* the shape would fall apart                                          */
  VBM_LOCK_LAST = 4    /* it is all that is left of a piece of the shape                      */
} vbm_lock;

/* A lock in words, for messages: "the shape would fall apart". "" for VBM_LOCK_NONE and for numbers that
 * are no lock. The text lives as long as the library. */
VBM_API const char *vbm_lock_text(int32_t lock);

typedef struct vbm_part {
  int32_t level;       /* 1: has a border; 2: touches a part of level 1; ...; 0: no border is near    */
  int32_t lock;        /* vbm_lock                                                                    */
  uint64_t triangles;  /* 0 for a curve                                                               */
  uint64_t curve_edges; /* 0 for a sheet                                                              */
  double area;         /* of a sheet                                                                  */
  double length;       /* of a curve                                                                  */
  double volume;       /* share, 0 to 1, of the solid's tetrahedra that go with it (7.5.2)            */
  double width;        /* largest vbm_axis_triangle_width(), or of a curve vbm_axis_curve_width()     */
  double angle;        /* degrees: largest vbm_axis_triangle_angle() or vbm_axis_curve_angle()        */
  double position[3];  /* its middle                                                                  */
} vbm_part;

/* The parts: sheets, whose triangles hang together across edges of exactly two triangles, and curves. */
VBM_API const vbm_part *vbm_axis_parts(const vbm_axis *axis, size_t *count);
/* The model's inner balls that go with each part, in the form of vbm_model_ball_samples(); balls on
 * contact curves go with none. */
VBM_API const int32_t *vbm_axis_part_balls(const vbm_axis *axis, const uint64_t **offsets,
                                           size_t *count);
/* The topology graph (7.5.3): its nodes are contact curves, connected ones taken together; parts are
 * what joins them. Positions of the nodes (count x 3), and for every part the nodes it touches. */
VBM_API const double *vbm_axis_nodes(const vbm_axis *axis, size_t *count);
VBM_API const int32_t *vbm_axis_part_nodes(const vbm_axis *axis, const uint64_t **offsets,
                                           size_t *count);
/* The contact curves themselves (7.5.1): edges at which triangles of two parts or more meet, count x 2
 * vertex indices, and for each its node of the topology graph. A node where a curve meets other parts
 * is a vertex, and may have no edge. */
VBM_API const int32_t *vbm_axis_contact_edges(const vbm_axis *axis, size_t *count);
VBM_API const int32_t *vbm_axis_contact_node(const vbm_axis *axis, size_t *count);
/* For every inner ball of the model 1 if it is left, 0 if it went with a part that was removed. */
VBM_API const uint8_t *vbm_axis_kept_balls(const vbm_axis *axis, size_t *count);
/* The exact volume that goes with each part: the share, 0 to 1, of the union of all the model's inner
 * balls; a ball's is the union's part in its power cell. It is found when first asked for, once for an
 * axis and all pruned from it (that takes about as long as the axis did). *shares, a number a part,
 * belongs to the axis; it is NULL on failure.
 * Errors: ARGUMENT, MEMORY, CANCELLED. Source: thesis 7.9; Edelsbrunner, "The union of balls and its
 * dual shape" (1995). */
VBM_API vbm_status vbm_axis_part_ball_volumes(vbm_context *context, const vbm_axis *axis,
                                              const double **shares, size_t *count);

/* ---- Pruning (7.5.2, 7.5.3) --------------------------------------------------------------------- */

/* How significant a part is. */
typedef enum vbm_measure {
  VBM_MEASURE_TRIANGLES = 0, /* its triangles; of a curve its edges                               */
  VBM_MEASURE_VOLUME = 1,    /* vbm_part.volume: its share of the tetrahedra, 0 to 1              */
  VBM_MEASURE_WIDTH = 2,     /* vbm_part.width over the model's bounding-box diagonal             */
  VBM_MEASURE_ANGLE = 3,     /* vbm_part.angle, degrees                                           */
  VBM_MEASURE_BALLS = 4      /* its share of the balls' exact volume: vbm_axis_part_ball_volumes() */
} vbm_measure;

typedef struct vbm_prune_options {
  size_t struct_size;
  int32_t measure;    /* vbm_measure; default TRIANGLES                                       */
  int32_t iterations; /* how often parts are found anew and pruned; default 1, 1 to 1000      */
  double threshold;   /* parts of level 1 up to this go, least significant first; 0: none; default 5 */
} vbm_prune_options;

VBM_API void vbm_prune_options_init(vbm_prune_options *options, size_t struct_size);

/* Remove the parts of level 1 that are not more significant than the threshold, least significant
 * first, where the topology stays; vbm_axis_stayed() lists those that had to stay.
 * Errors: ARGUMENT, MEMORY, CANCELLED. Source: thesis 7.5.2, 7.5.3. */
VBM_API vbm_status vbm_axis_prune(vbm_context *context, const vbm_axis *axis,
                                  const vbm_prune_options *options, vbm_axis **out);

/* Several prunings in one call, each of what the one before left, as in the scheme of 7.7: few triangles
 * twice, then a per cent of the volume. Views are made, and one axis, at the end only.
 *   steps, count  pointers to options; NULL for defaults. None at all: the axis as it is
 * Errors: as vbm_axis_prune(), saying which of several steps, from 0. */
VBM_API vbm_status vbm_axis_prune_steps(vbm_context *context, const vbm_axis *axis,
                                        const vbm_prune_options *const *steps, size_t count,
                                        vbm_axis **out);

/* Of an axis that pruning made: its parts of level 1 that are not more significant than the threshold
 * and had to stay, least significant first, and *locks, as many, says why (vbm_lock). After several
 * steps those of the first, then those of the next that are not yet listed, ...; all of them parts that
 * are left at the end. */
VBM_API const int32_t *vbm_axis_stayed(const vbm_axis *axis, const int32_t **locks, size_t *count);

/* Remove the parts with these numbers, outer ones first: a part may go when others that are named
 * have gone. All go, or none.
 * Errors: INPUT (parts that cannot go: says which and why, kind "part"), ARGUMENT, MEMORY,
 * CANCELLED. Source: thesis 7.7, Figure 7.13. */
VBM_API vbm_status vbm_axis_remove_parts(vbm_context *context, const vbm_axis *axis,
                                         const int32_t *parts, size_t count, vbm_axis **out);
/* The same for the parts that these triangles of vbm_axis_triangles() belong to.
 * Errors: as vbm_axis_remove_parts(); INPUT also for a triangle that is not there, kind "triangle". */
VBM_API vbm_status vbm_axis_remove_triangles(vbm_context *context, const vbm_axis *axis,
                                             const int32_t *triangles, size_t count,
                                             vbm_axis **out);

/* ---- The simplified shape (7.6) ------------------------------------------------------------------ */

typedef struct vbm_axis_surface_options {
  size_t struct_size;
  int32_t drop_outer; /* nonzero: outer balls that touch only samples of removed parts leave as well, for
                         sharper corners (7.6); default 0                                            */
  int32_t reserved; /* 0; room for what may be added, so that no byte is left without a meaning */
} vbm_axis_surface_options;

VBM_API void vbm_axis_surface_options_init(vbm_axis_surface_options *options, size_t struct_size);

/* The power crust of the balls that are left. Its components and handles are those of the model's
 * solid: that is checked, and where the balls left do not give them, the parts removed last are taken
 * back for the surface, one after another, until they do (vbm_surface_notes() says how many).
 * Errors: ARGUMENT, MEMORY, CANCELLED. Source: thesis 7.6. */
VBM_API vbm_status vbm_axis_surface(vbm_context *context, const vbm_axis *axis,
                                    const vbm_axis_surface_options *options, vbm_surface **out);

#ifdef __cplusplus
}
#endif

#include "medial_mesh.h" /* the axis of N balls, curve skeletons */

#endif /* VBM_AXIS_H */
