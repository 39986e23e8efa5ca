// SPDX-License-Identifier: GPL-3.0-or-later
#include "host.h"

#include <QAction>
#include <QDomDocument>
#include <QPluginLoader>

#include <stdexcept>

#if VBM_MESHLAB_GENERATION == 2020
using Plugin = MeshFilterInterface;
#else
using Plugin = FilterPlugin;
#if VBM_MESHLAB_PERCENTAGE
#include <common/parameters/rich_parameters.h>
#endif
#endif

namespace host {

const char *const kBalls = "Voronoi Balls: Build Ball Model";
const char *const kSurface = "Voronoi Balls: Rebuild Closed Surface";
const char *const kThickness = "Voronoi Balls: Compute Thickness";
const char *const kAxis = "Voronoi Balls: Build Medial Axis";
const char *const kSimplify = "Voronoi Balls: Simplify Shape";
const char *const kRemoveParts = "Voronoi Balls: Remove Selected Parts";
const char *const kPartColor = "Voronoi Balls: Colour by Part";
const char *const kBallSurface = "Voronoi Balls: Build Surface from Balls";
const char *const kCluster = "Voronoi Balls: Cluster Balls";
const char *const kBallMeasures = "Voronoi Balls: Measure Union of Balls";
const char *const kAxisOfBalls = "Voronoi Balls: Build Axis of N Balls";

namespace {

Plugin &plugin() {
  static Plugin *loaded = [] {
    static QPluginLoader loader(VBM_PLUGIN);
    Plugin *plugin = qobject_cast<Plugin *>(loader.instance());
    if (!plugin) throw std::runtime_error(loader.errorString().toStdString());
    return plugin;
  }();
  return *loaded;
}

QAction *action(const std::string &filter) {
  for (QAction *each : plugin().actions())
    if (each->text().toStdString() == filter) return each;
  throw std::runtime_error("no filter " + filter);
}

RichParameterList parameters(const std::string &filter, MeshDocument &document) {
#if VBM_MESHLAB_GENERATION == 2020
  RichParameterList list;
  plugin().initParameterSet(action(filter), document, list);
  return list;
#else
  return plugin().initParameterList(action(filter), document);
#endif
}

void set(RichParameterList &list, const std::string &name, double value) {
  RichParameter &param = list.getParameterByName(QString::fromStdString(name));
#if VBM_MESHLAB_GENERATION > 2020
  const QString type = param.stringType();
  if (type == "RichBool")
    param.setValue(BoolValue(value != 0));
  else if (type == "RichEnum" || type == "RichInt")
    param.setValue(IntValue(int(value)));
  else
    param.setValue(FloatValue(Scalarm(value)));
#else
  const Value &old = param.value();
  if (old.isBool())
    param.setValue(BoolValue(value != 0));
  else if (old.isEnum())
    param.setValue(EnumValue(int(value)));
  else if (old.isInt())
    param.setValue(IntValue(int(value)));
  else if (old.isAbsPerc())
    param.setValue(AbsPercValue(Scalarm(value)));
  else
    param.setValue(FloatValue(Scalarm(value)));
#endif
}

// MeshLab's callback is a bare function: what it works on has to stand here.
Result *recording = nullptr;
std::function<bool()> watching;

bool record(const int percent, const char *stage) {
  recording->percents.push_back(percent);
  recording->stages.emplace_back(stage ? stage : "");
  return !watching || watching();
}

} // namespace

bool Result::logged(const std::string &part) const {
  for (const std::string &line : log)
    if (line.find(part) != std::string::npos) return true;
  return false;
}

std::vector<std::string> filter_names() {
  std::vector<std::string> names;
  for (QAction *each : plugin().actions()) names.push_back(each->text().toStdString());
  return names;
}

std::string help(const std::string &filter) {
  return plugin().filterInfo(action(filter)).toStdString();
}

bool generic_class(const std::string &filter) {
  return plugin().getClass(action(filter)) == Plugin::Generic;
}

int changes(const std::string &filter) { return plugin().postCondition(action(filter)); }

std::vector<std::string> dialog(const std::string &filter, MeshDocument &document) {
  std::vector<std::string> names;
  const RichParameterList list = parameters(filter, document);
  for (const RichParameter &param : list) names.push_back(param.name().toStdString());
  return names;
}

std::vector<std::string> items(const std::string &filter, const std::string &param,
                               MeshDocument &document) {
  RichParameterList list = parameters(filter, document);
  const auto &chosen =
      dynamic_cast<const RichEnum &>(list.getParameterByName(QString::fromStdString(param)));
  std::vector<std::string> names;
  for (const QString &item : chosen.enumvalues) names.push_back(item.toStdString());
  return names;
}

double whole(const std::string &filter, const std::string &param, MeshDocument &document) {
#if VBM_MESHLAB_PERCENTAGE
  using Length = RichPercentage;
#else
  using Length = RichAbsPerc;
#endif
  RichParameterList list = parameters(filter, document);
  return dynamic_cast<const Length &>(list.getParameterByName(QString::fromStdString(param))).max;
}

std::string script(const std::string &filter, MeshDocument &document) {
  QDomDocument text;
  QDomElement step = text.createElement("filter");
  step.setAttribute("name", QString::fromStdString(filter));
  const RichParameterList list = parameters(filter, document);
  for (const RichParameter &param : list) step.appendChild(param.fillToXMLDocument(text, false));
  text.appendChild(step);
  return text.toString().toStdString();
}

Result apply(const std::string &filter, MeshDocument &document, const Given &given,
             std::function<bool()> during) {
  RichParameterList list = parameters(filter, document);
  for (const auto &[name, value] : given) set(list, name, value);

  Result result;
  Result *const outer_result = recording;
  std::function<bool()> outer_watching = std::move(watching);
  recording = &result;
  watching = std::move(during);
  GLLogStream log;
  plugin().setLog(&log);
#if VBM_MESHLAB_GENERATION == 2020
  result.ok = plugin().applyFilter(action(filter), document, list, record);
  result.error = plugin().errorMsg().toStdString();
#else
  try {
    unsigned int changed = 0;
    for (const auto &[name, value] :
         plugin().applyFilter(action(filter), list, document, changed, record))
      result.measures[name] = value.toDouble();
    result.ok = true;
  } catch (const MLException &error) {
    result.error = error.what();
  }
#endif
  plugin().setLog(nullptr);
  for (const auto &line : log.logStringList()) result.log.push_back(line.second.toStdString());
  recording = outer_result;
  watching = std::move(outer_watching);
  return result;
}

int layers(MeshDocument &document) {
#if VBM_MESHLAB_GENERATION == 2020
  return document.meshList.size();
#else
  return int(document.meshNumber());
#endif
}

MeshModel *add_layer(MeshDocument &document, const char *label) {
  return document.addNewMesh(QString(), QString(label), true);
}

void remove_layer(MeshDocument &document, MeshModel *layer) {
  vbm_meshlab::delete_layer(document, layer);
}

} // namespace host
