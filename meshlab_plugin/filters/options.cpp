// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.h"

namespace vbm_filters {
namespace {

std::int32_t whole(double value) { return static_cast<std::int32_t>(value); }

} // namespace

bool set_option(vbm_build_options &options, const std::string &name, double value) {
  if (name == "balls")
    options.balls = whole(value);
  else if (name == "labels")
    options.labels = whole(value);
  else if (name == "spacing")
    options.spacing = value;
  else if (name == "undersampling")
    options.undersampling = value;
  else if (name == "drop_invalid")
    options.drop_invalid = whole(value);
  else if (name == "refine")
    options.refine = whole(value);
  else if (name == "sample_limit")
    options.sample_limit = static_cast<std::uint64_t>(value);
  else if (name == "cell_limit")
    options.cell_limit = static_cast<std::uint64_t>(value);
  else
    return false;
  return true;
}

bool set_option(vbm_axis_options &options, const std::string &name, double value) {
  if (name == "method")
    options.method = whole(value);
  else if (name == "angle")
    options.angle = value;
  else if (name == "ratio")
    options.ratio = value;
  else
    return false;
  return true;
}

bool set_option(vbm_prune_options &options, const std::string &name, double value) {
  if (name == "measure")
    options.measure = whole(value);
  else if (name == "threshold")
    options.threshold = value;
  else if (name == "iterations")
    options.iterations = whole(value);
  else
    return false;
  return true;
}

bool set_option(vbm_axis_surface_options &options, const std::string &name, double value) {
  if (name != "drop_outer") return false;
  options.drop_outer = whole(value);
  return true;
}

bool set_option(vbm_ball_surface_options &options, const std::string &name, double value) {
  if (name == "style")
    options.style = whole(value);
  else if (name == "bulge")
    options.bulge = value;
  else if (name == "bridge")
    options.bridge = value;
  else if (name == "shrink")
    options.shrink = value;
  else if (name == "narrow")
    options.narrow = value;
  else if (name == "errors")
    options.errors = whole(value);
  else
    return false;
  return true;
}

bool set_option(vbm_cluster_options &options, const std::string &name, double value) {
  if (name == "sphericity")
    options.sphericity = value;
  else if (name == "count")
    options.count = static_cast<std::uint64_t>(value);
  else if (name == "measure")
    options.measure = whole(value);
  else
    return false;
  return true;
}

bool set_option(vbm_simplify_options &options, const std::string &name, double value) {
  if (name == "count")
    options.count = static_cast<std::uint64_t>(value);
  else if (name == "iterations")
    options.iterations = whole(value);
  else
    return false;
  return true;
}

} // namespace vbm_filters
