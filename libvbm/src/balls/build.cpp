// SPDX-License-Identifier: GPL-3.0-or-later
#include "balls/build.h"

#include "balls/circumcenter.h"
#include "balls/delaunay.h"
#include "balls/describe.h"
#include "balls/labels.h"
#include "balls/merge.h"
#include "balls/poles.h"
#include "balls/refine.h"
#include "balls/reorder.h"
#include "balls/repair.h"
#include "balls/undersampling.h"
#include "core/error.h"
#include "core/tolerances.h"

#include <algorithm>
#include <optional>

namespace vbm::impl {

namespace {

uint64_t cell_limit(const vbm_build_options &options, std::size_t samples) {
  return options.cell_limit ? options.cell_limit : 1000000 + 40 * uint64_t(samples);
}

void turn_normals(Samples &samples) {
  for (Vec3 &n : samples.normal) n = -n;
  samples.flipped = samples.normals_turned = true;
  samples.notes.push_back("all normals point inward; they were taken the other way round");
}

void label_cells(Round &round, Progress &progress) {
  std::vector<float> confidence(round.cells.size());
  round.inside.resize(round.cells.size());
  for (std::size_t c = 0; c < round.cells.size(); ++c) {
    progress.tick(1, 1);
    round.inside[c] = round.labels.inside[round.balls.of_cell[c]];
    confidence[c] = round.labels.confidence[round.balls.of_cell[c]];
  }
  repair_labels(round.cells, confidence, round.inside, progress);
}

} // namespace

Model build_model(Samples samples, const vbm_build_options &options, Progress &progress) {
  Model model;
  check_three_dimensional(samples.position, samples.input_points);
  if (samples.frame.exponent > kMaxExponent)
    throw Error(VBM_ERROR_INPUT, "the input's coordinates are too large: within 1e300, outer balls "
                                 "are numbers, beyond they may not be");

  progress.stage("Delaunay triangulation", 0.5);
  const std::vector<int32_t> order = spatial_order(samples.position, progress);
  reorder(samples, order, progress);
  std::optional<Delaunay> delaunay(std::in_place);
  delaunay->insert(samples.position, cell_limit(options, samples.position.size()), progress);

  Round round, best;
  int stuck = 0; // rounds since the last one that was better than all before
  for (int number = 0;; ++number) {
    progress.stage("balls", number ? 0.85 : 0.6);
    round.cells = delaunay->cells(progress);
    const bool more = options.refine && samples.refiner && number < kMaxRefineRounds;
    if (!more) delaunay.reset();
    Circumballs circumballs = circumscribe(round.cells, samples.position, progress);
    round.exact_centers = circumballs.exact;
    round.balls =
        merge_cospherical(round.cells, samples.position, std::move(circumballs), progress);

    progress.stage("inside and outside", number ? 0.87 : 0.8);
    round.labels = label_balls(samples, round.cells, round.balls, progress);
    if (round.labels.turned) turn_normals(samples);
    label_cells(round, progress);
    round.samples = samples.position.size();
    if (samples.refiner) round.faults = count_faults(samples, round, progress);
    const bool better = number == 0 || round.faults < best.faults;
    const bool added = more && round.faults != 0 &&
                       refine(samples, *delaunay, round, options.sample_limit, progress);
    const std::size_t count = round.samples;
    if (better) best = std::move(round);
    stuck = better ? 0 : stuck + 1;
    if (!added || stuck == kMaxStuckRounds) break;
    round.fresh = count;
  }
  delaunay.reset();
  remove_samples_from(samples, best.samples);
  const BallSet &balls = best.balls;
  model.cells = std::move(best.cells);
  model.inside = std::move(best.inside);
  model.report.exact_centers = best.exact_centers;
  model.wrong_topology = best.faults >= kWrongTopology;
  if (std::find(model.inside.begin(), model.inside.end(), 1) == model.inside.end())
    throw Error(VBM_ERROR_NO_INTERIOR,
                "no interior: the " + std::to_string(samples.position.size()) +
                    " samples enclose no space that can be told from the outside (an open, "
                    "one-sided or much too thinly sampled surface)");

  progress.stage("polar balls", 0.96);
  model.samples = std::move(samples);
  collect_balls(model, balls, vbm_balls(options.balls), progress);
  find_neighbors(model, progress);
  progress.stage("sampling check", 0.99);
  find_undersampled(model, options.undersampling, progress);
  restore_order(model, order, progress);
  describe(model, progress);
  return model;
}

} // namespace vbm::impl
