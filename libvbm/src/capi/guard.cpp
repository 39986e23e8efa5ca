// SPDX-License-Identifier: GPL-3.0-or-later
#include "capi/guard.h"

#include <new>
#include <stdexcept>
#include <string>

namespace vbm::impl {

void clear_error(vbm_context &context) noexcept {
  context.message.clear();
  context.text = "";
  context.kind = "";
  context.elements.clear();
  context.total = 0;
}

namespace {

vbm_status fail(vbm_context &context, vbm_status status, const char *message) noexcept {
  try {
    context.message = message;
    context.text = context.message.c_str();
  } catch (...) {
    context.text = vbm_status_name(status);
  }
  return status;
}

} // namespace

vbm_status handle_exception(vbm_context &context) noexcept {
  try {
    throw;
  } catch (Error &error) {
    context.kind = error.kind;
    context.elements.swap(error.elements);
    context.total = error.total;
    return fail(context, error.status, error.what());
  } catch (const std::bad_alloc &) {
    context.text = "out of memory";
    return VBM_ERROR_MEMORY;
  } catch (const std::length_error &) {
    context.text = "out of memory: an array would be larger than any address";
    return VBM_ERROR_MEMORY;
  } catch (const std::exception &error) {
    try {
      const std::string message = std::string("internal error: ") + error.what();
      return fail(context, VBM_ERROR_INTERNAL, message.c_str());
    } catch (...) {
      context.text = "internal error";
      return VBM_ERROR_INTERNAL;
    }
  } catch (...) {
    context.text = "internal error of an unknown kind";
    return VBM_ERROR_INTERNAL;
  }
}

} // namespace vbm::impl
