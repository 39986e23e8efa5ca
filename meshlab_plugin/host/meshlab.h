// SPDX-License-Identifier: GPL-3.0-or-later
// MeshLab's own headers, whose places and names change between its releases. The generation is set
// by CMake from the version found: 2020 for 2020.09, 2021 for 2021.05 and later.
#pragma once

#if VBM_MESHLAB_GENERATION == 2020
#include <common/interfaces.h>
#include <common/meshmodel.h>
#else
#include <common/ml_document/mesh_document.h>
#include <common/plugins/interfaces/filter_plugin.h>
#endif

namespace vbm_meshlab {

inline void delete_layer(MeshDocument &document, MeshModel *layer) {
#if VBM_MESHLAB_GENERATION == 2020
  document.delMesh(layer);
#else
  document.delMesh(layer->id());
#endif
}

} // namespace vbm_meshlab
