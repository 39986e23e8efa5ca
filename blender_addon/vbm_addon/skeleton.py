# SPDX-License-Identifier: GPL-3.0-or-later
"""A curve skeleton's branches, and joints for bones along them. Arrays only, no bpy.

A skeleton is a graph: vertices that are balls, and edges. A branch runs between two vertices where not
exactly two edges meet. An armature is a tree, so a loop of branches is cut at the vertex where the walk
from the thickest place arrives from both sides.
"""

from collections import deque
from dataclasses import dataclass

import numpy as np


@dataclass
class Branch:
    """Vertices in order; `parent` is the branch that leads to the first of them, or -1."""

    vertices: list
    parent: int = -1
    #: Whether it closes a loop and was cut off where it ends.
    cut: bool = False


def _neighbors(edges):
    neighbors = {}
    for a, b in np.asarray(edges).tolist():
        neighbors.setdefault(a, []).append(b)
        neighbors.setdefault(b, []).append(a)
    for found in neighbors.values():
        found.sort()
    return neighbors


def branches(edges):
    """The branches of a graph, as lists of vertices; a loop by itself begins and ends at its lowest."""
    neighbors = _neighbors(edges)
    seen, found = set(), []

    def follow(start, second):
        path = [start, second]
        seen.add(frozenset(path))
        while len(neighbors[path[-1]]) == 2 and path[-1] != start:
            one, other = neighbors[path[-1]]
            path.append(other if one == path[-2] else one)
            seen.add(frozenset(path[-2:]))
        return path

    ends = [v for v in sorted(neighbors) if len(neighbors[v]) != 2]
    for start in ends + sorted(neighbors):
        for second in neighbors[start]:
            if frozenset((start, second)) not in seen:
                found.append(follow(start, second))
    return found


def without_stubs(edges, vertices, radii):
    """The edges but for side branches that end within the ball they begin in: they are no limbs."""
    all_branches = branches(edges)
    degree = {v: len(n) for v, n in _neighbors(edges).items()}
    kept = []
    for path in all_branches:
        if degree[path[0]] == 1:
            path = path[::-1]
        stub = (degree[path[-1]] == 1 and degree[path[0]] > 2
                and lengths(vertices, path)[-1] < radii[path[0]])
        if not stub:
            kept += zip(path, path[1:])
    return np.array(kept).reshape(-1, 2) if kept else np.asarray(edges)


def lengths(vertices, path):
    """The way along a path to each of its vertices."""
    steps = np.linalg.norm(np.diff(np.asarray(vertices)[path], axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])


def tree(edges, radii):
    """The branches in an order in which parents come first, walking from the thickest vertex."""
    found = branches(edges)
    at = {}
    for index, path in enumerate(found):
        for end in {path[0], path[-1]}:
            at.setdefault(end, []).append(index)
    ordered, used, reached = [], set(), {}
    # One walk for every piece of the skeleton.
    for root in sorted(at, key=lambda v: (-radii[v], v)):
        if root in reached:
            continue
        reached[root] = -1
        queue = deque([root])
        while queue:
            start = queue.popleft()
            for index in at[start]:
                if index in used:
                    continue
                used.add(index)
                path = found[index] if found[index][0] == start else found[index][::-1]
                ordered.append(Branch(path, reached[start], path[-1] in reached))
                if path[-1] not in reached:
                    reached[path[-1]] = len(ordered) - 1
                    queue.append(path[-1])
    return ordered


def joints(branch, vertices, radii, bone_length, most):
    """Joints of a branch at even distances: (positions, radii), one more than it gets bones.

    A bone is about `bone_length` times as long as the branch is thick there; a branch gets at most
    `most`, and one that closes a loop at least two, or its bones could not bend round.
    """
    way = lengths(vertices, branch.vertices)
    middle = 0.5 * (way[1:] + way[:-1])
    along = np.asarray(radii)[branch.vertices]
    if way[-1] <= 0.0:
        return np.zeros((0, 3)), np.zeros(0)
    thickness = 2.0 * np.average(np.interp(middle, way, along), weights=np.diff(way))
    wanted = way[-1] / max(bone_length * thickness, 1e-9 * way[-1])
    ring = branch.vertices[0] == branch.vertices[-1]
    least = 3 if ring else 2 if branch.cut else 1
    count = int(np.clip(round(wanted), least, max(most, least)))
    stops = np.linspace(0.0, way[-1], count + 1)
    points = np.asarray(vertices)[branch.vertices]
    return (np.stack([np.interp(stops, way, points[:, axis]) for axis in range(3)], axis=1),
            np.interp(stops, way, along))
