// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/checks.h"

#include "core/error.h"
#include "core/progress.h"
#include "sampling/tolerances.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace vbm::impl {

std::string counted(std::size_t n, const char *one, const char *many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::string short_number(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6);
  return std::string(text, end.ptr);
}

void Offenders::add(std::size_t element) {
  if (listed.size() < Error::kMaxListed) listed.push_back(static_cast<int64_t>(element));
  ++total;
}

void throw_offenders(const Offenders &offenders, const char *kind, const char *kinds,
                     const std::string &what) {
  std::string message =
      std::string(kind) + " " + std::to_string(offenders.listed.front()) + " " + what;
  if (offenders.total > 1)
    message += " (" + std::to_string(offenders.total) + " such " + kinds + " in all)";
  throw Error(VBM_ERROR_INPUT, std::move(message), kind, offenders.listed, offenders.total);
}

void check_count(const double *points, std::size_t count, const vbm_build_options &options) {
  if (count > 0 && points == nullptr)
    throw Error(VBM_ERROR_ARGUMENT,
                "the array of " + counted(count, "point", "points") + " is NULL");
  if (count > kMostIndices)
    throw Error(VBM_ERROR_LIMIT, std::to_string(count) + " points are more than the " +
                                     std::to_string(kMostIndices) + " that can be numbered");
  check_sample_limit(static_cast<double>(count), options, "");
}

std::size_t sample_limit(const vbm_build_options &options) {
  const uint64_t limit = options.sample_limit ? options.sample_limit : kDefaultSampleLimit;
  return limit < kMostIndices ? static_cast<std::size_t>(limit) : kMostIndices;
}

void check_sample_limit(double needed, const vbm_build_options &options, const std::string &why) {
  const std::size_t limit = sample_limit(options);
  if (needed <= static_cast<double>(limit)) return;
  const std::string number = needed < 1e18
                                 ? std::to_string(static_cast<uint64_t>(std::ceil(needed)))
                                 : std::string("more than 10^18");
  throw Error(VBM_ERROR_LIMIT, number + " samples are needed" + why + ", but the limit is " +
                                   std::to_string(limit) + " (sample_limit)");
}

std::size_t check_finite(const double *points, std::size_t count, const char *kind,
                         const char *kinds, bool drop, std::vector<uint8_t> &keep,
                         Progress &progress) {
  Offenders bad;
  for (std::size_t i = 0; i < count; ++i) {
    if ((i & 1023) == 0) progress.tick(0, 1);
    const double *p = points + 3 * i;
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) continue;
    bad.add(i);
    if (!drop) continue;
    if (keep.empty()) keep.assign(count, 1);
    keep[i] = 0;
  }
  if (bad.total && !drop) throw_offenders(bad, kind, kinds, "is not finite");
  return bad.total;
}

} // namespace vbm::impl
