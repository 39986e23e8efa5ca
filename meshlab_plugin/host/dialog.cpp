// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialog.h"

#include "../filters/text.h"

#include <cmath>

#if VBM_MESHLAB_PERCENTAGE
#include <common/parameters/rich_parameters.h>
#endif

namespace vbm_meshlab {

#if VBM_MESHLAB_PERCENTAGE
using RichLength = RichPercentage; // renamed in 2023.12
#else
using RichLength = RichAbsPerc;
#endif

using vbm_filters::Kind;
using vbm_filters::Param;
using vbm_filters::Values;

namespace {

// What a length is a percentage of. Not the layer's own box alone: that of an empty layer, or of
// one with a vertex that is not finite, makes MeshLab's widget divide by nothing.
Scalarm diagonal(const MeshModel *model) {
  if (!model || model->cm.bbox.IsNull()) return 1;
  const Scalarm length = model->cm.bbox.Diag();
  return std::isfinite(length) && length > 0 ? length : Scalarm(1);
}

} // namespace

RichParameterList dialog(const std::vector<Param> &params, const MeshModel *model) {
  RichParameterList list;
  for (const Param &param : params) {
    const QString name = QString::fromStdString(param.name);
    const QString label = QString::fromStdString(param.label);
    const QString help = QString::fromStdString(param.help);
    const double value = param.default_value;
    switch (param.kind) {
    case Kind::Bool:
      list.addParam(RichBool(name, value != 0, label, help));
      break;
    case Kind::Int:
      list.addParam(RichInt(name, static_cast<int>(value), label, help));
      break;
    case Kind::Float:
      list.addParam(RichFloat(name, Scalarm(value), label, help));
      break;
    case Kind::Length:
      list.addParam(RichLength(name, Scalarm(value), Scalarm(0), diagonal(model), label, help));
      break;
    case Kind::Enum: {
      QStringList items;
      for (const std::string &item : param.items) items << QString::fromStdString(item);
      list.addParam(RichEnum(name, static_cast<int>(value), items, label, help));
      break;
    }
    }
  }
  return list;
}

Values values(const std::vector<Param> &params, const RichParameterList &given) {
  Values values;
  for (const Param &param : params) {
    const QString name = QString::fromStdString(param.name);
    if (!given.hasParameter(name)) {
      values.set(param.name, param.default_value);
      continue;
    }
    switch (param.kind) {
    case Kind::Bool:
      values.set(param.name, given.getBool(name) ? 1 : 0);
      break;
    case Kind::Int:
      values.set(param.name, given.getInt(name));
      break;
    case Kind::Float:
      values.set(param.name, vbm_filters::as_written(given.getFloat(name)));
      break;
    case Kind::Length:
      values.set(param.name, vbm_filters::as_written(given.getAbsPerc(name)));
      break;
    case Kind::Enum:
      values.set(param.name, given.getEnum(name));
      break;
    }
  }
  return values;
}

} // namespace vbm_meshlab
