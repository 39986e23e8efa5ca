// SPDX-License-Identifier: GPL-3.0-or-later
// Files of balls as layers whose vertices have a radius, and back: what every release of MeshLab
// shares. PLY is not among them: MeshLab reads and writes a PLY file's radius itself.
#pragma once

#include "../host/meshlab.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace vbm_meshlab {

struct BallFormat {
  const char *extension, *description;
  bool reads; // all are written
};

const std::vector<BallFormat> &ball_formats();

struct BallsRead {
  int mask = 0;    // what the file has: bits of vcg::tri::io::Mask
  QString warning; // about what a layer has no room for, or ""
};

// Fills the layer, which is empty; or throws vbm_filters::Failure with the sentence for the user,
// and nothing else, before anything is added. So does write_balls().
BallsRead read_balls(const QString &path, MeshModel &layer);
void write_balls(const QString &path, MeshModel &layer);

} // namespace vbm_meshlab
