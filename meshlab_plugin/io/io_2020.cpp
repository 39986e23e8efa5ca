// SPDX-License-Identifier: GPL-3.0-or-later
#include "io_2020.h"

using namespace vbm_meshlab;

QString BallFilesPlugin::pluginName() const { return "IOBalls"; }

QList<MeshIOInterface::Format> BallFilesPlugin::importFormats() const {
  QList<Format> list;
  for (const BallFormat &format : ball_formats())
    if (format.reads) list << Format(format.description, QString(format.extension).toUpper());
  return list;
}

QList<MeshIOInterface::Format> BallFilesPlugin::exportFormats() const {
  QList<Format> list;
  for (const BallFormat &format : ball_formats())
    list << Format(format.description, QString(format.extension).toUpper());
  return list;
}

void BallFilesPlugin::GetExportMaskCapability(QString &, int &capability, int &chosen) const {
  capability = chosen = vcg::tri::io::Mask::IOM_VERTRADIUS;
}

bool BallFilesPlugin::open(const QString &, const QString &path, MeshModel &layer, int &mask,
                           const RichParameterList &, vcg::CallBackPos *, QWidget *) {
  try {
    errorMessage.clear();
    const BallsRead read = read_balls(path, layer);
    mask = read.mask;
    if (!read.warning.isEmpty()) Log(GLLogStream::WARNING, read.warning.toStdString());
    return true;
  } catch (const std::exception &error) {
    errorMessage = QString::fromUtf8(error.what());
    qWarning("%s", error.what()); // meshlabserver shows nothing else
  }
  return false;
}

bool BallFilesPlugin::save(const QString &, const QString &path, MeshModel &layer, const int,
                           const RichParameterList &, vcg::CallBackPos *, QWidget *) {
  try {
    errorMessage.clear();
    write_balls(path, layer);
    return true;
  } catch (const std::exception &error) {
    errorMessage = QString::fromUtf8(error.what());
    qWarning("%s", error.what());
  }
  return false;
}

MESHLAB_PLUGIN_NAME_EXPORTER(BallFilesPlugin)
