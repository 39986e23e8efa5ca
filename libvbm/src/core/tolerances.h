// SPDX-License-Identifier: GPL-3.0-or-later
// Every tolerance of the library, each with its unit and its reason. "Unit lengths" are lengths in
// the unit frame, where the largest side of the input's bounding box lies in [0.5, 1].
#pragma once

namespace vbm::impl {

/// Unit lengths. Points nearer than this to a common plane have no inside that doubles could
/// resolve.
inline constexpr double kFlat = 1e-12;

/// Unit lengths. Corners of the closing box lie this far from the origin along each axis: far
/// enough that outer polar balls at the hull are nearly half-spaces, near enough that they keep
/// their digits.
inline constexpr double kBoxHalfSide = 4;

/// Power of two. Larger input is refused: outer balls are up to some hundred times its size, and
/// must still be numbers.
inline constexpr int kMaxExponent = 1000;

/// Ratio |a||b||c| / |det(a, b, c)| of a tetrahedron's edges from which on its circumcentre is
/// computed exactly: below it doubles give the centre to about 1e-11 of the edges' length.
inline constexpr double kIllConditioned = 1e4;

/// Unit lengths. Tetrahedra across a facet are one ball if the far vertex of each lies this near
/// the sphere of the better conditioned of the two: well above rounding, well below any sampling.
inline constexpr double kCospherical = 1e-11;

/// Ratio of that distance to the far vertex's distance from the tetrahedron's own, above which it
/// is not on the sphere: a near duplicate lies near every sphere through its neighbour, on either
/// side of the surface.
inline constexpr double kCosphericalShare = 1e-4;

/// Ratio. The power diagram sees every inner ball's radius smaller and every outer one's larger, by
/// its own pseudo-random part of this. Balls that touch a common sample make power tests of nearly
/// zero, which cost exact arithmetic and tell nothing; so changed, doubles decide nearly all of
/// them. Where tetrahedra of the solid touch only along an edge or at a sample, the outer balls
/// have what is between them, so that they are not joined there. Millions of times the rounding of
/// a centre, and far below what moves a crust vertex visibly.
inline constexpr double kPowerChange = 1e-9;

/// Unit lengths. A vertex of the power crust is computed in more digits where doubles may err by
/// more.
inline constexpr double kCrustVertexError = 1e-10;

/// Ratio of a power crust vertex's distance from the centre of an inner ball of its to that ball's
/// radius. On sound models it is about 1, seen up to 1.5 at sharp edges; where balls were left out
/// or the sampling is far too thin nothing bounds it, and vertices are drawn back to this.
inline constexpr double kCrustReach = 3;

/// Ratios. A vertex of the power crust merges into a sample where its distance to that one is less
/// than kCrustPull times that to any other, and into another vertex that is nearer to it than
/// kCrustMerge times the nearest sample; where the surface stays what it is. The crust has four or
/// five vertices between samples for every sample, most of them at tiny edges.
inline constexpr double kCrustPull = 0.4;
inline constexpr double kCrustMerge = 0.6;

/// Sine of an angle. Merging near vertices of the power crust must not turn a corner of its convex
/// polygons inwards by more than this; merging those that are one sample does by less.
inline constexpr double kCrustFold = 0.2;

/// Unit lengths. Smaller balls of a list are taken as points, which bound nothing: of their spheres
/// doubles could not tell one place from another.
inline constexpr double kLeastBall = 1e-12;

/// Ratio. Balls of a dual shape have their radii grown by this, so that balls which touch do meet, in
/// spite of rounding: round a point that all of them touch the outside then is one convex piece or
/// nothing, never a void. Above kPowerChange, which the balls then differ by, and far below what
/// can be seen.
inline constexpr double kTouch = 1e-8;

/// Unit lengths. Balls of a model touch their samples to within this: kCospherical, and what
/// rounding adds. Their radii are grown by it as well.
inline constexpr double kModelTouch = 2e-11;

/// Unit lengths. The points where three or four balls of a dual shape are equally far are computed in
/// more digits where doubles may err by more.
inline constexpr double kOrthocenterError = 1e-13;

} // namespace vbm::impl
