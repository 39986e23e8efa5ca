// SPDX-License-Identifier: GPL-3.0-or-later
// Refusing input before anything is computed from it.
#pragma once

#include <vbm/vbm.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace vbm::impl {

class Progress;

/// "3 vertices", "1 vertex".
std::string counted(std::size_t n, const char *one, const char *many);

/// A number for a sentence, in six digits and in every locale with a point.
std::string short_number(double value);

/// Elements found wrong: the first few by index, and how many in all.
struct Offenders {
  std::vector<int64_t> listed;
  std::size_t total = 0;
  void add(std::size_t element);
};

/// Throw Error(VBM_ERROR_INPUT): "vertex 1023 is not finite (3 such vertices in all)".
[[noreturn]] void throw_offenders(const Offenders &offenders, const char *kind, const char *kinds,
                                  const std::string &what);

/// Throw VBM_ERROR_LIMIT if so many input points can never be handled, VBM_ERROR_ARGUMENT if the
/// array is missing.
void check_count(const double *points, std::size_t count, const vbm_build_options &options);

/// The most samples the options allow.
std::size_t sample_limit(const vbm_build_options &options);

/// Throw VBM_ERROR_LIMIT if `needed` samples are more than the options allow; `why` ends the
/// sentence "1234 samples are needed", with a space before it, or is empty.
void check_sample_limit(double needed, const vbm_build_options &options, const std::string &why);

/// Throw VBM_ERROR_INPUT if any of count x 3 numbers is not finite; `kind` is "vertex" or "normal".
/// With options.drop_invalid, mark these elements with 0 in `keep` instead (one byte each; left
/// empty if all are finite), and return how many.
std::size_t check_finite(const double *points, std::size_t count, const char *kind,
                         const char *kinds, bool drop, std::vector<uint8_t> &keep,
                         Progress &progress);

} // namespace vbm::impl
