// SPDX-License-Identifier: GPL-3.0-or-later
// Option structs: defaults, sizes, ranges.
#include "capi/guard.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

namespace vbm::impl {

namespace {

vbm_build_options build_defaults() {
  vbm_build_options o{};
  o.struct_size = sizeof o;
  o.balls = VBM_BALLS_POLAR;
  o.labels = VBM_LABELS_AUTO;
  o.spacing = 0;
  o.undersampling = 0.7;
  o.drop_invalid = 0;
  o.refine = 1;
  o.sample_limit = 0;
  o.cell_limit = 0;
  return o;
}

vbm_axis_options axis_defaults() {
  vbm_axis_options o{};
  o.struct_size = sizeof o;
  o.angle = 45;
  o.ratio = 8;
  o.method = VBM_AXIS_VORONOI;
  return o;
}

vbm_prune_options prune_defaults() {
  vbm_prune_options o{};
  o.struct_size = sizeof o;
  o.measure = VBM_MEASURE_TRIANGLES;
  o.iterations = 1;
  o.threshold = 5;
  return o;
}

vbm_axis_surface_options axis_surface_defaults() {
  vbm_axis_surface_options o{};
  o.struct_size = sizeof o;
  return o;
}

vbm_simplify_options simplify_defaults() {
  vbm_simplify_options o{};
  o.struct_size = sizeof o;
  o.count = 1000;
  o.iterations = 8;
  return o;
}

vbm_curve_skeleton_options curve_skeleton_defaults() {
  vbm_curve_skeleton_options o{};
  o.struct_size = sizeof o;
  o.spur = 0.03;
  o.ratio = 0.5;
  o.spacing = 0.5;
  return o;
}

vbm_ball_surface_options ball_surface_defaults() {
  vbm_ball_surface_options o{};
  o.struct_size = sizeof o;
  o.style = VBM_BALL_STYLE_SINGULAR_POINTS;
  o.bulge = 0.15;
  o.bridge = 0;
  o.shrink = 0.9;
  o.narrow = 0.37;
  return o;
}

vbm_cluster_options cluster_defaults() {
  vbm_cluster_options o{};
  o.struct_size = sizeof o;
  o.sphericity = 0.95;
  o.count = 0;
  o.measure = VBM_CLUSTER_ENCLOSING;
  return o;
}

[[noreturn]] void bad_option(const char *name, const std::string &why) {
  throw Error(VBM_ERROR_ARGUMENT, std::string("option ") + name + " " + why, "option", {}, 0);
}

/// The caller's over the defaults, as far as both are known.
template <class Options> Options read(const Options *options, Options o, const char *init) {
  if (!options) return o;
  if (options->struct_size < sizeof(size_t))
    bad_option("struct_size",
               "is " + std::to_string(options->struct_size) + ": fill options with " + init + "()");
  std::memcpy(&o, options, std::min(options->struct_size, sizeof o));
  o.struct_size = sizeof o;
  return o;
}

template <class Options> void init(Options *options, size_t struct_size, const Options &defaults) {
  if (!options || struct_size < sizeof(size_t)) return;
  std::memset(static_cast<void *>(options), 0, struct_size);
  std::memcpy(options, &defaults, std::min(struct_size, sizeof defaults));
  options->struct_size = struct_size;
}

} // namespace

vbm_build_options read_options(const vbm_build_options *options) {
  const vbm_build_options o = read(options, build_defaults(), "vbm_build_options_init");
  if (o.balls < VBM_BALLS_POLAR || o.balls > VBM_BALLS_VORONOI)
    bad_option("balls", "is " + std::to_string(o.balls) + ": use 0 (polar) or 1 (voronoi)");
  if (o.labels < VBM_LABELS_AUTO || o.labels > VBM_LABELS_SCAN)
    bad_option("labels", "is " + std::to_string(o.labels) + ": use 0 to 4 (vbm_labels)");
  if (!std::isfinite(o.spacing)) bad_option("spacing", "is not a finite length");
  if (!(o.undersampling >= 0.05 && o.undersampling <= 1))
    bad_option("undersampling", "is outside its range 0.05 to 1");
  return o;
}

vbm_axis_options read_options(const vbm_axis_options *options) {
  const vbm_axis_options o = read(options, axis_defaults(), "vbm_axis_options_init");
  if (!(o.angle >= 0 && o.angle <= 180)) bad_option("angle", "is outside its range 0 to 180");
  if (!(o.ratio >= 1)) bad_option("ratio", "is less than 1");
  if (o.method < VBM_AXIS_VORONOI || o.method > VBM_AXIS_POWER_SHAPE)
    bad_option("method", "is " + std::to_string(o.method) + ": use 0 (voronoi) or 1 (power_shape)");
  return o;
}

vbm_prune_options read_options(const vbm_prune_options *options) {
  const vbm_prune_options o = read(options, prune_defaults(), "vbm_prune_options_init");
  if (o.measure < VBM_MEASURE_TRIANGLES || o.measure > VBM_MEASURE_BALLS)
    bad_option("measure", "is " + std::to_string(o.measure) + ": use 0 to 4 (vbm_measure)");
  if (o.iterations < 1 || o.iterations > 1000)
    bad_option("iterations",
               "is " + std::to_string(o.iterations) + ", outside its range 1 to 1000");
  if (!(o.threshold >= 0)) bad_option("threshold", "is negative or not a number");
  return o;
}

vbm_axis_surface_options read_options(const vbm_axis_surface_options *options) {
  return read(options, axis_surface_defaults(), "vbm_axis_surface_options_init");
}

vbm_simplify_options read_options(const vbm_simplify_options *options) {
  const vbm_simplify_options o = read(options, simplify_defaults(), "vbm_simplify_options_init");
  if (o.count < 1) bad_option("count", "is 0: use at least 1");
  if (o.iterations < 0 || o.iterations > 100)
    bad_option("iterations", "is " + std::to_string(o.iterations) + ", outside its range 0 to 100");
  return o;
}

vbm_curve_skeleton_options read_options(const vbm_curve_skeleton_options *options) {
  const vbm_curve_skeleton_options o =
      read(options, curve_skeleton_defaults(), "vbm_curve_skeleton_options_init");
  if (!(o.spur >= 0 && o.spur <= 1)) bad_option("spur", "is outside its range 0 to 1");
  if (!(o.ratio >= 0)) bad_option("ratio", "is negative or not a number");
  if (!(o.spacing >= 0.05 && o.spacing <= 100))
    bad_option("spacing", "is outside its range 0.05 to 100");
  return o;
}

vbm_ball_surface_options read_options(const vbm_ball_surface_options *options) {
  const vbm_ball_surface_options o =
      read(options, ball_surface_defaults(), "vbm_ball_surface_options_init");
  if (o.style < VBM_BALL_STYLE_SINGULAR_POINTS || o.style > VBM_BALL_STYLE_POWER_CRUST)
    bad_option("style", "is " + std::to_string(o.style) + ": use 0 to 2 (vbm_ball_style)");
  if (!(o.bulge >= 0.001 && o.bulge <= 1)) bad_option("bulge", "is outside its range 0.001 to 1");
  if (!(o.bridge >= 0 && o.bridge <= 1)) bad_option("bridge", "is outside its range 0 to 1");
  if (!(o.shrink >= 0.05 && o.shrink <= 0.99))
    bad_option("shrink", "is outside its range 0.05 to 0.99");
  if (!(o.narrow >= 0 && o.narrow <= 1)) bad_option("narrow", "is outside its range 0 to 1");
  if (o.errors != 0 && o.errors != 1) bad_option("errors", "must be 0 or 1");
  return o;
}

vbm_cluster_options read_options(const vbm_cluster_options *options) {
  const vbm_cluster_options o = read(options, cluster_defaults(), "vbm_cluster_options_init");
  if (!(o.sphericity >= 0.01 && o.sphericity <= 1))
    bad_option("sphericity", "is outside its range 0.01 to 1");
  if (o.measure < VBM_CLUSTER_ENCLOSING || o.measure > VBM_CLUSTER_UNION)
    bad_option("measure", "is " + std::to_string(o.measure) + ": use 0 (enclosing) or 1 (union)");
  return o;
}

} // namespace vbm::impl

extern "C" {

void vbm_build_options_init(vbm_build_options *options, size_t struct_size) {
  vbm::impl::init(options, struct_size, vbm::impl::build_defaults());
}
void vbm_axis_options_init(vbm_axis_options *options, size_t struct_size) {
  vbm::impl::init(options, struct_size, vbm::impl::axis_defaults());
}
void vbm_prune_options_init(vbm_prune_options *options, size_t struct_size) {
  vbm::impl::init(options, struct_size, vbm::impl::prune_defaults());
}
void vbm_axis_surface_options_init(vbm_axis_surface_options *options, size_t struct_size) {
  vbm::impl::init(options, struct_size, vbm::impl::axis_surface_defaults());
}
void vbm_simplify_options_init(vbm_simplify_options *options, size_t struct_size) {
  vbm::impl::init(options, struct_size, vbm::impl::simplify_defaults());
}
void vbm_curve_skeleton_options_init(vbm_curve_skeleton_options *options, size_t struct_size) {
  vbm::impl::init(options, struct_size, vbm::impl::curve_skeleton_defaults());
}
void vbm_ball_surface_options_init(vbm_ball_surface_options *options, size_t struct_size) {
  vbm::impl::init(options, struct_size, vbm::impl::ball_surface_defaults());
}
void vbm_cluster_options_init(vbm_cluster_options *options, size_t struct_size) {
  vbm::impl::init(options, struct_size, vbm::impl::cluster_defaults());
}

} // extern "C"
