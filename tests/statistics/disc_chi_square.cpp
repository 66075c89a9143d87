#include "tests/statistics/disc_chi_square.h"

#include <numeric>

#include "renderer/reflectance/schemes/rejection_tree.h"
#include "tests/statistics/chi_square.h"

namespace statistics {

using reflectance::DiscGrid;
using reflectance::Vec3f;

DiscChiSquareTest::DiscChiSquareTest(const std::function<double(const Vec3f&)>& pdf, const Vec3f& u,
                                     int resolution)
    : cosine_(1), sine_(0), resolution_(resolution), probabilities_(Blocks * Blocks) {
  const float radius = std::hypot(u.x, u.y);
  if (radius > 0) {
    cosine_ = u.x / radius;
    sine_ = u.y / radius;
  }
  const DiscGrid grid(resolution);
  for (int y = 0; y < resolution; ++y) {
    for (int x = 0; x < resolution; ++x) {
      if (!(grid.area(x, y) > 1e-12)) continue;
      const auto box = reflectance::inside_disc(DiscGrid::box({x, y, x + 1, y + 1}, resolution));
      double px = (box.x0 + box.x1) / 2;
      double py = (box.y0 + box.y1) / 2;
      const double scale = std::min(1.0, 0.99999 / std::hypot(px, py));
      px *= scale;
      py *= scale;
      const double z = std::sqrt(1 - px * px - py * py);
      const Vec3f v(static_cast<float>(cosine_ * px - sine_ * py),
                    static_cast<float>(sine_ * px + cosine_ * py), static_cast<float>(z));
      probabilities_[block_of(px, py)] += pdf(v) / v.z * grid.area(x, y);
    }
  }
  probabilities_.push_back(std::max(0.0, 1 - mass()));
}

std::size_t DiscChiSquareTest::block_of(double x, double y) const {
  const int column = DiscGrid::cell_of(x, resolution_) * Blocks / resolution_;
  const int row = DiscGrid::cell_of(y, resolution_) * Blocks / resolution_;
  return static_cast<std::size_t>(row) * Blocks + column;
}

double DiscChiSquareTest::mass() const {
  return std::accumulate(probabilities_.begin(), probabilities_.begin() + Blocks * Blocks, 0.0);
}

double DiscChiSquareTest::p_value(const Sampler& sampler, int samples) const {
  std::vector<double> expectation = probabilities_;
  for (double& block : expectation) block *= samples;
  std::vector<double> counts(expectation.size(), 0.0);
  for (int i = 0; i < samples; ++i) {
    const std::optional<Vec3f> v = sampler();
    const std::size_t block =
        v ? block_of(cosine_ * v->x + sine_ * v->y, cosine_ * v->y - sine_ * v->x) : counts.size() - 1;
    counts[block] += 1;
  }
  return chi_square_p_value(expectation, counts);
}

}  // namespace statistics
