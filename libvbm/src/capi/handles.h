// SPDX-License-Identifier: GPL-3.0-or-later
// What the opaque handles of vbm.h are.
#pragma once

#include "core/model.h"
#include "measure/union_measures.h"
#include "match/clusters.h"
#include "medial/axis.h"
#include "medial/medial_mesh.h"

#include <vbm/vbm.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

struct vbm_context {
  vbm_progress_fn progress = nullptr;
  void *user = nullptr;
  int threads = 0; // at most, 0 for as many as there are processors

  // About the last call. `text` is what vbm_context_message() returns: `message`, or a literal when
  // there was no memory left to compose one.
  std::string message;
  const char *text = "";
  const char *kind = "";
  std::vector<int64_t> elements;
  std::size_t total = 0;
};

struct vbm_model {
  explicit vbm_model(vbm::impl::Model &&built)
      : shared(std::make_shared<const vbm::impl::Model>(std::move(built))), model(*shared) {}

  std::shared_ptr<const vbm::impl::Model> shared; // with the axes made of it
  const vbm::impl::Model &model;
};

struct vbm_axis {
  vbm::impl::Axis axis;
};

struct vbm_measures {
  vbm::impl::UnionMeasures measures; // input units
  vbm_measures_report report;
};

struct vbm_medial_mesh {
  vbm::impl::MedialMesh mesh;
};

struct vbm_clusters {
  vbm::impl::Clusters clusters;
};

struct vbm_surface {
  vbm::impl::Surface surface;
};
