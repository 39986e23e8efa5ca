// SPDX-License-Identifier: GPL-3.0-or-later
// Between MeshLab's mesh and the filters' arrays.
#pragma once

#include "../filters/layer.h"
#include "meshlab.h"

namespace vbm_meshlab {

// Everything about the user's layer that a filter needs, so that the layer itself need not be
// touched while the filter runs: MeshLab handles events meanwhile, and the layer may change or go.
struct Source {
  int id = 0;
  Matrix44m matrix;
  std::size_t places = 0;         // vertices, deleted ones included
  std::vector<std::size_t> place; // of every vertex of `layer`
  vbm_filters::Layer layer;
};

Source copy_out(MeshModel &model);

void fill(MeshModel &model, const vbm_filters::NewLayer &result);

// Quality, radius and, if wanted, colour of the vertices that were copied out.
void write(MeshModel &model, const Source &source, const vbm_filters::VertexValues &values);

// Selects those of the vertices copied out that have a 1, and no others.
void select(MeshModel &model, const Source &source, const std::vector<std::uint8_t> &chosen);

} // namespace vbm_meshlab
