// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter.h"

#include <new>

namespace vbm_filters {

const std::vector<const Filter *> &filters() {
  static const std::vector<const Filter *> all = {
      &ball_model_filter, &closed_surface_filter, &thickness_filter,     &medial_axis_filter,
      &simplify_filter,   &remove_parts_filter,   &part_color_filter,    &ball_surface_filter,
      &cluster_filter,    &ball_measures_filter,  &axis_of_balls_filter,
  };
  return all;
}

Outcome run(const Filter &filter, const Layer &layer, const Values &values, AxisStore &axes,
            Callback callback) {
  try {
    check(filter.params(), values);
    Progress progress(std::move(callback));
    return filter.run({layer, values, progress, axes});
  } catch (const Failure &) {
    throw;
  } catch (const vbm::Error &error) {
    if (error.status == VBM_ERROR_CANCELLED) throw Failure("Cancelled: nothing was changed.");
    std::string message = error.what();
    if (message.empty()) message = vbm_status_name(error.status);
    if (layer.renumbered && error.kind == "vertex")
      message += " (counting only vertices that are not deleted)";
    throw Failure(message);
  } catch (const std::bad_alloc &) {
    throw Failure("There is not enough memory for this.");
  }
}

} // namespace vbm_filters
