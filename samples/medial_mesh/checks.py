# SPDX-License-Identifier: GPL-3.0-or-later
"""What a medial mesh must be, by counts that share nothing with the library."""

import gudhi
import numpy as np


def betti(mesh):
    """Pieces, tunnels and cavities of an axis or medial mesh as a simplicial complex, by GUDHI."""
    tree = gudhi.SimplexTree()
    for cells in (np.arange(len(mesh.vertices))[:, None], mesh.edges, mesh.triangles):
        if len(cells):
            tree.insert_batch(np.array(cells.T, np.int32), np.zeros(len(cells)))
    tree.compute_persistence(persistence_dim_max=True)
    return tuple((tree.betti_numbers() + [0, 0, 0])[:3])


def flaws(mesh, cavities=0):
    """Doubled triangles, balls of no cell, and more hollow tetrahedra than there are cavities, in words."""
    triangles = np.sort(mesh.triangles, axis=1)
    faces = set(map(tuple, triangles.tolist()))
    if len(faces) != len(triangles):
        yield f"{len(triangles) - len(faces)} doubled triangles"
    used = np.zeros(len(mesh.vertices), bool)
    used[mesh.triangles] = used[mesh.edges] = True
    if not used.all() and len(used) > 1:
        yield f"{np.count_nonzero(~used)} balls of no triangle or edge"
    beside = {}  # the third corners at every edge of a triangle
    for a, b, c in faces:
        for edge, other in (((a, b), c), ((a, c), b), ((b, c), a)):
            beside.setdefault(edge, set()).add(other)
    hollow = {tuple(sorted((*t, d))) for t in faces
              for d in beside[t[0], t[1]] & beside[t[0], t[2]] & beside[t[1], t[2]]}
    if len(hollow) > cavities:
        yield f"{len(hollow)} hollow tetrahedra"
