// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin_2020.h"

#include "dialog.h"
#include "traits.h"

using namespace vbm_meshlab;

VoronoiBallsPlugin::VoronoiBallsPlugin() {
  for (std::size_t i = 0; i < vbm_filters::filters().size(); ++i) {
    typeList << static_cast<int>(i);
    actionList << new QAction(filterName(static_cast<int>(i)), this);
  }
}

const vbm_filters::Filter &VoronoiBallsPlugin::filter(QAction *action) const {
  return *vbm_filters::filters().at(static_cast<std::size_t>(ID(action)));
}

QString VoronoiBallsPlugin::pluginName() const { return "FilterVoronoiBalls"; }

QString VoronoiBallsPlugin::filterName(FilterIDType id) const {
  return vbm_filters::filters().at(static_cast<std::size_t>(id))->name;
}

QString VoronoiBallsPlugin::filterInfo(FilterIDType id) const {
  return vbm_filters::filters().at(static_cast<std::size_t>(id))->help;
}

MeshFilterInterface::FilterClass VoronoiBallsPlugin::getClass(QAction *action) {
  return filter_class<MeshFilterInterface>(filter(action));
}

MeshFilterInterface::FILTER_ARITY VoronoiBallsPlugin::filterArity(QAction *) const {
  return MeshFilterInterface::SINGLE_MESH;
}

int VoronoiBallsPlugin::postCondition(QAction *action) const { return changes(filter(action)); }

void VoronoiBallsPlugin::initParameterSet(QAction *action, MeshDocument &document,
                                          RichParameterList &params) {
  params = dialog(filter(action).params(), document.mm());
}

bool VoronoiBallsPlugin::applyFilter(QAction *action, MeshDocument &document,
                                     const RichParameterList &params, vcg::CallBackPos *callback) {
  try {
    errorMessage.clear();
    const vbm_filters::Filter &chosen = filter(action);
    applier_.apply(chosen, values(chosen.params(), params), document, callback,
                   [this](bool warning, const std::string &text) {
                     Log(warning ? GLLogStream::WARNING : GLLogStream::FILTER, text);
                   });
    return true;
  } catch (const std::exception &error) {
    errorMessage = QString::fromUtf8(error.what());
  } catch (...) {
    errorMessage = "The filter failed for an unknown reason.";
  }
  return false;
}

MESHLAB_PLUGIN_NAME_EXPORTER(VoronoiBallsPlugin)
