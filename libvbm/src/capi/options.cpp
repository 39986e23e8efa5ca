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

[[noreturn]] void bad_option(const char *name, const std::string &why) {
  throw Error(VBM_ERROR_ARGUMENT, std::string("option ") + name + " " + why, "option", {}, 0);
}

} // namespace

vbm_build_options read_options(const vbm_build_options *options) {
  vbm_build_options o = build_defaults();
  if (!options) return o;
  if (options->struct_size < sizeof(size_t))
    bad_option("struct_size", "is " + std::to_string(options->struct_size) +
                                  ": fill options with vbm_build_options_init()");
  std::memcpy(&o, options, std::min(options->struct_size, sizeof o));
  o.struct_size = sizeof o;
  if (o.balls < VBM_BALLS_POLAR || o.balls > VBM_BALLS_VORONOI)
    bad_option("balls", "is " + std::to_string(o.balls) + ": use 0 (polar) or 1 (voronoi)");
  if (o.labels < VBM_LABELS_AUTO || o.labels > VBM_LABELS_SCAN)
    bad_option("labels", "is " + std::to_string(o.labels) + ": use 0 to 4 (vbm_labels)");
  if (!std::isfinite(o.spacing)) bad_option("spacing", "is not a finite length");
  if (!(o.undersampling >= 0.05 && o.undersampling <= 1))
    bad_option("undersampling", "is outside its range 0.05 to 1");
  return o;
}

} // namespace vbm::impl

extern "C" void vbm_build_options_init(vbm_build_options *options, size_t struct_size) {
  if (!options || struct_size < sizeof(size_t)) return;
  const vbm_build_options defaults = vbm::impl::build_defaults();
  std::memset(static_cast<void *>(options), 0, struct_size);
  std::memcpy(options, &defaults, std::min(struct_size, sizeof defaults));
  options->struct_size = struct_size;
}
