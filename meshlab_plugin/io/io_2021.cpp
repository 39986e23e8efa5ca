// SPDX-License-Identifier: GPL-3.0-or-later
#include "io_2021.h"

using namespace vbm_meshlab;

QString BallFilesPlugin::pluginName() const { return "IOBalls"; }

QString BallFilesPlugin::vendor() const { return "libvbm"; }

std::list<FileFormat> BallFilesPlugin::importFormats() const {
  std::list<FileFormat> list;
  for (const BallFormat &format : ball_formats())
    if (format.reads) list.emplace_back(format.description, QString(format.extension).toUpper());
  return list;
}

std::list<FileFormat> BallFilesPlugin::exportFormats() const {
  std::list<FileFormat> list;
  for (const BallFormat &format : ball_formats())
    list.emplace_back(format.description, QString(format.extension).toUpper());
  return list;
}

void BallFilesPlugin::exportMaskCapability(const QString &, int &capability, int &chosen) const {
  capability = chosen = vcg::tri::io::Mask::IOM_VERTRADIUS;
}

void BallFilesPlugin::open(const QString &, const QString &path, MeshModel &layer, int &mask,
                           const RichParameterList &, vcg::CallBackPos *) {
  try {
    const BallsRead read = read_balls(path, layer);
    mask = read.mask;
    if (!read.warning.isEmpty()) reportWarning(read.warning);
  } catch (const std::exception &error) {
    throw MLException(QString::fromUtf8(error.what()));
  }
}

void BallFilesPlugin::save(const QString &, const QString &path, MeshModel &layer, const int,
                           const RichParameterList &, vcg::CallBackPos *) {
  try {
    write_balls(path, layer);
  } catch (const std::exception &error) {
    throw MLException(QString::fromUtf8(error.what()));
  }
}
