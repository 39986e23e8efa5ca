// SPDX-License-Identifier: GPL-3.0-or-later
// The parameter table: one description of every option, from which each host builds its dialogs and
// the Python module its signatures. Defaults here and in vbm_build_options_init() must be the same;
// a test compares them.
#include <vbm/vbm.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
// Hosts keep whole numbers in 32 bits, and so do the library's indices.
constexpr double kMaxCount = std::numeric_limits<int32_t>::max();

constexpr const char *kBallsNames[] = {"polar", "voronoi"};
constexpr const char *kBallsLabels[] = {"Polar Balls", "All Voronoi Balls"};
constexpr const char *kBallsHelps[] = {
    "One ball at every sample, the largest inside it: smooth, and few",
    "Every inside Voronoi ball: many more, small ones at the surface among them"};

constexpr const char *kLabelsNames[] = {"auto", "normals", "propagation", "voxels", "scan"};
constexpr const char *kLabelsLabels[] = {"Automatic", "Normals", "Propagation", "Nearest Voxel",
                                         "Scan Directions"};
constexpr const char *kLabelsHelps[] = {
    ("The best rule the input offers: normals, then propagation; voxels for volumes, scan "
     "directions for range scans"),
    "Face normals of a mesh, or the normals given with points",
    "From the outside inwards, from ball to ball; no normals needed",
    "The voxel nearest the ball's centre; for volumes",
    "From where the scanner stood; for range scans"};

constexpr const char *kMethodNames[] = {"voronoi", "power_shape"};
constexpr const char *kMethodLabels[] = {"Voronoi Diagram", "Power Shape"};
constexpr const char *kMethodHelps[] = {
    "From the Voronoi diagram of the samples: fast",
    "From the Voronoi diagram of the balls' singular points: the axis of the balls, slower"};

constexpr const char *kMeasureNames[] = {"triangles", "volume", "width", "angle", "balls"};
constexpr const char *kMeasureLabels[] = {"Triangles", "Volume", "Width", "Angle",
                                          "Volume of Balls"};
constexpr const char *kMeasureHelps[] = {
    "How many triangles the part has; a curve, how many edges",
    "Its share of the shape's tetrahedra by volume, 0 to 1",
    "How wide the feature is, as a share of the bounding box's diagonal",
    "The angle in degrees under which its two sides are seen from the axis",
    "Its share of the exact volume of all the inner balls together, 0 to 1"};

constexpr const char *kBallStyleNames[] = {"singular_points", "skin", "power_crust"};
constexpr const char *kBallStyleLabels[] = {"Singular Points", "Skin", "Power Crust"};
constexpr const char *kBallStyleHelps[] = {
    "About one polygon a ball, through the points where three balls meet",
    "Smooth, round the balls, with creases filled in; has the topology of slightly larger balls",
    "Power crust of the points where three balls meet, with the balls inside it"};

constexpr const char *kClusterMeasureNames[] = {"enclosing", "union"};
constexpr const char *kClusterMeasureLabels[] = {"Enclosing Ball", "Union of Balls"};
constexpr const char *kClusterMeasureHelps[] = {
    "A cluster's largest ball against the ball that encloses the cluster",
    "All balls round the enclosing ball's sphere: as exact, and fewer balls; takes longer"};

// By row: operation, name, label, help, unit, type, items of an enum, default, minimum, maximum.
constexpr vbm_param kParams[] = {
    {sizeof(vbm_param), "build", "balls", "Balls", "Which of the balls inside the shape are kept",
     "", VBM_PARAM_ENUM, 2, kBallsNames, kBallsLabels, kBallsHelps, VBM_BALLS_POLAR,
     VBM_BALLS_POLAR, VBM_BALLS_VORONOI},
    {sizeof(vbm_param), "build", "labels", "Inside From",
     "How the inside of the shape is told from the outside", "", VBM_PARAM_ENUM, 5, kLabelsNames,
     kLabelsLabels, kLabelsHelps, VBM_LABELS_AUTO, VBM_LABELS_AUTO, VBM_LABELS_SCAN},
    {sizeof(vbm_param), "build", "spacing", "Sample Spacing",
     "Meshes: widest gap left between samples on faces and edges; 0 chooses it from the mesh, a "
     "negative value takes the vertices alone",
     "length", VBM_PARAM_LENGTH, 0, nullptr, nullptr, nullptr, 0, -1, kNoLimit},
    {sizeof(vbm_param), "build", "undersampling", "Undersampling Limit",
     "Report a sample as too thinly sampled where its neighbours are farther away than this times "
     "its local feature size",
     "ratio", VBM_PARAM_FLOAT, 0, nullptr, nullptr, nullptr, 0.7, 0.05, 1},
    {sizeof(vbm_param), "build", "drop_invalid", "Drop Invalid Points",
     "Leave out points that are not finite, and the faces using them, instead of refusing the "
     "input",
     "", VBM_PARAM_BOOL, 0, nullptr, nullptr, nullptr, 0, 0, 1},
    {sizeof(vbm_param), "build", "refine", "Refine Thin Parts",
     "Meshes: add samples where a ball still contains a piece of the mesh, as thin parts need", "",
     VBM_PARAM_BOOL, 0, nullptr, nullptr, nullptr, 1, 0, 1},
    {sizeof(vbm_param), "build", "sample_limit", "Sample Limit",
     "Stop with an error beyond so many samples; 0 stands for 20 million", "", VBM_PARAM_INT, 0,
     nullptr, nullptr, nullptr, 0, 0, kMaxCount},
    {sizeof(vbm_param), "build", "cell_limit", "Tetrahedron Limit",
     "Stop with an error beyond so many Delaunay tetrahedra; 0 stands for one million plus 40 per "
     "sample",
     "", VBM_PARAM_INT, 0, nullptr, nullptr, nullptr, 0, 0, kMaxCount},
    {sizeof(vbm_param), "medial_axis", "method", "Construction", "How the axis is constructed", "",
     VBM_PARAM_ENUM, 2, kMethodNames, kMethodLabels, kMethodHelps, VBM_AXIS_VORONOI,
     VBM_AXIS_VORONOI, VBM_AXIS_POWER_SHAPE},
    {sizeof(vbm_param), "medial_axis", "angle", "Object Angle",
     "A piece is axis where the two samples it is equidistant from are seen under at least this "
     "angle",
     "degrees", VBM_PARAM_FLOAT, 0, nullptr, nullptr, nullptr, 45, 0, 180},
    {sizeof(vbm_param), "medial_axis", "ratio", "Distance Ratio",
     "Or where they are at least this many times farther apart than neighbouring samples", "ratio",
     VBM_PARAM_FLOAT, 0, nullptr, nullptr, nullptr, 8, 1, kNoLimit},
    {sizeof(vbm_param), "prune", "measure", "Measure", "How significant a part of the axis is", "",
     VBM_PARAM_ENUM, 5, kMeasureNames, kMeasureLabels, kMeasureHelps, VBM_MEASURE_TRIANGLES,
     VBM_MEASURE_TRIANGLES, VBM_MEASURE_BALLS},
    {sizeof(vbm_param), "prune", "threshold", "Threshold",
     "Parts at the border that are not more significant than this go, where the topology stays; "
     "none for 0",
     "", VBM_PARAM_FLOAT, 0, nullptr, nullptr, nullptr, 5, 0, kNoLimit},
    {sizeof(vbm_param), "prune", "iterations", "Iterations",
     "How often parts are found anew and removed", "", VBM_PARAM_INT, 0, nullptr, nullptr, nullptr,
     1, 1, 1000},
    {sizeof(vbm_param), "axis_surface", "drop_outer", "Drop Outer Balls",
     "Leave out outer balls at removed parts as well, for sharper corners", "", VBM_PARAM_BOOL, 0,
     nullptr, nullptr, nullptr, 0, 0, 1},
    {sizeof(vbm_param), "simplify_axis", "count", "Balls", "How many balls the axis is to have", "",
     VBM_PARAM_INT, 0, nullptr, nullptr, nullptr, 1000, 1, kMaxCount},
    {sizeof(vbm_param), "simplify_axis", "iterations", "Fitting Steps",
     "How often the balls are fitted to the samples they stand for", "", VBM_PARAM_INT, 0, nullptr,
     nullptr, nullptr, 8, 0, 100},
    {sizeof(vbm_param), "curve_skeleton", "spur", "Shortest Branch",
     "A branch stays if it is longer than the shape is wide at it by this share of the bounding "
     "box's diagonal",
     "ratio", VBM_PARAM_FLOAT, 0, nullptr, nullptr, nullptr, 0.03, 0, 1},
    {sizeof(vbm_param), "curve_skeleton", "ratio", "Branch Ratio",
     "And if it is longer than that by this many times that width", "ratio", VBM_PARAM_FLOAT, 0,
     nullptr, nullptr, nullptr, 0.5, 0, kNoLimit},
    {sizeof(vbm_param), "curve_skeleton", "spacing", "Ball Spacing",
     "Neighbouring balls are about this many times half the shape's width apart", "ratio",
     VBM_PARAM_FLOAT, 0, nullptr, nullptr, nullptr, 0.5, 0.05, 100},
    {sizeof(vbm_param), "surface_from_balls", "style", "Style", "What kind of surface is made", "",
     VBM_PARAM_ENUM, 3, kBallStyleNames, kBallStyleLabels, kBallStyleHelps,
     VBM_BALL_STYLE_SINGULAR_POINTS, VBM_BALL_STYLE_SINGULAR_POINTS, VBM_BALL_STYLE_POWER_CRUST},
    {sizeof(vbm_param), "surface_from_balls", "bulge", "Bulge",
     "Add vertices on a ball where its polygon would lie farther from the sphere than this share "
     "of the radius; finer where most balls are much in sight, as in a molecule",
     "ratio", VBM_PARAM_FLOAT, 0, nullptr, nullptr, nullptr, 0.15, 0.001, 1},
    {sizeof(vbm_param), "surface_from_balls", "bridge", "Bridge Gaps",
     "Join balls that would meet if their radii were larger by this share; not for the skin",
     "ratio", VBM_PARAM_FLOAT, 0, nullptr, nullptr, nullptr, 0, 0, 1},
    {sizeof(vbm_param), "surface_from_balls", "shrink", "Shrink Factor",
     "Skin: near 1 the balls themselves, with narrow creases; smaller ones round creases more and "
     "bridge wider gaps",
     "ratio", VBM_PARAM_FLOAT, 0, nullptr, nullptr, nullptr, 0.9, 0.05, 0.99},
    {sizeof(vbm_param), "surface_from_balls", "narrow", "Close Narrow",
     "Close what is narrower than this share of the distance between faces, as far as Bulge allows",
     "ratio", VBM_PARAM_FLOAT, 0, nullptr, nullptr, nullptr, 0.37, 0, 1},
    {sizeof(vbm_param), "surface_from_balls", "errors", "Measure Errors",
     "Say how far the surface and the boundary of the balls' union are apart, both ways", "",
     VBM_PARAM_BOOL, 0, nullptr, nullptr, nullptr, 0, 0, 1},
    {sizeof(vbm_param), "cluster", "sphericity", "Sphericity",
     "How much of a ball that replaces others one of them fills, by radius, at least", "ratio",
     VBM_PARAM_FLOAT, 0, nullptr, nullptr, nullptr, 0.95, 0.01, 1},
    {sizeof(vbm_param), "cluster", "count", "Number of Balls",
     "The best so many balls, whatever their sphericity; 0 leaves the number to the sphericity", "",
     VBM_PARAM_INT, 0, nullptr, nullptr, nullptr, 0, 0, kMaxCount},
    {sizeof(vbm_param), "cluster", "measure", "Measure",
     "What tells how well one ball stands for others", "", VBM_PARAM_ENUM, 2, kClusterMeasureNames,
     kClusterMeasureLabels, kClusterMeasureHelps, VBM_CLUSTER_ENCLOSING, VBM_CLUSTER_ENCLOSING,
     VBM_CLUSTER_UNION},
};

} // namespace

size_t vbm_param_count(void) { return sizeof kParams / sizeof kParams[0]; }

vbm_status vbm_param_describe(size_t index, vbm_param *param) {
  if (!param || param->struct_size < sizeof(size_t) || index >= vbm_param_count())
    return VBM_ERROR_ARGUMENT;
  // A caller with an older header gets the fields it knows, one with a newer header zeros for those
  // this library does not know.
  const size_t size = param->struct_size;
  const size_t known = std::min(size, sizeof(vbm_param));
  std::memcpy(param, &kParams[index], known);
  if (size > known) std::memset(reinterpret_cast<char *>(param) + known, 0, size - known);
  param->struct_size = size;
  return VBM_OK;
}
