// SPDX-License-Identifier: GPL-3.0-or-later
// What MeshLab wants to know of a filter before it runs, in words that all releases share.
#pragma once

#include "../filters/filter.h"
#include "meshlab.h"

namespace vbm_meshlab {

// The submenus it stands in. Not VertexColoring: MeshLab would then give every layer vertex
// colours, whether the user asked for them or not.
template <class Interface>
typename Interface::FilterClass filter_class(const vbm_filters::Filter &filter) {
  using Class = typename Interface::FilterClass;
  return filter.adds_layer ? Class(int(Interface::Remeshing) | int(Interface::PointSet))
                           : Class(int(Interface::Quality) | int(Interface::Measure));
}

// What of the layer it is applied to it changes. A filter that only adds a layer changes nothing:
// with anything else here, MeshLab would set the layer back to what an earlier dialog remembers of
// it.
inline int changes(const vbm_filters::Filter &filter) {
  return filter.adds_layer
             ? MeshModel::MM_NONE
             : MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTRADIUS | MeshModel::MM_VERTCOLOR;
}

} // namespace vbm_meshlab
