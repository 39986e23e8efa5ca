/* libvbm: Voronoi ball models of shapes, and closed surfaces back from them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The C interface, C99: this header, and axis.h, medial_mesh.h, balls.h and cluster.h, which it
 * includes. "Thesis" below is R. Tam, "Voronoi Ball Models for Computational Shape Applications";
 * section numbers are its own.
 *
 * Conventions
 *   - Every function that can fail returns a vbm_status. The sentence that says what is wrong and
 *     where is read from the context with vbm_context_message(). Nothing is ever printed, and no
 *     exception, signal, exit or locale change leaves the library.
 *   - `**out` receives a handle the caller owns and frees with the matching vbm_..._free(). It is
 *     set to NULL on failure. Freeing NULL is allowed.
 *   - Input arrays are read during the call only. Points are n x 3 doubles, row by row.
 *   - A view (pointer and count) belongs to its handle and is valid until that handle is freed.
 *     A view of nothing has count 0; its pointer may then be NULL.
 *   - Lengths are in the input's own units. Radii are radii, never squared weights.
 *   - One context is used by one thread at a time; contexts are independent of each other.
 *     Finished models and surfaces are immutable and may be read from any thread.
 *   - Same input and same options give the same bytes, on every host, in every thread, and with
 *     however many threads a call works.
 *   - Option and report structs start with their own size. Fill options with their init function.
 *     A struct from an older header is accepted (missing fields take their defaults), and so is one
 *     from a newer header (fields this library does not know are ignored).
 */
#ifndef VBM_VBM_H
#define VBM_VBM_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#  ifdef VBM_BUILDING
#    define VBM_API __declspec(dllexport)
#  else
#    define VBM_API __declspec(dllimport)
#  endif
#else
#  define VBM_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Version ------------------------------------------------------------------------------- */

/* The ABI's version. It changes only when something existing changes its meaning or layout. */
#define VBM_ABI_VERSION 1

/* The ABI version the loaded library was built with: compare with VBM_ABI_VERSION. */
VBM_API int32_t vbm_abi_version(void);
/* The library's version, "major.minor.patch". Static storage. */
VBM_API const char *vbm_version(void);

/* ---- Status -------------------------------------------------------------------------------- */

/* Values are explicit and only ever appended. */
typedef enum vbm_status {
  VBM_OK = 0,
  VBM_ERROR_ARGUMENT = 1,   /* a NULL, a size or an option out of its range: the caller's mistake */
  VBM_ERROR_INPUT = 2,      /* the data is unusable: not finite, index out of range, ...          */
  VBM_ERROR_DEGENERATE = 3, /* too few points, or points that do not span three dimensions        */
  VBM_ERROR_NO_INTERIOR = 4, /* no inside can be told from the outside: open or not orientable    */
  VBM_ERROR_LIMIT = 5,      /* a resource limit of the options was reached                        */
  VBM_ERROR_MEMORY = 6,     /* out of memory                                                      */
  VBM_ERROR_CANCELLED = 7,  /* the progress callback asked to stop                                */
  VBM_ERROR_INTERNAL = 8    /* a defect in libvbm: please report it with its message              */
} vbm_status;

/* A short English name, "out of memory". Static storage; "unknown status" for other values. */
VBM_API const char *vbm_status_name(vbm_status status);

/* ---- Context ------------------------------------------------------------------------------- */

typedef struct vbm_context vbm_context;

/* Make a context. VBM_ERROR_ARGUMENT if out is NULL, VBM_ERROR_MEMORY if there is none. */
VBM_API vbm_status vbm_context_create(vbm_context **out);
VBM_API void vbm_context_free(vbm_context *context);

/* The message of the last call on this context that failed, one sentence, UTF-8; "" if the last
 * call succeeded. Never NULL. Valid until the next call with this context. */
VBM_API const char *vbm_context_message(const vbm_context *context);

/* Which input elements the last failure is about, so that a host can select them: the kind says
 * what they are ("vertex", "face", "normal", "option", or "" for none). At most the first 4096 are
 * listed; *total, if not NULL, receives how many there were in all. */
VBM_API const int64_t *vbm_context_bad_elements(const vbm_context *context, const char **kind,
                                                size_t *count, size_t *total);

/* Progress: `fraction` goes from 0 to 1 and never down within one call, `stage` names the work.
 * Called on the calling thread only. Return 0 to go on; anything else cancels: the call returns
 * VBM_ERROR_CANCELLED soon after (under 100 ms on a million samples) and every handle stays usable.
 * The callback must not call into the same context. NULL removes it. */
typedef int (*vbm_progress_fn)(void *user, double fraction, const char *stage);
VBM_API void vbm_context_set_progress(vbm_context *context, vbm_progress_fn progress, void *user);

/* Threads: calls with this context work with no more than `most` of them at once, the calling one
 * included; with 0 or less, as at first, with as many as there are processors for the process. Those
 * that are started take none of the host's signals and have ended when the call returns. */
VBM_API void vbm_context_set_threads(vbm_context *context, int32_t most);

/* ---- Building a ball model (thesis 3.1) ------------------------------------------------------ */

typedef struct vbm_model vbm_model;

/* Which inside Voronoi balls make the model (Figure 3.4). */
typedef enum vbm_balls {
  VBM_BALLS_POLAR = 0,  /* the inner pole of every sample (Amenta, Choi, Kolluri): smooth, fewer */
  VBM_BALLS_VORONOI = 1 /* every inside Voronoi ball (Ranjan's union of spheres)                 */
} vbm_balls;

/* How inside is told from outside (3.1.2). */
typedef enum vbm_labels {
  VBM_LABELS_AUTO = 0,        /* the best the input offers, in the order of the list below          */
  VBM_LABELS_NORMALS = 1,     /* face normals of a mesh, or the normals given with points           */
  VBM_LABELS_PROPAGATION = 2, /* from the outside inwards over the balls (Amenta), no normals used  */
  VBM_LABELS_VOXELS = 3,      /* the voxel nearest the ball's centre; volumes only                  */
  VBM_LABELS_SCAN = 4         /* scan directions; range scans only                                  */
} vbm_labels;

typedef struct vbm_build_options {
  size_t struct_size;
  int32_t balls;         /* vbm_balls; default POLAR                                              */
  int32_t labels;        /* vbm_labels; default AUTO                                              */
  double spacing;        /* meshes: no gap between samples on faces and edges exceeds this length;
                            0 (default) chooses it, smaller where it is thin; negative: vertices */
  double undersampling;  /* a sample is reported as too thinly sampled where the nearest samples
                            on the surface are farther than this times its local feature size
                            (3.2.2, r-sample); default 0.7, range 0.05 to 1                       */
  int32_t drop_invalid;  /* nonzero: leave out points that are not finite (and the faces using
                            them), counting them; 0 (default): refuse the input, naming the first */
  int32_t refine;        /* meshes: nonzero (default) adds samples where a ball still contains a
                            piece of the mesh after the first sampling, as thin parts need        */
  uint64_t sample_limit; /* VBM_ERROR_LIMIT beyond so many samples; 0 (default): 20 million       */
  uint64_t cell_limit;   /* VBM_ERROR_LIMIT beyond so many Delaunay tetrahedra; 0 (default): one
                            million plus 40 per sample. Curves in space make them grow as n * n   */
} vbm_build_options;

/* Fill with defaults. `struct_size` is sizeof(vbm_build_options) in the caller's header. */
VBM_API void vbm_build_options_init(vbm_build_options *options, size_t struct_size);

/* Balls from points (a scan without scanner positions, or a mesh whose faces are to be ignored).
 *   points   count x 3
 *   normals  count x 3 outward normals of any length, or NULL. A zero normal means "unknown here".
 *   options  NULL for defaults
 * Errors: INPUT (not finite: names the first vertex and how many), DEGENERATE, NO_INTERIOR, LIMIT,
 * MEMORY, CANCELLED. Source: thesis 3.1; Amenta, Choi, Kolluri, "The power crust" (2001). */
VBM_API vbm_status vbm_build_points(vbm_context *context, const double *points, size_t count,
                                    const double *normals, const vbm_build_options *options,
                                    vbm_model **out);

/* Balls from a triangle or polygon mesh, closed or open.
 *   vertices     vertex_count x 3
 *   face_sizes   face_count corner counts, or NULL if every face is a triangle
 *   corners      the faces' vertex indices, one face after another: 3 * face_count or the sum of
 *                face_sizes; corner_count says how many there are, for checking
 * Samples are all vertices used by a face, plus points on edges and faces as `spacing` says.
 * Faces with fewer than three different corners are skipped and counted. With NORMALS a face's front
 * (counter-clockwise) is outside; a closed mesh that is inside out as a whole is taken as upright and
 * said so. Space that closed shells wind round more than once (nested shells of one direction,
 * overlapping solids) is inside: the union. Samples where one shell runs inside another are no
 * boundary of it: they are left out, and vertices among them counted as dropped. Faces whose
 * directions contradict each other are reported, and the labels then come from propagation.
 * Errors: as vbm_build_points; INPUT also for corners out of range. */
VBM_API vbm_status vbm_build_mesh(vbm_context *context, const double *vertices, size_t vertex_count,
                                  const uint32_t *face_sizes, const int32_t *corners,
                                  size_t corner_count, size_t face_count,
                                  const vbm_build_options *options, vbm_model **out);

/* Element type of a volume. */
typedef enum vbm_scalar {
  VBM_SCALAR_UINT8 = 0,
  VBM_SCALAR_UINT16 = 1,
  VBM_SCALAR_INT16 = 2,
  VBM_SCALAR_FLOAT = 3,
  VBM_SCALAR_DOUBLE = 4
} vbm_scalar;

/* Balls from a volume (CT, MRI, a mask, a distance field).
 *   values   nx * ny * nz numbers; voxel (i, j, k) is values[(i * ny + j) * nz + k] and its centre is
 *            origin + (i * voxel_size[0], j * voxel_size[1], k * voxel_size[2])
 *   origin   3 numbers, or NULL for 0
 *   level    voxels with a value >= level are inside. Samples lie on the grid edges between inside
 *            and outside voxels, at the level by linear interpolation (in the middle for a mask whose
 *            two values straddle it so). Shapes that touch the border are closed there.
 * Source: thesis 3.1.2 and Theorem 3.2. */
VBM_API vbm_status vbm_build_volume(vbm_context *context, const void *values, vbm_scalar type,
                                    size_t nx, size_t ny, size_t nz, const double voxel_size[3],
                                    const double *origin, double level,
                                    const vbm_build_options *options, vbm_model **out);

/* Balls from range scans: points, and where the scanner stood when it saw each.
 *   scanners          scanner_count x 3 positions
 *   scanner_of_point  count indices into scanners; NULL if scanner_count is 1 or equals count
 * Source: thesis 3.1.2 (scan direction test). */
VBM_API vbm_status vbm_build_range_scan(vbm_context *context, const double *points, size_t count,
                                        const double *scanners, size_t scanner_count,
                                        const int32_t *scanner_of_point,
                                        const vbm_build_options *options, vbm_model **out);

VBM_API void vbm_model_free(vbm_model *model);

/* ---- Reading a ball model -------------------------------------------------------------------- */

typedef struct vbm_model_report {
  size_t struct_size;
  int32_t rule;               /* vbm_labels actually used: never AUTO                             */
  int32_t flipped;            /* 1: the mesh was inside out and was taken as upright              */
  uint64_t input_points;      /* vertices, points or voxels given                                 */
  uint64_t dropped;           /* points left out: not finite, of no face, or where parts of a mesh
                                 run inside others                                                */
  uint64_t merged;            /* points merged into an earlier one within 2e-11 of the size       */
  uint64_t added;             /* samples added on faces and edges                                 */
  uint64_t samples;           /* samples in the Delaunay triangulation                            */
  uint64_t cells;             /* Delaunay tetrahedra                                              */
  uint64_t inner_balls;
  uint64_t outer_balls;
  uint64_t exact_centers;     /* centres that doubles could not give and exact numbers did        */
  uint64_t undersampled;      /* samples where the sampling is too thin to trust the surface      */
  uint64_t unused_samples;    /* samples not on the interpolating surface                         */
  uint64_t skipped_faces;     /* faces with fewer than three different corners                    */
  uint64_t open_loops;        /* boundary loops of the mesh                                       */
  uint64_t inconsistent_edges; /* edges whose two faces contradict each other, or with 3 or more  */
  double spacing;             /* spacing used on the mesh; 0 where no samples were added          */
  double diagonal;            /* bounding-box diagonal of the samples                             */
} vbm_model_report;

/* Fill *report; report->struct_size must be set by the caller. */
VBM_API vbm_status vbm_model_get_report(const vbm_model *model, vbm_model_report *report);

/* What a user should know about this model, one sentence a line, each ending in '\n'; "" if there is
 * nothing to say. Owned by the model. */
VBM_API const char *vbm_model_notes(const vbm_model *model);

/* Balls, the inner ones first: centres (count x 3), radii (count), inside (count bytes, 1 or 0), and
 * how many are inner. Outer balls are always the outer polar balls. */
VBM_API const double *vbm_model_centers(const vbm_model *model, size_t *count);
VBM_API const double *vbm_model_radii(const vbm_model *model, size_t *count);
VBM_API const uint8_t *vbm_model_inside(const vbm_model *model, size_t *count);
VBM_API size_t vbm_model_inner_count(const vbm_model *model);

/* The samples each ball touches: ball b touches indices[offsets[b]] to indices[offsets[b+1]-1].
 * *offsets has (number of balls + 1) entries; the return value is the index array, *count long.
 * A ball whose samples are cospherical touches more than four; corners of the closing box, which are
 * not samples, are left out. */
VBM_API const int32_t *vbm_model_ball_samples(const vbm_model *model, const uint64_t **offsets,
                                              size_t *count);
/* The neighbours of each ball, in the same form: balls of the same side whose Delaunay tetrahedra share
 * a facet, or one of which is the polar ball of a sample the other touches. All touch a common sample, so
 * that their surfaces certainly meet. Ascending, symmetric. */
VBM_API const int32_t *vbm_model_ball_neighbors(const vbm_model *model, const uint64_t **offsets,
                                                size_t *count);

/* Samples, count x 3; those that are input points carry exactly the input's coordinates. */
VBM_API const double *vbm_model_samples(const vbm_model *model, size_t *count);
/* For every sample the input point it is, or -1 (added on a face or edge, or from a volume). */
VBM_API const int32_t *vbm_model_sample_input(const vbm_model *model, size_t *count);
/* For every input point its sample (shared by merged points), or -1 if it was dropped. */
VBM_API const int32_t *vbm_model_input_sample(const vbm_model *model, size_t *count);
/* Samples where the sampling is too thin to trust the surface, ascending (thesis 7.9). */
VBM_API const int32_t *vbm_model_undersampled(const vbm_model *model, size_t *count);

/* Medial radii per input point (per sample for volumes): the radius of the inner / outer polar ball.
 * Thickness is twice the inner one; local feature size is about the smaller of both. NaN where there
 * is none (dropped point, sample inside the solid), infinity where the outside is not curved in. */
VBM_API const double *vbm_model_inner_radius(const vbm_model *model, size_t *count);
VBM_API const double *vbm_model_outer_radius(const vbm_model *model, size_t *count);

/* ---- Surfaces --------------------------------------------------------------------------------- */

typedef struct vbm_surface vbm_surface;

/* The interpolating surface: the boundary of the inside Delaunay tetrahedra, closed, oriented outward
 * and manifold; its vertices are samples. Where tetrahedra meet only along an edge or at a vertex, the
 * surface is split there, so that one sample can give several vertices.
 * Errors: NO_INTERIOR, MEMORY, CANCELLED. */
VBM_API vbm_status vbm_model_surface(vbm_context *context, const vbm_model *model,
                                     vbm_surface **out);

/* The power crust (8.2): the faces of the power diagram between inner and outer polar balls, oriented
 * outward, closed and manifold. A vertex at which all balls share a sample is that sample. The other
 * samples, a few in a hundred, lie within or beside a face: seen up to an eighth of the distance to the
 * nearest sample away from it, as vertices much nearer to each other than samples are made one.
 * Made of all balls, it has the components and handles of the inside tetrahedra: where polar balls alone do
 * not give them, for lack of samples, Voronoi balls are added on both sides; with all of them the crust is
 * the interpolating surface, which a note says.
 *   keep        NULL for all inner balls, or one byte per inner ball: the balls with 0 leave the
 *               diagram, and what they filled becomes outside
 *   keep_count  must be vbm_model_inner_count() if keep is given
 * Errors: ARGUMENT, NO_INTERIOR (nothing kept), MEMORY, CANCELLED.
 * Source: Amenta, Choi, Kolluri, "The power crust, unions of balls, and the medial axis transform". */
VBM_API vbm_status vbm_model_power_crust(vbm_context *context, const vbm_model *model,
                                         const uint8_t *keep, size_t keep_count, vbm_surface **out);

VBM_API void vbm_surface_free(vbm_surface *surface);

typedef struct vbm_surface_report {
  size_t struct_size;
  uint64_t vertices, triangles, polygons;
  uint64_t components;    /* connected components of the surface (an inner cavity's wall counts)   */
  int64_t euler;          /* Euler characteristic                                                  */
  int64_t genus;          /* handles in all: components - euler / 2                                */
  uint64_t split_vertices; /* vertices that stand where another stands, to keep the surface manifold */
  double area, volume;    /* of the triangles; volume is positive                                  */
  /* Surfaces from balls (balls.h); 0 for others. */
  uint64_t hidden_balls;    /* balls that have no part in the union's boundary or inside: covered, points */
  uint64_t singular_points; /* where three balls' spheres meet, on the union's boundary              */
  uint64_t merged_points;   /* of them, those that became one with another                           */
  uint64_t offset_points;   /* of them, those where three balls do not meet (8.3.5)                  */
  uint64_t added_points;    /* vertices that are no singular points: on arcs and within patches      */
  double gap_max, gap_mean; /* distance of triangles' middles from the spheres they stand for; the mean is
                               by area                                                              */
  /* With vbm_ball_surface_options.errors: distances between the surface and the boundary of the union of the
   * balls, at points of both. From the surface: its vertices, the middles of its triangles, and for the mean
   * points spread evenly; within the union never less than the distance. From the union's boundary: four
   * points or more for each ball.                                                                        */
  double surface_error_max, surface_error_mean; /* from the surface to the union's boundary         */
  double union_error_max, union_error_mean;     /* from the union's boundary to the surface         */
} vbm_surface_report;

VBM_API vbm_status vbm_surface_get_report(const vbm_surface *surface, vbm_surface_report *report);

/* What a user should know about this surface, as vbm_model_notes(). */
VBM_API const char *vbm_surface_notes(const vbm_surface *surface);

/* Vertices, count x 3. */
VBM_API const double *vbm_surface_vertices(const vbm_surface *surface, size_t *count);
/* Triangles, count x 3 vertex indices, counter-clockwise seen from outside. */
VBM_API const int32_t *vbm_surface_triangles(const vbm_surface *surface, size_t *count);
/* Polygons in the form of vbm_model_ball_samples(); for the interpolating surface these are its
 * triangles, for the power crust its faces. The triangles above are these polygons cut up. */
VBM_API const int32_t *vbm_surface_polygons(const vbm_surface *surface, const uint64_t **offsets,
                                            size_t *count);
/* For every triangle its polygon. */
VBM_API const int32_t *vbm_surface_triangle_polygon(const vbm_surface *surface, size_t *count);
/* For every polygon the inner ball behind it (index into the model's balls); -1 where there is none. */
VBM_API const int32_t *vbm_surface_polygon_ball(const vbm_surface *surface, size_t *count);
/* For every vertex the sample it coincides with, or -1; and the input point, or -1. */
VBM_API const int32_t *vbm_surface_vertex_sample(const vbm_surface *surface, size_t *count);
VBM_API const int32_t *vbm_surface_vertex_input(const vbm_surface *surface, size_t *count);
/* For every vertex the radius of an inner ball it touches: the polar ball of its sample, or the
 * largest ball of the polygons round it. */
VBM_API const double *vbm_surface_vertex_radius(const vbm_surface *surface, size_t *count);

/* ---- Parameters: one table from which every host builds its dialogs ----------------------------- */

typedef enum vbm_param_type {
  VBM_PARAM_BOOL = 0,
  VBM_PARAM_INT = 1,
  VBM_PARAM_FLOAT = 2,  /* no unit */
  VBM_PARAM_LENGTH = 3, /* in the input's units; 0 usually means "choose" */
  VBM_PARAM_ENUM = 4
} vbm_param_type;

typedef struct vbm_param {
  size_t struct_size;      /* in: sizeof(vbm_param) */
  const char *operation;   /* "build", "power_crust", ... */
  const char *name;        /* as in the option struct: "spacing" */
  const char *label;       /* for dialogs: "Sample Spacing" */
  const char *help;        /* one line */
  const char *unit;        /* "length", "ratio", "" */
  int32_t type;            /* vbm_param_type */
  int32_t enum_count;      /* ENUM: number of items */
  const char *const *enum_names;  /* ENUM: identifiers, by value from 0: "polar" */
  const char *const *enum_labels; /* ENUM: for dialogs: "Polar balls" */
  const char *const *enum_helps;  /* ENUM: one line each */
  double default_value, minimum, maximum;
} vbm_param;

/* How many parameters all operations have together, and the index-th of them. Strings are static.
 * ARGUMENT if index is out of range. */
VBM_API size_t vbm_param_count(void);
VBM_API vbm_status vbm_param_describe(size_t index, vbm_param *param);

#ifdef __cplusplus
}
#endif

#include "axis.h" /* the medial axis, its parts, simplification */
#include "balls.h" /* unions of any balls: measures, surfaces */
#include "cluster.h" /* fewer balls */

#endif /* VBM_VBM_H */
