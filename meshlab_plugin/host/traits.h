// SPDX-License-Identifier: GPL-3.0-or-later
// What MeshLab wants to know of a filter before it runs, in words that all releases share.
#pragma once

#include "../filters/filter.h"
#include "meshlab.h"

#include <utility>

namespace vbm_meshlab {

// The submenus it stands in. Not VertexColoring: MeshLab would then give every layer vertex
// colours, whether the user asked for them or not.
template <class Interface>
typename Interface::FilterClass filter_class(const vbm_filters::Filter &filter) {
  constexpr std::pair<vbm_filters::Menu, int> kMenus[] = {
      {vbm_filters::kRemeshing, Interface::Remeshing},
      {vbm_filters::kPointSet, Interface::PointSet},
      {vbm_filters::kQuality, Interface::Quality},
      {vbm_filters::kMeasure, Interface::Measure},
      {vbm_filters::kSelection, Interface::Selection},
  };
  int all = 0;
  for (const auto &[menu, own] : kMenus)
    if (filter.menus & menu) all |= own;
  return typename Interface::FilterClass(all);
}

// What of the layer it is applied to it changes. A filter that only adds a layer changes nothing:
// with anything else here, MeshLab would set the layer back to what an earlier dialog remembers of
// it.
inline int changes(const vbm_filters::Filter &filter) {
  int all = MeshModel::MM_NONE;
  if (filter.writes & vbm_filters::kVertexQuality) all |= MeshModel::MM_VERTQUALITY;
  if (filter.writes & vbm_filters::kVertexRadius) all |= MeshModel::MM_VERTRADIUS;
  if (filter.writes & vbm_filters::kVertexColor) all |= MeshModel::MM_VERTCOLOR;
  return all;
}

} // namespace vbm_meshlab
