// SPDX-License-Identifier: GPL-3.0-or-later
// What MeshLab asks of the plugin before any filter runs.
#include "../../meshlab_plugin/filters/options.h"
#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace {

bool has(const std::vector<std::string> &list, const std::string &name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

TEST(Plugin, HasItsFilters) {
  EXPECT_EQ(host::filter_names(),
            (std::vector<std::string>{host::kBalls, host::kSurface, host::kThickness, host::kAxis,
                                      host::kSimplify, host::kRemoveParts, host::kPartColor,
                                      host::kBallSurface, host::kCluster, host::kBallMeasures,
                                      host::kAxisOfBalls}));
}

TEST(Plugin, TellsWhatEachFilterIsAndDoes) {
  for (const std::string &filter : host::filter_names()) {
    EXPECT_FALSE(host::generic_class(filter)) << filter;
    const std::string help = host::help(filter);
    EXPECT_NE(help.find("See:<br>"), std::string::npos) << filter;
    EXPECT_NE(help.find("<i>", help.find("See:")), std::string::npos) << filter;
    EXPECT_NE(help.find("<i>R. Tam</i>"), std::string::npos) << filter;
  }
  // With anything else, MeshLab restores the layer to an earlier dialog's idea of it on Apply.
  for (const char *filter :
       {host::kBalls, host::kSurface, host::kAxis, host::kSimplify, host::kRemoveParts,
        host::kBallSurface, host::kCluster, host::kAxisOfBalls})
    EXPECT_EQ(host::changes(filter), MeshModel::MM_NONE) << filter;
  EXPECT_EQ(host::changes(host::kBallMeasures), MeshModel::MM_VERTQUALITY);
  EXPECT_EQ(host::changes(host::kPartColor), MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR);
  EXPECT_EQ(host::changes(host::kThickness),
            MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTRADIUS | MeshModel::MM_VERTCOLOR);
}

// Nobody has to remember MeshLab when the library gains an option.
TEST(Plugin, ShowsEveryOptionOfTheLibrary) {
  MeshDocument document;
  shapes::sphere(document, 1);
  const auto expect_all = [&](const char *operation, const char *filter, auto options,
                              std::size_t least) {
    const auto shown = host::dialog(filter, document);
    std::size_t found = 0;
    for (const vbm_param &param : vbm::parameters()) {
      if (std::string(param.operation) != operation) continue;
      ++found;
      EXPECT_TRUE(vbm_filters::set_option(options, param.name, param.default_value))
          << param.name << " cannot be set";
      EXPECT_TRUE(has(shown, param.name)) << param.name << " is not in the dialog of " << filter;
    }
    EXPECT_GE(found, least);
    EXPECT_FALSE(vbm_filters::set_option(options, "no such option", 0));
  };
  expect_all("build", host::kBalls, vbm::BuildOptions(), 6);
  for (const char *filter : {host::kAxis, host::kSimplify, host::kPartColor, host::kAxisOfBalls})
    expect_all("medial_axis", filter, vbm::AxisOptions(), 2);
  for (const char *filter : {host::kSimplify, host::kPartColor})
    expect_all("prune", filter, vbm::PruneOptions(), 3);
  for (const char *filter : {host::kSimplify, host::kRemoveParts})
    expect_all("axis_surface", filter, vbm::AxisSurfaceOptions(), 1);
  expect_all("surface_from_balls", host::kBallSurface, vbm::BallSurfaceOptions(), 4);
  expect_all("cluster", host::kCluster, vbm::ClusterOptions(), 3);
  expect_all("simplify_axis", host::kAxisOfBalls, vbm::SimplifyOptions(), 2);
}

TEST(Plugin, OffersOnlyLabelsThatAMeshCanHave) {
  MeshDocument document;
  shapes::sphere(document, 1);
  EXPECT_EQ(host::items(host::kBalls, "labels", document).size(), 3u);
  EXPECT_EQ(host::items(host::kSurface, "method", document),
            (std::vector<std::string>{"Interpolating", "Power Crust"}));
}

TEST(Plugin, MakesItsDialogsForAnyDocument) {
  MeshDocument none;
  MeshDocument empty;
  host::add_layer(empty, "empty");
  MeshDocument broken;
  MeshModel *layer = shapes::sphere(broken, 1);
  layer->cm.bbox.max[0] = std::numeric_limits<Scalarm>::quiet_NaN();
  for (const std::string &filter : host::filter_names()) {
    const std::size_t count = host::dialog(filter, none).size();
    EXPECT_GE(count, 1u);
    EXPECT_EQ(host::dialog(filter, empty).size(), count);
    EXPECT_EQ(host::dialog(filter, broken).size(), count);
    if (!has(host::dialog(filter, none), "spacing")) continue;
    // MeshLab divides by it.
    EXPECT_EQ(host::whole(filter, "spacing", none), 1);
    EXPECT_EQ(host::whole(filter, "spacing", empty), 1);
    EXPECT_EQ(host::whole(filter, "spacing", broken), 1);
  }
}

} // namespace
