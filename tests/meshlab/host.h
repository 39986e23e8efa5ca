// SPDX-License-Identifier: GPL-3.0-or-later
// MeshLab without its windows: the plugin loaded as MeshLab loads it, filters applied to a document
// as MeshLab applies them. Hides which release's interface that is.
#pragma once

#include "../../meshlab_plugin/host/meshlab.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace host {

// Parameters by name; those not named keep the dialog's default. A length is absolute.
using Given = std::map<std::string, double>;

struct Result {
  bool ok = false;
  std::string error;            // what MeshLab shows
  std::vector<std::string> log; // what it logs
  std::vector<int> percents;    // what the progress callback was called with
  std::vector<std::string> stages;
  std::map<std::string, double> measures; // what it gives to scripts; not in 2020.09
  bool logged(const std::string &part) const;
};

extern const char *const kBalls, *const kSurface, *const kThickness;
extern const char *const kAxis, *const kSimplify, *const kRemoveParts, *const kPartColor;
extern const char *const kBallSurface, *const kCluster, *const kBallMeasures, *const kAxisOfBalls;

std::vector<std::string> filter_names();
std::string help(const std::string &filter);
bool generic_class(const std::string &filter);
int changes(const std::string &filter);
// The names of the parameters in its dialog, made for this document.
std::vector<std::string> dialog(const std::string &filter, MeshDocument &document);
// Of the dialog's enumeration: its items.
std::vector<std::string> items(const std::string &filter, const std::string &param,
                               MeshDocument &document);

// Of the dialog's length: what 100 per cent of it is.
double whole(const std::string &filter, const std::string &param, MeshDocument &document);

// The filter as a step of a MeshLab script, with the dialog's defaults for this document.
std::string script(const std::string &filter, MeshDocument &document);

// `during`, if given, is called by each progress call; false cancels.
Result apply(const std::string &filter, MeshDocument &document, const Given &given = {},
             std::function<bool()> during = {});

int layers(MeshDocument &document);
MeshModel *add_layer(MeshDocument &document, const char *label);
void remove_layer(MeshDocument &document, MeshModel *layer);

} // namespace host
