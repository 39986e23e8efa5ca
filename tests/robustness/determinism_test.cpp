// SPDX-License-Identifier: GPL-3.0-or-later
// Same input, same options: the same bytes, whatever happened before and wherever it happens.
#include "host.h"
#include "outcome.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace {

struct Named {
  std::string name;
  Build build;
};

class Determinism : public testing::Test {
protected:
  const shapes::Shape torus = shapes::torus(40, 20, 2, .6, .3);
  const shapes::Shape sphere = shapes::sphere_mesh(14, 28); // cospherical throughout
  const shapes::Shape box = shapes::box({1, 2, .2});
  const std::vector<Named> builds = {{"points", points_of(torus)},
                                     {"points with normals", points_of(torus, true)},
                                     {"cospherical points", points_of(sphere)},
                                     {"mesh", mesh_of(box)}};
};

TEST_F(Determinism, TwiceAndAfterOthers) {
  std::vector<std::string> first;
  for (const Named &b : builds) first.push_back(run(b.build).bytes);
  for (std::size_t round = 0; round < 2; ++round)
    for (std::size_t i = builds.size(); i-- > 0;) {
      const Outcome again = run(builds[i].build);
      EXPECT_EQ(again.problems, "");
      EXPECT_TRUE(again.bytes == first[i]) << builds[i].name;
    }
}

TEST_F(Determinism, InOtherThreads) {
  for (const Named &b : builds) {
    const std::string here = run(b.build).bytes;
    std::string there;
    std::thread([&] { there = run(b.build).bytes; }).join();
    EXPECT_TRUE(there == here) << b.name;
  }
}

TEST_F(Determinism, InAnOddHost) {
  if (!have_comma_locale()) GTEST_SKIP() << "no locale de_DE.UTF-8";
  for (const Named &b : builds) {
    std::string changed;
    const Outcome odd = run(b.build, make_options(), [&](const std::function<void()> &call) {
      changed += in_odd_host(call);
    });
    EXPECT_EQ(changed, "") << b.name;
    EXPECT_EQ(odd.problems, "");
    EXPECT_TRUE(odd.bytes == run(b.build).bytes) << b.name;
  }
}

TEST_F(Determinism, WithOtherThingsInMemory) {
  // Order by address would show: other blocks of memory are in the way the second time.
  for (const Named &b : builds) {
    const std::string first = run(b.build).bytes;
    std::vector<std::vector<char>> blocks;
    for (std::size_t i = 1; i < 4000; ++i) blocks.emplace_back(16 + i * 7919 % 5000);
    for (std::size_t i = 0; i < blocks.size(); i += 2) std::vector<char>().swap(blocks[i]);
    EXPECT_TRUE(run(b.build).bytes == first) << b.name;
  }
}

TEST_F(Determinism, OrderOfPointsDoesNotMatterToTheShape) {
  const Outcome straight = run(points_of(torus));
  ASSERT_EQ(straight.status, VBM_OK);
  EXPECT_EQ(straight.surface.genus, 1);
  for (uint64_t seed : {1, 2, 3}) {
    const shapes::Shape mixed = shapes::permuted(torus, shapes::shuffled(torus.size(), seed));
    const Outcome o = run(points_of(mixed));
    EXPECT_EQ(o.problems, "");
    EXPECT_EQ(o.surface.triangles, straight.surface.triangles);
    EXPECT_EQ(o.surface.genus, straight.surface.genus);
    EXPECT_EQ(o.surface.components, straight.surface.components);
    EXPECT_EQ(o.crust.genus, straight.crust.genus);
    EXPECT_EQ(o.report.inner_balls, straight.report.inner_balls);
    EXPECT_NEAR(o.surface.volume / straight.surface.volume, 1, 1e-12);
    const Outcome mesh = run(mesh_of(mixed));
    EXPECT_EQ(mesh.problems, "");
    EXPECT_EQ(mesh.surface.genus, 1);
  }
}

TEST_F(Determinism, MovesScalesAndMirrorsDoNotMatterToTheShape) {
  const Outcome straight = run(points_of(torus));
  const auto same_as_before = [&](const char *what,
                                  const std::function<shapes::Vec(const shapes::Vec &)> &map) {
    const shapes::Shape other = shapes::moved(torus, map);
    const Outcome o = run(points_of(other));
    EXPECT_EQ(o.problems, "") << what;
    EXPECT_EQ(o.surface.genus, 1) << what;
    EXPECT_EQ(o.surface.components, 1u) << what;
    EXPECT_EQ(o.surface.triangles, straight.surface.triangles) << what;
    EXPECT_NEAR(o.surface.volume * std::pow(o.surface.diagonal / straight.surface.diagonal, 3) /
                    straight.surface.volume,
                1, 1e-3)
        << what;
  };
  same_as_before("moved", [](const shapes::Vec &p) {
    return shapes::Vec{p[0] + 1000, p[1], p[2] - 77};
  });
  same_as_before("mirrored", [](const shapes::Vec &p) { return shapes::Vec{-p[0], p[1], p[2]}; });
  same_as_before("turned", [](const shapes::Vec &p) {
    return shapes::Vec{.6 * p[0] - .8 * p[2], p[1], .8 * p[0] + .6 * p[2]};
  });
  same_as_before("axes exchanged", [](const shapes::Vec &p) {
    return shapes::Vec{p[2], p[0], p[1]};
  });
}

} // namespace
