// SPDX-License-Identifier: GPL-3.0-or-later
#include "nasty.h"

#include "check_medial_mesh.h"
#include "child.h"
#include "host.h"
#include "nasty_files.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <sstream>

namespace nasty {

using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

namespace {

bool has(const std::string &text, const std::vector<std::string> &words) {
  for (const std::string &word : words)
    if (text.find(word) == text.npos) return false;
  return true;
}

std::string list(const std::vector<std::string> &words) {
  std::string out;
  for (const std::string &word : words) out += (out.empty() ? "'" : ", '") + word + "'";
  return out;
}

} // namespace

Expect fails(vbm_status status, std::vector<std::string> words) {
  return [=](const Outcome &o) -> AssertionResult {
    if (o.status != status)
      return AssertionFailure() << "expected " << vbm_status_name(status) << ", got "
                                << vbm_status_name(o.status) << " " << o.message;
    if (!has(o.message, words))
      return AssertionFailure() << "expected " << list(words) << " in the message: " << o.message;
    return AssertionSuccess();
  };
}

Expect works() {
  return [](const Outcome &o) -> AssertionResult {
    if (o.status == VBM_OK) return AssertionSuccess();
    return AssertionFailure() << "failed: " << o.message;
  };
}

Expect solid(std::size_t components, int64_t genus) {
  return [=](const Outcome &o) -> AssertionResult {
    if (o.status != VBM_OK) return AssertionFailure() << "failed: " << o.message;
    if (o.surface.components != components || o.surface.genus != genus)
      return AssertionFailure() << "expected " << components << " components and genus " << genus
                                << ", got " << o.surface.components << " and " << o.surface.genus;
    if (o.crust.components != components || o.crust.genus != genus)
      return AssertionFailure() << "expected " << components << " components and genus " << genus
                                << " of the power crust, got " << o.crust.components << " and "
                                << o.crust.genus;
    return AssertionSuccess();
  };
}

static Expect volume_of(Topology Outcome::*surface, const char *name, double value,
                        double tolerance) {
  return [=](const Outcome &o) -> AssertionResult {
    const double found = (o.*surface).volume;
    if (std::fabs(found - value) <= tolerance) return AssertionSuccess();
    return AssertionFailure() << "expected a volume of " << value << " of the " << name << ", got "
                              << found;
  };
}

Expect volume(double value, double tolerance) {
  return volume_of(&Outcome::surface, "surface", value, tolerance);
}

Expect crust_volume(double value, double tolerance) {
  return volume_of(&Outcome::crust, "power crust", value, tolerance);
}

Expect notes(std::vector<std::string> words) {
  return [=](const Outcome &o) -> AssertionResult {
    std::istringstream lines(o.notes);
    for (std::string line; std::getline(lines, line);)
      if (has(line, words)) return AssertionSuccess();
    return AssertionFailure() << "expected a note with " << list(words) << "; notes are:\n"
                              << o.notes;
  };
}

Expect undersampled() {
  return [](const Outcome &o) -> AssertionResult {
    if (o.report.undersampled > 0) return AssertionSuccess();
    return AssertionFailure() << "no sample is reported as undersampled";
  };
}

Expect names(std::string kind, std::vector<int64_t> elements, size_t total) {
  return [=](const Outcome &o) -> AssertionResult {
    if (o.kind == kind && o.bad == elements && o.bad_total == total) return AssertionSuccess();
    return AssertionFailure() << "names " << o.bad.size() << " of " << o.bad_total << " of kind '"
                              << o.kind << "', the first " << (o.bad.empty() ? -1 : o.bad.front());
  };
}

Expect all(std::vector<Expect> parts) {
  return [=](const Outcome &o) -> AssertionResult {
    for (const Expect &part : parts)
      if (AssertionResult result = part(o); !result) return result;
    return AssertionSuccess();
  };
}

Expect either(std::vector<Expect> ways) {
  return [=](const Outcome &o) -> AssertionResult {
    AssertionResult failure = AssertionFailure();
    for (const Expect &way : ways) {
      AssertionResult result = way(o);
      if (result) return result;
      failure << "either " << result.message() << "\n";
    }
    return failure;
  };
}

namespace {

/// Each input goes through building, surfaces, axis, pruning and the surfaces of that: the largest
/// takes half a minute, ten times as long under sanitizers, and more beside other tests.
const unsigned kSeconds = sanitized() ? 900 : 120;
constexpr std::size_t kMegabytes = 4000;

/// More is made of the axis where that does not take long.
const size_t kFewBalls = sanitized() ? 200 : 2000;

std::string derive(const Build &build, const vbm_build_options &options) {
  std::string wrong;
  vbm_context *context = nullptr;
  vbm_model *model = nullptr;
  vbm_axis *axis = nullptr;
  if (vbm_context_create(&context) == VBM_OK && build(context, &options, &model) == VBM_OK &&
      vbm_model_inner_count(model) <= kFewBalls) {
    vbm_axis_report report;
    report.struct_size = sizeof report;
    if (vbm_model_medial_axis(context, model, nullptr, &axis) != VBM_OK ||
        vbm_axis_get_report(axis, &report) != VBM_OK)
      wrong = std::string("no axis: ") + vbm_context_message(context) + "\n";
    else
      wrong =
          exercise_derived(context, model, axis, report.euler, report.components, nullptr).text();
  }
  vbm_axis_free(axis);
  vbm_model_free(model);
  vbm_context_free(context);
  return wrong;
}

/// In a child process: no assertions of the test framework, which would be counted there only.
bool try_one(const Build &build, const vbm_build_options &options, const Expect &expect, bool oddly,
             const std::string &what) {
  std::string wrong;
  const Outcome usual = run(build, options);
  wrong += usual.problems;
  if (expect)
    if (const AssertionResult result = expect(usual); !result)
      wrong += std::string(result.message()) + "\n";
  if (oddly && wrong.empty()) wrong += derive(build, options);
  if (oddly && !sanitized() && have_comma_locale()) {
    std::string changed;
    const Outcome odd = run(
        build, options, [&](const std::function<void()> &call) { changed += in_odd_host(call); });
    if (!changed.empty()) wrong += "the library changed its host's " + changed + "\n";
    if (odd.message != usual.message) wrong += "in an odd host: " + odd.message + "\n";
    if (odd.notes != usual.notes) wrong += "in an odd host:\n" + odd.notes;
    if (odd.bytes != usual.bytes) wrong += "another result in another locale and rounding mode\n";
  }
  if (std::getenv("VBM_VERBOSE"))
    std::cout << what << ": " << vbm_status_name(usual.status) << " " << usual.message
              << usual.report.samples << " samples, " << usual.report.inner_balls
              << " balls, surface " << usual.surface.components << " components, genus "
              << usual.surface.genus << ", volume " << usual.surface.volume << "; crust "
              << usual.crust.components << ", " << usual.crust.genus << ", " << usual.crust.volume
              << "; merged " << usual.report.merged << "\n"
              << usual.notes;
  if (!wrong.empty()) std::cout << what << ":\n" << wrong << std::flush;
  return wrong.empty();
}

} // namespace

void run_case(const Case &c) {
  if (nasty_folder().empty())
    GTEST_SKIP() << "no nasty/make_nasty.py in the folder that VBM_SHARED names";
  Geometry g = read_geometry(nasty_folder() + "/" + c.file);
  const Build points = [&](vbm_context *context, const vbm_build_options *o, vbm_model **out) {
    return vbm_build_points(context, g.points.data(), g.size(), nullptr, o, out);
  };
  const Build mesh = [&](vbm_context *context, const vbm_build_options *o, vbm_model **out) {
    static const uint32_t none = 0;
    return vbm_build_mesh(context, g.points.data(), g.size(),
                          g.sizes.empty() ? &none : g.sizes.data(), g.corners.data(),
                          g.corners.size(), g.sizes.size(), o, out);
  };
  const bool faces = c.file.rfind("pts/", 0) != 0;
  const auto attempt = [&](const Build &build, vbm_balls balls, vbm_labels labels,
                           const Expect &expect, const std::string &what, bool twice = true) {
    vbm_build_options options = make_options(balls, labels);
    options.drop_invalid = c.drop_invalid;
    const bool oddly = twice && balls == VBM_BALLS_POLAR && labels == VBM_LABELS_AUTO;
    EXPECT_EQ(run_in_child(kSeconds, kMegabytes,
                           [&] { return try_one(build, options, expect, oddly, what); }),
              "")
        << what;
  };
  if (c.heavy) {
    if (!sanitized())
      attempt(points, VBM_BALLS_POLAR, VBM_LABELS_AUTO, c.points, "the whole", false);
    const std::size_t step = sanitized() ? 10 : 4, count = (g.size() + step - 1) / step;
    for (std::size_t i = 0; i < count; ++i)
      std::copy_n(&g.points[3 * step * i], 3, &g.points[3 * i]);
    g.points.resize(3 * count);
  }
  if (!faces || !sanitized())
    attempt(points, VBM_BALLS_POLAR, VBM_LABELS_AUTO, c.points, "bare points");
  if (faces) attempt(mesh, VBM_BALLS_POLAR, VBM_LABELS_AUTO, c.mesh, "mesh");
  if (sanitized()) return; // which takes ten times as long
  attempt(points, VBM_BALLS_VORONOI, VBM_LABELS_AUTO, c.points, "bare points, Voronoi balls");
  if (!faces) return;
  attempt(mesh, VBM_BALLS_VORONOI, VBM_LABELS_AUTO, c.mesh, "mesh, Voronoi balls");
  attempt(mesh, VBM_BALLS_POLAR, VBM_LABELS_PROPAGATION, {}, "mesh, labels by propagation");
}

} // namespace nasty
