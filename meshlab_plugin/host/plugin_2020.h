// SPDX-License-Identifier: GPL-3.0-or-later
// The filters, behind the plugin interface of MeshLab 2020.09.
#pragma once

#include "apply.h"

class VoronoiBallsPlugin : public QObject, public MeshFilterInterface {
  Q_OBJECT
  MESHLAB_PLUGIN_IID_EXPORTER(MESH_FILTER_INTERFACE_IID)
  Q_INTERFACES(MeshFilterInterface)

public:
  VoronoiBallsPlugin();

  QString pluginName() const override;
  QString filterName(FilterIDType id) const override;
  QString filterInfo(FilterIDType id) const override;
  FilterClass getClass(QAction *action) override;
  FILTER_ARITY filterArity(QAction *action) const override;
  int postCondition(QAction *action) const override;
  void initParameterSet(QAction *action, MeshDocument &document,
                        RichParameterList &params) override;
  bool applyFilter(QAction *action, MeshDocument &document, const RichParameterList &params,
                   vcg::CallBackPos *callback) override;

private:
  const vbm_filters::Filter &filter(QAction *action) const;
  vbm_meshlab::Applier applier_;
};
