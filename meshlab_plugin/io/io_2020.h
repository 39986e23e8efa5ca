// SPDX-License-Identifier: GPL-3.0-or-later
// Files of balls, behind the plugin interface of MeshLab 2020.09.
#pragma once

#include "ball_io.h"

class BallFilesPlugin : public QObject, public MeshIOInterface {
  Q_OBJECT
  MESHLAB_PLUGIN_IID_EXPORTER(MESH_IO_INTERFACE_IID)
  Q_INTERFACES(MeshIOInterface)

public:
  QString pluginName() const override;
  QList<Format> importFormats() const override;
  QList<Format> exportFormats() const override;
  void GetExportMaskCapability(QString &format, int &capability, int &chosen) const override;
  bool open(const QString &format, const QString &path, MeshModel &layer, int &mask,
            const RichParameterList &params, vcg::CallBackPos *callback, QWidget *parent) override;
  bool save(const QString &format, const QString &path, MeshModel &layer, const int mask,
            const RichParameterList &params, vcg::CallBackPos *callback, QWidget *parent) override;
};
