# SPDX-License-Identifier: GPL-3.0-or-later
"""The computing, without Blender's data: safe to run in a thread. Results come from the cache."""

from . import cache
from .job import Phase
from .library import vbm


class Request:
    """A model to be built: the input, the options, and the key it is kept under."""

    def __init__(self, source, arguments):
        self.source = source
        self.arguments = arguments
        self.key = (source.digest, tuple(sorted(arguments.items())))

    @property
    def cached(self):
        return cache.get(self.key)


class Built:
    """A model, and the surfaces and medial axes asked of it so far."""

    def __init__(self, model):
        self.model = model
        self.surfaces = {}
        self.axes = cache.Kept(2)


def build(request, progress):
    """The model for a request, built or from the cache."""
    built = cache.get(request.key)
    if built is None:
        source = request.source
        faces = None if source.sizes is None else (source.sizes, source.corners)
        built = Built(vbm.build(source.points, normals=source.normals, faces=faces,
                                progress=progress, **request.arguments))
        cache.put(request.key, built)
    return built


def surface(request, style, progress):
    """(Built, Surface): `style` is "INTERPOLATING" or "POWER_CRUST"."""
    # The triangulation is most of the work for the one, the power diagram for the other.
    share = 0.8 if style == "INTERPOLATING" else 0.4
    built = build(request, Phase(progress, 0.0, share))
    if style not in built.surfaces:
        make = built.model.surface if style == "INTERPOLATING" else built.model.power_crust
        built.surfaces[style] = make(progress=Phase(progress, share, 1.0))
    return built, built.surfaces[style]
