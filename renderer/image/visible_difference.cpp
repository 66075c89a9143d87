#include "renderer/image/visible_difference.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "grf/cie_colour.h"
#include "renderer/parallel/loops.h"

namespace image {
namespace {

using grf::Vec3d;

/// A channel of an image.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values;

  Plane(int columns, int rows)
      : width(columns),
        height(rows),
        values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}
  float* row(int y) { return &values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)]; }
  const float* row(int y) const {
    return &values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)];
  }
};

/// A Gaussian's weights from its middle outwards.
std::vector<float> weights_of(double deviation) {
  std::vector<float> weights = {1};
  const int radius = static_cast<int>(std::ceil(3.5 * deviation));
  for (int i = 1; i <= radius; ++i)
    weights.push_back(static_cast<float>(std::exp(-i * i / (2 * deviation * deviation))));
  return weights;
}

/// Returns per position the sum of a Gaussian's weights that are inside.
std::vector<float> inside_weights(const std::vector<float>& weights, int count) {
  std::vector<float> sums(static_cast<std::size_t>(count));
  const int radius = static_cast<int>(weights.size()) - 1;
  for (int x = 0; x < count; ++x) {
    for (int i = std::max(-radius, -x); i <= std::min(radius, count - 1 - x); ++i) {
      sums[static_cast<std::size_t>(x)] += weights[static_cast<std::size_t>(std::abs(i))];
    }
  }
  return sums;
}

void blur_row(const float* from, int width, const std::vector<float>& weights, const std::vector<float>& sums,
              float* to) {
  std::fill(to, to + width, 0.0F);
  const int radius = std::min(static_cast<int>(weights.size()) - 1, width - 1);
  for (int i = -radius; i <= radius; ++i) {
    const float weight = weights[static_cast<std::size_t>(std::abs(i))];
    const int end = std::min(width, width - i);
    for (int x = std::max(0, -i); x < end; ++x) to[x] += weight * from[x + i];
  }
  for (int x = 0; x < width; ++x) to[x] /= sums[static_cast<std::size_t>(x)];
}

void blur_column_into_row(const Plane& from, int y, const std::vector<float>& weights, float sum, float* to) {
  std::fill(to, to + from.width, 0.0F);
  const int radius = static_cast<int>(weights.size()) - 1;
  for (int i = std::max(-radius, -y); i <= std::min(radius, from.height - 1 - y); ++i) {
    const float weight = weights[static_cast<std::size_t>(std::abs(i))] / sum;
    const float* row = from.row(y + i);
    for (int x = 0; x < from.width; ++x) to[x] += weight * row[x];
  }
}

/// Filters by a Gaussian with this standard deviation in pixels.
Plane blurred_exactly(const Plane& plane, double deviation) {
  if (deviation < 0.05) return plane;
  const std::vector<float> weights = weights_of(deviation);
  const std::vector<float> across = inside_weights(weights, plane.width);
  const std::vector<float> down = inside_weights(weights, plane.height);
  Plane rows(plane.width, plane.height);
  parallel::for_each_index(plane.height,
                           [&](int y) { blur_row(plane.row(y), plane.width, weights, across, rows.row(y)); });
  Plane result(plane.width, plane.height);
  parallel::for_each_index(plane.height, [&](int y) {
    blur_column_into_row(rows, y, weights, down[static_cast<std::size_t>(y)], result.row(y));
  });
  return result;
}

/// The means of blocks of pixels; those at the right and lower edge are of the pixels that are there.
Plane reduced(const Plane& plane, int block) {
  Plane result((plane.width + block - 1) / block, (plane.height + block - 1) / block);
  parallel::for_each_index(result.height, [&](int y) {
    for (int x = 0; x < result.width; ++x) {
      const int right = std::min(plane.width, (x + 1) * block);
      const int bottom = std::min(plane.height, (y + 1) * block);
      double sum = 0;
      for (int j = y * block; j < bottom; ++j) {
        for (int i = x * block; i < right; ++i) sum += double(plane.row(j)[i]);
      }
      result.row(y)[x] = static_cast<float>(sum / ((right - x * block) * (bottom - y * block)));
    }
  });
  return result;
}

/// Interpolates linearly between the middles of blocks.
Plane enlarged(const Plane& plane, int block, int width, int height) {
  Plane result(width, height);
  const auto place = [block](int x, int count) {
    const double middle = std::clamp((x + 0.5) / block - 0.5, 0.0, count - 1.0);
    const int index = std::min(static_cast<int>(middle), std::max(0, count - 2));
    return std::pair(index, static_cast<float>(middle - index));
  };
  parallel::for_each_index(height, [&](int y) {
    const auto [j, v] = place(y, plane.height);
    const float* upper = plane.row(j);
    const float* lower = plane.row(std::min(j + 1, plane.height - 1));
    for (int x = 0; x < width; ++x) {
      const auto [i, u] = place(x, plane.width);
      const int next = std::min(i + 1, plane.width - 1);
      result.row(y)[x] =
          (1 - v) * ((1 - u) * upper[i] + u * upper[next]) + v * ((1 - u) * lower[i] + u * lower[next]);
    }
  });
  return result;
}

/// Filters by a Gaussian; a wide one at lower resolution. Blocks and the interpolation between them widen it:
/// by (n^2 - 1) / 12 and n^2 / 6 of variance.
Plane blurred(const Plane& plane, double deviation) {
  constexpr double FineDeviation = 3;
  const int block = std::max(1, static_cast<int>(deviation / FineDeviation));
  if (block == 1) return blurred_exactly(plane, deviation);
  const double squared_block = static_cast<double>(block) * block;
  const double variance = deviation * deviation - (squared_block - 1) / 12 - squared_block / 6;
  const Plane coarse = blurred_exactly(reduced(plane, block), std::sqrt(variance) / block);
  return enlarged(coarse, block, plane.width, plane.height);
}

Plane filtered(const Plane& plane, const OpponentFilter& filter, double pixels_per_degree) {
  Plane result(plane.width, plane.height);
  double sum = 0;
  for (const auto& gaussian : filter.gaussians) sum += gaussian.weight;
  for (const auto& gaussian : filter.gaussians) {
    const Plane part = blurred(plane, gaussian.spread * pixels_per_degree / std::sqrt(2.0));
    const auto weight = static_cast<float>(gaussian.weight / sum);
    for (std::size_t i = 0; i < part.values.size(); ++i) result.values[i] += weight * part.values[i];
  }
  return result;
}

/// The opponent colours of Poirson and Wandell (1993), as in S-CIELAB.
const Imath::M33d& xyz_to_opponent() {
  // Imath multiplies row vectors: the rows here are those of X, Y and Z.
  static const Imath::M33d matrix(0.279, -0.449, 0.086, 0.720, 0.290, -0.590, -0.107, -0.077, 0.501);
  return matrix;
}

Vec3d on_screen(const grf::Colour& pixel, double factor) {
  const auto clipped = [factor](float value) {
    const double exposed = double(value) * factor;
    return exposed > 0 ? std::min(exposed, 1.0) : 0.0;  // NaN is black
  };
  return grf::xyz_of_srgb({clipped(pixel.x), clipped(pixel.y), clipped(pixel.z)});
}

}  // namespace

const std::vector<OpponentFilter>& opponent_filters() {
  static const std::vector<OpponentFilter> filters = {{{{0.921, 0.0283}, {0.105, 0.133}, {-0.108, 4.336}}},
                                                      {{{0.531, 0.0392}, {0.330, 0.494}}},
                                                      {{{0.488, 0.0536}, {0.371, 0.386}}}};
  return filters;
}

Vec3d opponent_of(const Vec3d& xyz) { return xyz * xyz_to_opponent(); }

SeenImage seen(const Image& image, const Viewing& viewing) {
  std::vector<Plane> planes(3, Plane(image.width, image.height));
  const double factor = std::exp2(viewing.exposure);
  parallel::for_each_index(image.height, [&](int y) {
    for (int x = 0; x < image.width; ++x) {
      const Vec3d opponent = opponent_of(on_screen(image.at(x, y), factor));
      for (int channel = 0; channel < 3; ++channel) {
        planes[static_cast<std::size_t>(channel)].row(y)[x] = static_cast<float>(opponent[channel]);
      }
    }
  });
  for (std::size_t i = 0; i < planes.size(); ++i) {
    planes[i] = filtered(planes[i], opponent_filters()[i], viewing.pixels_per_degree);
  }
  const Imath::M33d back = xyz_to_opponent().inverse();
  const Vec3d white = grf::xyz_of_srgb(Vec3d(1));
  SeenImage result(image.pixels.size());
  parallel::for_each_index(result.size(), [&](std::size_t i) {
    const Vec3d opponent(planes[0].values[i], planes[1].values[i], planes[2].values[i]);
    result[i] = lab_of(opponent * back, white);
  });
  return result;
}

std::vector<float> visible_differences(const SeenImage& image, const SeenImage& reference) {
  assert(image.size() == reference.size());
  std::vector<float> differences(image.size());
  parallel::for_each_index(image.size(), [&](std::size_t i) {
    differences[i] = static_cast<float>(ciede2000(image[i], reference[i]));
  });
  return differences;
}

VisibleDifference summary_of(std::vector<float> differences) {
  VisibleDifference summary;
  for (const float difference : differences) summary.mean += double(difference);
  const auto count = static_cast<double>(differences.size());
  summary.mean /= count;
  const auto place = static_cast<std::ptrdiff_t>(std::ceil(0.95 * count) - 1);
  std::nth_element(differences.begin(), differences.begin() + place, differences.end());
  summary.percentile_95 = double(differences[static_cast<std::size_t>(place)]);
  return summary;
}

}  // namespace image
