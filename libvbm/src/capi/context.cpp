// SPDX-License-Identifier: GPL-3.0-or-later
// Version, status names and the context.
#include "capi/handles.h"

#include <new>

extern "C" {

int32_t vbm_abi_version(void) { return VBM_ABI_VERSION; }

const char *vbm_version(void) { return VBM_VERSION; }

const char *vbm_status_name(vbm_status status) {
  switch (int(status)) {
  case VBM_OK:
    return "ok";
  case VBM_ERROR_ARGUMENT:
    return "invalid argument";
  case VBM_ERROR_INPUT:
    return "unusable input";
  case VBM_ERROR_DEGENERATE:
    return "degenerate input";
  case VBM_ERROR_NO_INTERIOR:
    return "no interior";
  case VBM_ERROR_LIMIT:
    return "resource limit";
  case VBM_ERROR_MEMORY:
    return "out of memory";
  case VBM_ERROR_CANCELLED:
    return "cancelled";
  case VBM_ERROR_INTERNAL:
    return "internal error";
  default:
    return "unknown status";
  }
}

vbm_status vbm_context_create(vbm_context **out) {
  if (!out) return VBM_ERROR_ARGUMENT;
  *out = new (std::nothrow) vbm_context;
  return *out ? VBM_OK : VBM_ERROR_MEMORY;
}

void vbm_context_free(vbm_context *context) { delete context; }

const char *vbm_context_message(const vbm_context *context) { return context ? context->text : ""; }

const int64_t *vbm_context_bad_elements(const vbm_context *context, const char **kind,
                                        size_t *count, size_t *total) {
  if (kind) *kind = context ? context->kind : "";
  if (count) *count = context ? context->elements.size() : 0;
  if (total) *total = context ? context->total : 0;
  return context ? context->elements.data() : nullptr;
}

void vbm_context_set_progress(vbm_context *context, vbm_progress_fn progress, void *user) {
  if (!context) return;
  context->progress = progress;
  context->user = user;
}

void vbm_context_set_threads(vbm_context *context, int32_t most) {
  if (context) context->threads = most > 0 ? most : 0;
}

} // extern "C"
