// SPDX-License-Identifier: GPL-3.0-or-later
// Build Surface from Balls: a layer with the surface of any balls.
#include "ball_layer.h"
#include "filter.h"
#include "model.h"
#include "options.h"
#include "surface_layer.h"
#include "text.h"

namespace vbm_filters {
namespace {

std::vector<Param> params() {
  std::vector<Param> params = library_params("surface_from_balls");
  params.push_back(bool_param("polygons", "Keep Polygons",
                              "Keep the surface's polygons, instead of cutting them into triangles",
                              false));
  params.push_back(hide_param());
  return params;
}

Outcome run(const Task &task) {
  const auto &[layer, values, progress, axes] = task;
  const Balls balls = balls_of(layer);
  vbm::BallSurfaceOptions options;
  set_options(options, "surface_from_balls", values);
  vbm::Context context;
  progress.stage(context, 0, 99);
  const vbm::Surface surface =
      vbm::surface_from_balls(context, balls.centers, balls.radii, options);

  // No vertex of the surface is one of the layer's: faces have the colour of their ball.
  NewLayer made = surface_layer(surface, layer.name + " surface", {}, values.flag("polygons"));
  if (!layer.colors.empty()) {
    const auto polygon = surface.triangle_polygon();
    const auto ball = surface.polygon_ball();
    for (std::int32_t p : polygon)
      made.triangle_colors.push_back(ball[p] < 0 ? Color() : layer.colors[ball[p]]);
  }
  made.hide_source = values.flag("hide");

  Outcome outcome;
  outcome.log.push_back("Took " + count(balls.radii.size, "ball", "balls") + ".");
  describe(surface, outcome.log);
  outcome.layers.push_back(std::move(made));
  return outcome;
}

} // namespace

const Filter ball_surface_filter = {
    "Voronoi Balls: Build Surface from Balls",
    "generate_surface_from_balls",
    "Makes a <b>closed surface</b> of a layer's balls, wherever they come from: a ball model, a "
    "file, a molecule, spheres placed by hand. Every vertex is a ball, by its <b>radius</b>. The "
    "surface has about as many faces as there are balls, and the components, tunnels and cavities "
    "of their union. Other styles are the smooth <b>skin</b> round the balls and the <b>power "
    "crust</b> of the points where three balls meet. Faces have the colour of their ball, where "
    "balls have one.<br><br>"
    "See:<br>"
    "<i>R. Tam</i>, <b>\"Voronoi Ball Models for Computational Shape Applications\"</b>, PhD "
    "thesis, section 8.3<br>"
    "<i>H. Edelsbrunner</i>, <b>\"The union of balls and its dual shape\"</b>, Discrete and "
    "Computational Geometry 13, 1995; <b>\"Deformable smooth surface design\"</b>, Discrete and "
    "Computational Geometry 21, 1999",
    kRemeshing | kPointSet,
    kNothing,
    params,
    run,
};

} // namespace vbm_filters
