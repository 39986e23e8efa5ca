// SPDX-License-Identifier: GPL-3.0-or-later
// What is expected of each bad input, and the running of it.
#pragma once

#include "outcome.h"
#include "read.h"

#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace nasty {

/// What one input may lead to: an assertion on its outcome.
using Expect = std::function<testing::AssertionResult(const Outcome &)>;

/// An error whose message holds all of `words`.
Expect fails(vbm_status status, std::vector<std::string> words = {});
/// Surfaces (the interpolating one) with so many components and handles.
Expect solid(std::size_t components, int64_t genus);
/// Success, whatever the surfaces are (they are checked to be closed in any case).
Expect works();
/// The interpolating surface's volume, as a share of the bounding box's diagonal cubed, within
/// `tolerance` of it; and the power crust's.
Expect volume(double value, double tolerance);
Expect crust_volume(double value, double tolerance);
/// A line of the notes holds all of these words.
Expect notes(std::vector<std::string> words);
/// A figure of the report.
template <class T> Expect report(T vbm_model_report::*figure, T value) {
  return [=](const Outcome &o) {
    if (o.report.*figure == value) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "the report says " << o.report.*figure << ", not " << value;
  };
}
/// The samples too thinly sampled are listed, at least one.
Expect undersampled();
/// Elements of this kind were named, these first and so many in all.
Expect names(std::string kind, std::vector<int64_t> elements, size_t total);
Expect all(std::vector<Expect> parts);
Expect either(std::vector<Expect> ways);

struct Case {
  std::string file;
  Expect points;    // of bare points, or a mesh's vertices; empty: only what holds for every input
  Expect mesh = {}; // empty if the file has no faces that could be read
  bool drop_invalid = false;
  bool heavy = false; // of millions of cells: whole in one way only, some of its points in every way

  friend void PrintTo(const Case &c, std::ostream *out) { *out << c.file; }
};

/// Run one file every way (polar and all Voronoi balls; labels as the mesh offers and by
/// propagation), each in a child process of limited time and memory. The first way is taken in the
/// C locale and once more in an odd host: same bytes. Under sanitizers only that one,
/// once, and meshes only as meshes.
void run_case(const Case &c);

} // namespace nasty
