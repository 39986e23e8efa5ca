// SPDX-License-Identifier: GPL-3.0-or-later
// What MeshLab asks of the plugin before any filter runs.
#include "../../meshlab_plugin/filters/params.h"
#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace {

bool has(const std::vector<std::string> &list, const std::string &name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

TEST(Plugin, HasItsThreeFilters) {
  EXPECT_EQ(host::filter_names(),
            (std::vector<std::string>{host::kBalls, host::kSurface, host::kThickness}));
}

TEST(Plugin, TellsWhatEachFilterIsAndDoes) {
  for (const std::string &filter : host::filter_names()) {
    EXPECT_FALSE(host::generic_class(filter)) << filter;
    const std::string help = host::help(filter);
    EXPECT_NE(help.find("See:<br>"), std::string::npos) << filter;
    EXPECT_NE(help.find("<i>N. Amenta, S. Choi, R. Kolluri</i>"), std::string::npos) << filter;
    EXPECT_NE(help.find("<i>R. Tam</i>"), std::string::npos) << filter;
  }
  // With anything else, MeshLab restores the layer to an earlier dialog's idea of it on Apply.
  EXPECT_EQ(host::changes(host::kBalls), MeshModel::MM_NONE);
  EXPECT_EQ(host::changes(host::kSurface), MeshModel::MM_NONE);
  EXPECT_EQ(host::changes(host::kThickness),
            MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTRADIUS | MeshModel::MM_VERTCOLOR);
}

// Nobody has to remember MeshLab when the library gains an option.
TEST(Plugin, ShowsEveryOptionOfTheLibrary) {
  MeshDocument document;
  shapes::sphere(document, 1);
  const auto shown = host::dialog(host::kBalls, document);
  vbm_build_options options;
  vbm_build_options_init(&options, sizeof options);
  int found = 0;
  for (const vbm_param &param : vbm::parameters()) {
    if (std::string(param.operation) != "build") continue;
    ++found;
    EXPECT_TRUE(vbm_filters::set_build_option(options, param.name, param.default_value))
        << param.name << " cannot be set";
    if (std::string(param.name).find("_limit") != std::string::npos) continue;
    EXPECT_TRUE(has(shown, param.name)) << param.name << " is not in the dialog";
  }
  EXPECT_GE(found, 6);
  EXPECT_FALSE(vbm_filters::set_build_option(options, "no such option", 0));
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
    EXPECT_GE(count, 5u);
    EXPECT_EQ(host::dialog(filter, empty).size(), count);
    EXPECT_EQ(host::dialog(filter, broken).size(), count);
    // MeshLab divides by it.
    EXPECT_EQ(host::whole(filter, "spacing", none), 1);
    EXPECT_EQ(host::whole(filter, "spacing", empty), 1);
    EXPECT_EQ(host::whole(filter, "spacing", broken), 1);
  }
}

} // namespace
