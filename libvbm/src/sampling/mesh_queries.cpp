// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/mesh_queries.h"

#include <algorithm>

namespace vbm::impl {
namespace {

class WindingTest final : public InsideTest {
public:
  WindingTest(std::shared_ptr<const TriangleTree> tree, bool every_ball)
      : tree_(std::move(tree)), every_ball_(every_ball) {}
  Answer test(const Vec3 &center, double) const override {
    int winding;
    if (!tree_->winding_number(center, winding)) return Answer::unknown;
    return winding > 0 ? Answer::inside : Answer::outside;
  }
  bool decides_every_ball() const override { return every_ball_; }

private:
  std::shared_ptr<const TriangleTree> tree_;
  bool every_ball_;
};

class MeshRefiner final : public Refiner {
public:
  MeshRefiner(std::shared_ptr<const TriangleTree> tree, std::shared_ptr<const BuriedTest> buried)
      : tree_(std::move(tree)), buried_(std::move(buried)) {}
  bool nearest(const Vec3 &center, double radius, Vec3 &point, Vec3 &normal) const override {
    TriangleTree::Nearest found{radius, {}, -1};
    if (!tree_->nearest(center, found)) return false;
    point = found.point;
    normal = tree_->normal_at(found.point);
    return !buried_ || !buried_->buried(point, normal);
  }

private:
  std::shared_ptr<const TriangleTree> tree_;
  std::shared_ptr<const BuriedTest> buried_; // may be null
};

/// What every triangle and, after them, every cap counts for; empty if all count for both.
std::vector<uint8_t> uses(const Parts &parts) {
  const auto closed = [](const Part &p) { return p.solid; };
  if (parts.caps.empty() && std::all_of(parts.part.begin(), parts.part.end(), closed)) return {};
  std::vector<uint8_t> use;
  use.reserve(parts.part_of.size() + parts.caps.size());
  const auto of_part = [&](int32_t p) { return parts.part[p].solid ? TriangleTree::winding : 0; };
  for (int32_t p : parts.part_of)
    use.push_back(static_cast<uint8_t>(TriangleTree::surface | of_part(p)));
  for (int32_t p : parts.cap_part) use.push_back(static_cast<uint8_t>(of_part(p)));
  return use;
}

} // namespace

std::shared_ptr<const TriangleTree> mesh_tree(std::vector<Triangle> triangles,
                                              std::vector<Vec3> position, const Parts &parts,
                                              Progress &progress) {
  triangles.insert(triangles.end(), parts.caps.begin(), parts.caps.end());
  return std::make_shared<const TriangleTree>(std::move(position), triangles, uses(parts),
                                              progress);
}

void set_mesh_queries(std::shared_ptr<const TriangleTree> tree, const Parts &parts,
                      std::shared_ptr<const BuriedTest> buried, Samples &samples) {
  samples.refiner = std::make_unique<MeshRefiner>(tree, std::move(buried));
  if (parts.usable) samples.inside = std::make_unique<WindingTest>(std::move(tree), parts.overlap);
}

} // namespace vbm::impl
