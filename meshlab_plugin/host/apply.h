// SPDX-License-Identifier: GPL-3.0-or-later
// One filter, applied to a document's current layer: the part that every release of MeshLab shares.
#pragma once

#include "../filters/filter.h"
#include "meshlab.h"

#include <functional>

namespace vbm_meshlab {

using Log = std::function<void(bool warning, const std::string &)>;

class Applier {
public:
  // Gives the filter's measures, for scripts. Throws vbm_filters::Failure with the sentence for the
  // user, which it has logged as well, and nothing else. A failure leaves the document as it was.
  std::map<std::string, double> apply(const vbm_filters::Filter &filter,
                                      const vbm_filters::Values &values, MeshDocument &document,
                                      vcg::CallBackPos *callback, const Log &log);

private:
  vbm_filters::AxisStore axes_;
  // MeshLab's progress callback handles events, Apply pressed a second time among them.
  bool busy_ = false;
};

} // namespace vbm_meshlab
