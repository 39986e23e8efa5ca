// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_model.h"

#include <vbm/vbm.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace {

/// Relative to a ball's radius: its samples are this near to its surface.
constexpr double kOnBall = 1e-9;
/// Relative to the samples' bounding box: cospherical samples are merged into one ball within less.
constexpr double kMergedBall = 1e-10;

class ModelCheck {
public:
  explicit ModelCheck(const vbm_model *model)
      : model_(model), centers_(get<3>(vbm_model_centers)), radii_(get(vbm_model_radii)),
        samples_(get<3>(vbm_model_samples)), inner_(vbm_model_inner_count(model)) {
    std::memset(&report_, 0, sizeof report_);
    report_.struct_size = sizeof report_;
    problems_.require(vbm_model_get_report(model, &report_) == VBM_OK, "no report");
    double most = 0;
    for (const double *x = samples_.begin(); x != samples_.end(); ++x)
      most = std::max(most, std::fabs(*x));
    // Input coordinates are rounded, and centres back into the input's frame once more.
    slack_ = kMergedBall * report_.diagonal + 8 * most * 0x1p-52;
  }

  Problems run(bool brute_force) {
    sizes();
    if (!problems_.none()) return problems_;
    balls();
    neighbors();
    maps();
    medial_radii();
    if (brute_force) emptiness();
    return problems_;
  }

private:
  template <std::size_t Width = 1, class T>
  vbm::View<T, Width> get(const T *(*view)(const vbm_model *, size_t *)) const {
    vbm::View<T, Width> out;
    out.data = view(model_, &out.size);
    return out;
  }
  vbm::Lists lists(const int32_t *(*view)(const vbm_model *, const uint64_t **, size_t *)) {
    vbm::Lists out;
    out.indices.data = view(model_, &out.offsets.data, &out.indices.size);
    if (!out.offsets.data) {
      problems_.add("lists without offsets");
      return out;
    }
    out.offsets.size = radii_.size + 1;
    problems_.require(out.offsets[0] == 0, "the first list does not begin at 0");
    for (std::size_t b = 0; b < radii_.size; ++b)
      problems_.require(out.offsets[b] <= out.offsets[b + 1], "offsets go down", b);
    problems_.require(out.offsets[radii_.size] == out.indices.size, "offsets do not end at count");
    return out;
  }

  /// In long double, and hypot: neither 1e300 nor 1e-300 is too much for the square.
  static double distance(const double *a, const double *b) {
    return double(std::hypot((long double)(a[0]) - b[0], (long double)(a[1]) - b[1],
                             (long double)(a[2]) - b[2]));
  }

  void sizes() {
    problems_.require(centers_.size == radii_.size, "as many centres as radii");
    problems_.require(get(vbm_model_inside).size == radii_.size, "as many sides as radii");
    problems_.require(inner_ <= radii_.size, "more inner balls than balls");
    problems_.require(inner_ > 0, "a model without inner balls");
    problems_.require(report_.inner_balls == inner_, "report: inner_balls");
    problems_.require(report_.outer_balls == radii_.size - inner_, "report: outer_balls");
    problems_.require(report_.samples == samples_.size, "report: samples");
    problems_.require(get(vbm_model_sample_input).size == samples_.size, "one input a sample");
    problems_.require(get(vbm_model_undersampled).size == report_.undersampled,
                      "report: undersampled");
    problems_.require(report_.rule > VBM_LABELS_AUTO && report_.rule <= VBM_LABELS_SCAN,
                      "report: rule");
    problems_.require(std::isfinite(report_.diagonal) && report_.diagonal > 0, "report: diagonal");
    problems_.require(report_.cells > 0, "report: cells");
  }

  void balls() {
    const auto inside = get(vbm_model_inside);
    const vbm::Lists touched = lists(vbm_model_ball_samples);
    if (!problems_.none()) return;
    for (std::size_t b = 0; b < radii_.size; ++b) {
      problems_.require(inside[b] == (b < inner_), "the inner balls are not the first", b);
      const double *c = centers_[b], r = radii_[b];
      problems_.require(std::isfinite(c[0]) && std::isfinite(c[1]) && std::isfinite(c[2]) &&
                            std::isfinite(r) && r >= 0,
                        "a ball is not finite", b);
      const auto list = touched[b];
      problems_.require(list.size >= (b < inner_ ? 4 : 1), "a ball touches too few samples", b);
      for (std::size_t i = 0; i < list.size; ++i) {
        if (list[i] < 0 || std::size_t(list[i]) >= samples_.size) {
          problems_.add("a ball touches a sample that is not there");
          return;
        }
        problems_.require(i == 0 || list[i - 1] < list[i], "a ball's samples do not ascend", b);
        const double gap = std::fabs(distance(c, samples_[std::size_t(list[i])]) - r);
        if (!(gap <= kOnBall * r + slack_))
          problems_.add("ball " + std::to_string(b) + " of radius " + std::to_string(r) + " is " +
                        std::to_string(gap / r) + " radii off its sample " +
                        std::to_string(list[i]));
      }
    }
  }

  void neighbors() {
    const vbm::Lists near = lists(vbm_model_ball_neighbors);
    if (!problems_.none()) return;
    for (std::size_t b = 0; b < radii_.size; ++b) {
      const auto list = near[b];
      for (std::size_t i = 0; i < list.size; ++i) {
        const std::size_t other = std::size_t(list[i]);
        if (list[i] < 0 || other >= radii_.size || other == b) {
          problems_.add("a neighbour that is none");
          return;
        }
        problems_.require(i == 0 || list[i - 1] < list[i], "neighbours do not ascend", b);
        problems_.require((b < inner_) == (other < inner_), "neighbours on different sides", b);
        const auto back = near[other];
        problems_.require(std::binary_search(back.begin(), back.end(), int32_t(b)),
                          "neighbours are not symmetric", b);
      }
    }
  }

  void maps() {
    const auto input_of = get(vbm_model_sample_input), sample_of = get(vbm_model_input_sample);
    for (std::size_t s = 0; s < input_of.size; ++s) {
      if (input_of[s] < 0) continue;
      problems_.require(std::size_t(input_of[s]) < sample_of.size, "an input that is not there", s);
      if (std::size_t(input_of[s]) < sample_of.size)
        problems_.require(sample_of[std::size_t(input_of[s])] == int32_t(s),
                          "sample_input and input_sample contradict each other", s);
    }
    for (std::size_t i = 0; i < sample_of.size; ++i)
      problems_.require(sample_of[i] >= -1 && sample_of[i] < int64_t(samples_.size),
                        "a sample that is not there", i);
    const auto thin = get(vbm_model_undersampled);
    for (std::size_t i = 0; i < thin.size; ++i)
      problems_.require(thin[i] >= 0 && std::size_t(thin[i]) < samples_.size &&
                            (i == 0 || thin[i - 1] < thin[i]),
                        "undersampled samples do not ascend", i);
  }

  /// Per sample: the largest inner ball touching it is its inner polar ball.
  void medial_radii() {
    const vbm::Lists touched = lists(vbm_model_ball_samples);
    const auto sample_of = get(vbm_model_input_sample);
    std::vector<double> best[2];
    for (auto &side : best) side.assign(samples_.size, -1);
    for (std::size_t b = 0; b < radii_.size; ++b)
      for (std::size_t i = 0; i < touched[b].size; ++i) {
        double &r = best[b < inner_][std::size_t(touched[b][i])];
        r = std::max(r, radii_[b]);
      }
    for (int inside = 0; inside < 2; ++inside) {
      const auto shown = get(inside ? vbm_model_inner_radius : vbm_model_outer_radius);
      const bool per_sample = sample_of.size == 0;
      problems_.require(shown.size == (per_sample ? samples_.size : sample_of.size),
                        "as many medial radii as points");
      for (std::size_t i = 0; i < shown.size && problems_.none(); ++i) {
        const int64_t s = per_sample ? int64_t(i) : sample_of[i];
        if (s < 0 || best[inside][std::size_t(s)] < 0)
          problems_.require(std::isnan(shown[i]), "a medial radius where there is none", i);
        else if (inside || !std::isinf(shown[i]))
          problems_.require(shown[i] == best[inside][std::size_t(s)],
                            "a medial radius that is not the largest ball's", i);
      }
    }
  }

  void emptiness() {
    for (std::size_t b = 0; b < radii_.size; ++b)
      for (std::size_t s = 0; s < samples_.size; ++s)
        problems_.require(distance(centers_[b], samples_[s]) >= radii_[b] * (1 - kOnBall) - slack_,
                          "a sample inside a ball", b);
  }

  const vbm_model *model_;
  vbm::View<double, 3> centers_;
  vbm::View<double> radii_;
  vbm::View<double, 3> samples_;
  std::size_t inner_;
  vbm_model_report report_;
  double slack_ = 0;
  Problems problems_;
};

} // namespace

Problems check_model(const vbm_model *model, bool brute_force) {
  return ModelCheck(model).run(brute_force);
}
