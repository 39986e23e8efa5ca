// SPDX-License-Identifier: GPL-3.0-or-later
// The filters, behind the plugin interface of MeshLab 2021.05 and later.
#pragma once

#include "apply.h"

class VoronoiBallsPlugin : public QObject, public FilterPlugin {
  Q_OBJECT
  MESHLAB_PLUGIN_IID_EXPORTER(FILTER_PLUGIN_IID)
  Q_INTERFACES(FilterPlugin)

public:
  VoronoiBallsPlugin();

  QString pluginName() const override;
  QString vendor() const override;
  QString filterName(ActionIDType id) const override;
  QString pythonFilterName(ActionIDType id) const override;
  QString filterInfo(ActionIDType id) const override;
  FilterClass getClass(const QAction *action) const override;
  FilterArity filterArity(const QAction *action) const override;
  int postCondition(const QAction *action) const override;
  RichParameterList initParameterList(const QAction *action, const MeshDocument &document) override;
  std::map<std::string, QVariant> applyFilter(const QAction *action,
                                              const RichParameterList &params,
                                              MeshDocument &document, unsigned int &changed,
                                              vcg::CallBackPos *callback) override;

private:
  const vbm_filters::Filter &filter(const QAction *action) const;
  vbm_meshlab::Applier applier_;
};
