// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary samples: what every kind of input becomes before balls are built.
#pragma once

#include "core/frame.h"
#include "core/vec3.h"

#include <vbm/vbm.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace vbm::impl {

class Progress;

/// Tells inside from outside at points away from the surface, where the input knows better than its
/// samples: the voxels of a volume, the winding number of a closed mesh. Unit frame.
class InsideTest {
public:
  enum class Answer { outside, inside, unknown };
  virtual ~InsideTest() = default;
  /// About a ball that no sample is inside of; `unknown` where this test has nothing to say, for
  /// instance because the ball contains no voxel centre.
  virtual Answer test(const Vec3 &center, double radius) const = 0;
  /// Whether to ask for every ball (voxels), or only where the samples' normals disagree (winding).
  virtual bool decides_every_ball() const = 0;
};

/// Adds samples to a mesh where a ball still contains a piece of it. Unit frame.
class Refiner {
public:
  virtual ~Refiner() = default;
  /// The surface point nearest to `center`, and the normal there; false if the mesh is farther than
  /// `radius` from it.
  virtual bool nearest(const Vec3 &center, double radius, Vec3 &point, Vec3 &normal) const = 0;
};

struct Samples {
  Frame frame;
  std::vector<Vec3> position;        // unit frame; no two the same
  std::vector<Vec3> normal;          // empty, or outward unit normal per sample; zero: unknown
  std::vector<int32_t> input;        // input point of each sample, -1: added
  std::vector<Vec3> input_position;  // original coordinates of each sample (exact for input points)
  std::vector<int32_t> input_sample; // per input point its sample, -1: dropped
  bool input_is_samples = false;     // volumes: "per input point" arrays are per sample

  vbm_labels rule = VBM_LABELS_PROPAGATION; // how labels will be found
  std::unique_ptr<InsideTest> inside;       // may be null
  std::unique_ptr<Refiner> refiner;         // may be null

  // Of a closed mesh that bounds a solid: its topology, which its surface should have; else 0 components.
  uint64_t components = 0;
  int64_t euler = 0;

  // For the report, and sentences for vbm_model_notes() (each without its newline).
  std::size_t refined =
      0; // samples added after the first ones, where balls held pieces of the mesh
  uint64_t input_points = 0, dropped = 0, merged = 0, added = 0;
  uint64_t skipped_faces = 0, open_loops = 0, inconsistent_edges = 0;
  double spacing = 0; // input units; 0 where no samples were added
  double gap = 0;     // unit lengths: the spacing aimed at, whether or not samples were added
  bool flipped = false;
  bool normals_turned = false; // `normal` is the reverse of what the Refiner says
  std::vector<std::string> notes;
};

} // namespace vbm::impl
