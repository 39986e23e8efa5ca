// SPDX-License-Identifier: GPL-3.0-or-later
// The order matters: MeshLab's progress callback handles events, so that between two calls of it
// the user may edit the layer, remove it, or press Apply again. Hence: copy the layer out, compute
// on the copy, and touch the document only when no callback comes any more, after looking whether
// the layer is still the one that was copied.
#include "apply.h"

#include "mesh_copy.h"

namespace vbm_meshlab {

using vbm_filters::Failure;
using vbm_filters::NewLayer;
using vbm_filters::Outcome;
using vbm_filters::VertexValues;

namespace {

class BusyGuard {
public:
  explicit BusyGuard(bool &busy) : busy_(busy) {
    if (busy_) throw Failure("A Voronoi Balls filter is running already: wait until it is done.");
    busy_ = true;
    owner_ = true;
  }
  ~BusyGuard() {
    if (owner_) busy_ = false;
  }
  BusyGuard(const BusyGuard &) = delete;
  BusyGuard &operator=(const BusyGuard &) = delete;

private:
  bool &busy_;
  bool owner_ = false;
};

int add_layer(MeshDocument &document, const Source &source, const NewLayer &result) {
  const int current = document.mm() ? document.mm()->id() : -1;
  MeshModel *layer = document.addNewMesh(QString(), QString::fromStdString(result.name), true);
  const int id = layer->id();
  try {
    fill(*layer, result);
    layer->cm.Tr = source.matrix;
  } catch (...) {
    delete_layer(document, layer);
    if (current >= 0) document.setCurrentMesh(current);
    throw;
  }
  return id;
}

// All of them, or none.
void add_layers(MeshDocument &document, const Source &source,
                const std::vector<NewLayer> &results) {
  const int current = document.mm() ? document.mm()->id() : -1;
  std::vector<int> added;
  try {
    added.reserve(results.size());
    for (const NewLayer &result : results) added.push_back(add_layer(document, source, result));
  } catch (...) {
    for (int id : added) delete_layer(document, document.getMesh(id));
    if (current >= 0) document.setCurrentMesh(current);
    throw;
  }
  // Last, when nothing can fail any more. The layer may be gone by now.
  for (const NewLayer &result : results)
    if (result.hide_source && document.getMesh(source.id)) document.setVisible(source.id, false);
}

// Whether a layer still has the vertices that were copied out.
bool is_as_copied(const MeshModel &layer, const Source &source) {
  const auto &vertices = layer.cm.vert;
  bool same = vertices.size() == source.places;
  for (std::size_t i = 0; same && i < source.place.size(); ++i)
    same = !vertices[source.place[i]].IsD();
  return same;
}

void write_values(MeshDocument &document, const Source &source, const VertexValues &values) {
  MeshModel *layer = document.getMesh(source.id);
  if (!layer) throw Failure("The layer was removed while the filter ran: nothing was changed.");
  if (!is_as_copied(*layer, source))
    throw Failure("The layer was changed while the filter ran: nothing was written to it.");
  write(*layer, source, values);
}

// Beside new layers, which are what was asked for: where it is too late, that is no failure.
void write_selection(MeshDocument &document, const Source &source,
                     const std::vector<std::uint8_t> &selected, const Log &log) {
  MeshModel *layer = document.getMesh(source.id);
  if (layer && is_as_copied(*layer, source))
    select(*layer, source, selected);
  else
    log(false, "The layer was changed while the filter ran: nothing was selected on it.");
}

std::map<std::string, double> run(const vbm_filters::Filter &filter,
                                  const vbm_filters::Values &values, MeshDocument &document,
                                  vbm_filters::AxisStore &axes, vcg::CallBackPos *callback,
                                  const Log &log) {
  if (!document.mm()) throw Failure("There is no layer to work on: open a mesh first.");
  const Source source = copy_out(*document.mm());

  const Outcome outcome = vbm_filters::run(
      filter, source.layer, values, axes,
      [callback](int percent, const char *stage) { return !callback || callback(percent, stage); });
  add_layers(document, source, outcome.layers);
  for (const VertexValues &written : outcome.values) write_values(document, source, written);
  for (const std::string &line : outcome.log) log(false, line);
  if (!outcome.selected.empty()) write_selection(document, source, outcome.selected, log);
  return outcome.measures;
}

} // namespace

std::map<std::string, double> Applier::apply(const vbm_filters::Filter &filter,
                                             const vbm_filters::Values &values,
                                             MeshDocument &document, vcg::CallBackPos *callback,
                                             const Log &log) {
  // An exception that leaves a filter stops MeshLab, or leaves it waiting for ever. And scripts
  // only ever see the log, so every reason goes there too.
  std::string message;
  try {
    BusyGuard guard(busy_);
    return run(filter, values, document, axes_, callback, log);
  } catch (const std::bad_alloc &) {
    message = "There is not enough memory for this.";
  } catch (const std::exception &error) {
    message = error.what();
  } catch (...) {
    message = "The filter failed for an unknown reason.";
  }
  log(true, std::string(filter.name) + ": " + message);
  throw Failure(message);
}

} // namespace vbm_meshlab
