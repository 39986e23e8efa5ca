// SPDX-License-Identifier: GPL-3.0-or-later
// Every tolerance and bound of the sampling stage, with its unit and its reason.
#pragma once

#include <cstddef>
#include <cstdint>

namespace vbm::impl {

/// Samples are numbered by int32_t; 64 numbers stay free for the closing box and for markers.
inline constexpr std::size_t kMostIndices = static_cast<std::size_t>(INT32_MAX) - 64;

/// Samples allowed where the options say 0.
inline constexpr uint64_t kDefaultSampleLimit = 20'000'000;

/// Different coordinates a double can take across the shape's longest side (no unit). With fewer,
/// the shape is so far from the origin that rounding moves its points visibly, which is said in a
/// note.
inline constexpr double kFewSteps = 1 << 17;

/// Unit lengths. Points within this of each other are one sample: circumscribed balls cannot be
/// told apart at such distances (kCospherical), and the ball between two such points has no
/// meaning.
inline constexpr double kNearDuplicate = 2e-11;

/// Sum of unit normals shorter than this (no unit) is of opposite normals: the direction is
/// unknown.
inline constexpr double kOppositeNormals = 1e-9;

/// Looks at a corner, per corner of a polygon, that ear clipping may take before it just cuts: a
/// polygon of 100,000 corners and long needles took between 4,000 and 20,000, and is done within
/// seconds.
inline constexpr int64_t kEarWork = 20'000;

/// Share of a part's faces, by area, that must agree on a direction for it to be kept when the
/// others are turned; below it a closed part takes the direction that gives it a positive volume.
inline constexpr double kClearMajority = 0.75;

/// Holes are closed with caps, for telling inside from outside only, where the caps are at most
/// this share of their part's area; and open parts are passed over beside closed ones if they are
/// at most this share of the whole area.
inline constexpr double kMostOpenArea = 0.25;

/// Parts (pieces of a mesh not joined by edges) that are compared with each other one by one: with
/// more, nested parts are not looked for, as that takes quadratic time.
inline constexpr std::size_t kManyParts = 4000;

/// Automatic spacing is at most the bounding-box diagonal over this: enough for a cube of twelve
/// triangles to become a solid of some 6,000 samples.
inline constexpr double kSpacingsAcross = 50;

/// Automatic spacing is at most this times the longest side of the typical triangle (the median by
/// area): a mesh that is evenly dense already gets next to nothing added.
inline constexpr double kTypicalSides = 1.5;

/// Cosine (40 degrees) of the angle between faces up to which an edge bends gently, and the share
/// of all bent edges, by length, that must for a mesh to stand for a smooth shape. Its faces are
/// then not sampled finer than its vertices: samples on the flat of a face lie below the curve, and
/// the balls would fit the facets and not the shape.
inline constexpr double kGentle = 0.766, kSmoothShare = 0.9;

/// Or else automatic spacing is at most this times what half the area's triangles are narrower
/// than: long strips, as of a cylinder, are cut along their length and not across. As much as
/// kTypicalSides of a square's halves, so that evenly dense meshes get no more.
inline constexpr double kTypicalWidths = 3;

/// ... unless that is less than the diagonal over this: needles are not cut for the sake of their width.
inline constexpr double kMostAcross = 400;

/// Ratio. A mesh whose typical triangle asks for a spacing (kTypicalSides) of at most this times
/// what the whole shape does (kSpacingsAcross) is evenly dense, and not looked at for thin walls:
/// scanned and remeshed shapes are at 0.5 to 2.3, those made of a few large faces above 5.
inline constexpr double kEvenlyDense = 2.5;

/// Samples that a wall's thickness has for every one along it, where the spacing is automatic. At
/// sharp edges there are twice as many. Measured on plates and bars: the sheet in a wall needs 2.3
/// (kResolved of samples kLattice apart, and jitter), the sheets that run into sharp edges 5.5.
inline constexpr double kSamplesThrough = 3;

/// Ratio. Samples are counted for a spacing from its probes, and it is enlarged if they become more
/// than so many times as many as they should.
inline constexpr double kMostOverEstimate = 1.25;

/// Growth of the spacing by distance from where it is small.
inline constexpr double kSpacingGrowth = 0.25;

/// Ratio. Lattices of levels are taken for a spacing that is less than theirs by rounding only.
inline constexpr double kLevelSlack = 1 + 1e-9;

/// Thin walls get at most so many samples more, and of these at most so many times their share of
/// the area, but always the least.
inline constexpr double kMostThin = 350'000, kThinShare = 4, kLeastThin = 10'000;

/// Automatic spacing adds at most the larger of so many samples and so many per vertex, ...
inline constexpr double kMostAdded = 200'000, kMostAddedPerVertex = 4;
/// ... and is raised by this factor until it does.
inline constexpr double kSpacingStep = 1.25;

/// Cosine of the angle (0.1 degrees) between faces that are taken as one plane when samples are
/// spread over them: what rounding to single precision does to the triangles of one plane.
inline constexpr double kSamePlane = 0.9999985;

/// The lattice of samples on a plane, all in units of the spacing h. With distance c between
/// neighbours every point is within c / sqrt(3) of the unclipped lattice; samples nearer than
/// `margin` to a sharp edge or to a corner are left out. As sharp edges have samples at most h
/// apart, every point is within sqrt((c / sqrt(3) + margin)^2 + 1/4) = 0.985 of a sample, or within
/// c / sqrt(3) + jitter = 0.65.
inline constexpr double kLattice = 0.95, kLatticeMargin = 0.3;
/// Samples are moved within their plane by at most this, so that not all sets of four are
/// cocircular: with it the Delaunay triangulation of a cube's lattice takes two thirds of the time.
inline constexpr double kLatticeJitter = 0.1;

/// Share of a mesh's edges that may have three or more faces without balance (as where a wall is
/// glued into a solid) before its normals are no longer trusted to tell inside from outside.
inline constexpr double kMostBranching = 0.01;

/// Samples of a volume stay this far from the voxels' centres (in grid edges), so that no two grid
/// edges that end at a centre share a sample there.
inline constexpr double kVoxelMargin = 0.02;

/// Boxes of the triangle tree are widened by this (unit frame lengths), far more than the rounding
/// of a ray's slab test and far less than any triangle that matters for speed.
inline constexpr double kBoxSlack = 1e-12;

/// Faces within this of a point of the surface (unit frame lengths) meet at it: some hundred times
/// the rounding of coordinates below 1.
inline constexpr double kTouching = 1e-13;

} // namespace vbm::impl
