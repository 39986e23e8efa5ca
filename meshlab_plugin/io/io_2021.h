// SPDX-License-Identifier: GPL-3.0-or-later
// Files of balls, behind the plugin interface of MeshLab 2021.05 and later.
#pragma once

#include "ball_io.h"

#include <common/plugins/interfaces/io_plugin.h>

class BallFilesPlugin : public QObject, public IOPlugin {
  Q_OBJECT
  MESHLAB_PLUGIN_IID_EXPORTER(IO_PLUGIN_IID)
  Q_INTERFACES(IOPlugin)

public:
  QString pluginName() const override;
  QString vendor() const override;
  std::list<FileFormat> importFormats() const override;
  std::list<FileFormat> exportFormats() const override;
  void exportMaskCapability(const QString &format, int &capability, int &chosen) const override;
  using IOPlugin::open;
  void open(const QString &format, const QString &path, MeshModel &layer, int &mask,
            const RichParameterList &params, vcg::CallBackPos *callback) override;
  void save(const QString &format, const QString &path, MeshModel &layer, const int mask,
            const RichParameterList &params, vcg::CallBackPos *callback) override;
};
