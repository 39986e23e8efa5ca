// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin_2021.h"

#include "dialog.h"
#include "traits.h"

using namespace vbm_meshlab;

VoronoiBallsPlugin::VoronoiBallsPlugin() {
  for (std::size_t i = 0; i < vbm_filters::filters().size(); ++i) {
    typeList.push_back(static_cast<int>(i));
    actionList.push_back(new QAction(filterName(static_cast<int>(i)), this));
  }
}

const vbm_filters::Filter &VoronoiBallsPlugin::filter(const QAction *action) const {
  return *vbm_filters::filters().at(static_cast<std::size_t>(ID(action)));
}

QString VoronoiBallsPlugin::pluginName() const { return "FilterVoronoiBalls"; }

QString VoronoiBallsPlugin::vendor() const { return "libvbm"; }

QString VoronoiBallsPlugin::filterName(ActionIDType id) const {
  return vbm_filters::filters().at(static_cast<std::size_t>(id))->name;
}

QString VoronoiBallsPlugin::pythonFilterName(ActionIDType id) const {
  return vbm_filters::filters().at(static_cast<std::size_t>(id))->python_name;
}

QString VoronoiBallsPlugin::filterInfo(ActionIDType id) const {
  return vbm_filters::filters().at(static_cast<std::size_t>(id))->help;
}

FilterPlugin::FilterClass VoronoiBallsPlugin::getClass(const QAction *action) const {
  return filter_class<FilterPlugin>(filter(action));
}

FilterPlugin::FilterArity VoronoiBallsPlugin::filterArity(const QAction *) const {
  return FilterPlugin::SINGLE_MESH;
}

int VoronoiBallsPlugin::postCondition(const QAction *action) const {
  return changes(filter(action));
}

RichParameterList VoronoiBallsPlugin::initParameterList(const QAction *action,
                                                        const MeshDocument &document) {
  return dialog(filter(action).params(), document.mm());
}

std::map<std::string, QVariant> VoronoiBallsPlugin::applyFilter(const QAction *action,
                                                                const RichParameterList &params,
                                                                MeshDocument &document,
                                                                unsigned int &changed,
                                                                vcg::CallBackPos *callback) {
  const vbm_filters::Filter &chosen = filter(action);
  changed = static_cast<unsigned int>(changes(chosen));
  try {
    const auto found =
        applier_.apply(chosen, values(chosen.params(), params), document, callback,
                       [this](bool warning, const std::string &text) {
                         log(warning ? GLLogStream::WARNING : GLLogStream::FILTER, text);
                       });
    std::map<std::string, QVariant> measures;
    for (const auto &[name, value] : found) measures[name] = value;
    return measures;
  } catch (const std::exception &error) {
    throw MLException(QString::fromUtf8(error.what()));
  } catch (...) {
    throw MLException("The filter failed for an unknown reason.");
  }
}
