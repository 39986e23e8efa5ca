// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where exceptions end and statuses begin.
#pragma once

#include "capi/handles.h"
#include "core/error.h"
#include "core/progress.h"

#include <cfenv>
#include <utility>

namespace vbm::impl {

/// Computes in the default floating-point environment (round to nearest, no traps, denormals kept),
/// whatever the host has set, and puts the host's back.
class FloatingPointGuard {
public:
  FloatingPointGuard() {
    std::fegetenv(&saved_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~FloatingPointGuard() { std::fesetenv(&saved_); }
  FloatingPointGuard(const FloatingPointGuard &) = delete;
  FloatingPointGuard &operator=(const FloatingPointGuard &) = delete;

private:
  std::fenv_t saved_;
};

void clear_error(vbm_context &context) noexcept;
/// Turn the exception in flight into a status and the context's message.
vbm_status handle_exception(vbm_context &context) noexcept;

/// Run `body(progress)`, a callable that returns nothing.
template <class Body> vbm_status guarded(vbm_context *context, Body &&body) noexcept {
  if (!context) return VBM_ERROR_ARGUMENT;
  clear_error(*context);
  try {
    const FloatingPointGuard floating_point;
    Progress progress(context->progress, context->user, context->threads);
    body(progress);
    return VBM_OK;
  } catch (...) {
    return handle_exception(*context);
  }
}

/// Run `body(progress)`, a callable that returns the new handle, and give its result to the caller.
template <class Handle, class Body>
vbm_status guarded(vbm_context *context, Handle **out, Body &&body) noexcept {
  if (out) *out = nullptr;
  if (!context) return VBM_ERROR_ARGUMENT;
  clear_error(*context);
  try {
    if (!out) throw Error(VBM_ERROR_ARGUMENT, "out is NULL");
    const FloatingPointGuard floating_point;
    Progress progress(context->progress, context->user, context->threads);
    Handle *handle = body(progress);
    try {
      progress.finish();
    } catch (...) {
      delete handle;
      throw;
    }
    *out = handle;
    return VBM_OK;
  } catch (...) {
    return handle_exception(*context);
  }
}

/// The caller's options over the defaults: missing fields of an older struct keep their defaults,
/// fields of a newer one that are not known here are ignored.
vbm_build_options read_options(const vbm_build_options *options);
vbm_axis_options read_options(const vbm_axis_options *options);
vbm_prune_options read_options(const vbm_prune_options *options);
vbm_axis_surface_options read_options(const vbm_axis_surface_options *options);
vbm_simplify_options read_options(const vbm_simplify_options *options);
vbm_curve_skeleton_options read_options(const vbm_curve_skeleton_options *options);
vbm_ball_surface_options read_options(const vbm_ball_surface_options *options);
vbm_cluster_options read_options(const vbm_cluster_options *options);

} // namespace vbm::impl
