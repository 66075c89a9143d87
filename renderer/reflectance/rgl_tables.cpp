#include "renderer/reflectance/rgl_tables.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/reflectance/observer.h"

namespace reflectance {
namespace {

/// The largest entry that is kept, so that no sum or product overflows.
constexpr float LargestEntry = 1e12F;
constexpr std::size_t MostNodes = 4096;  ///< along one side of a table
constexpr double QuarterTurn = std::numbers::pi / 2;
constexpr double FullTurn = 2 * std::numbers::pi;
/// Azimuths are floats, and may have been converted from degrees.
constexpr double AzimuthTolerance = 1e-3;

float bounded_above_zero(float value) { return value > 0 ? std::min(value, LargestEntry) : 0; }
float bounded_finite(float value) {
  return std::isfinite(value) ? std::clamp(value, -LargestEntry, LargestEntry) : 0;
}

bool is_ascending(const std::vector<float>& values) {
  return std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); }) &&
         std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end();
}

/// Reads the arrays of a file, and keeps the first error.
class TableReader {
 public:
  explicit TableReader(const TensorFile& file) : file_(file) {}

  const std::string& error() const { return error_; }

  /// Finds an array of a type and rank, or returns null after an error.
  const Tensor* array(std::string_view name, ElementType type, std::size_t rank) {
    if (!error_.empty()) return nullptr;
    const Tensor* tensor = file_.find(name);
    if (tensor == nullptr) return fail(fmt::format("it has no array '{}'", name));
    if (tensor->type != type) {
      return fail(fmt::format("the elements of its array '{}' are not {}", name,
                              type == ElementType::Float32 ? "float32" : "uint8"));
    }
    if (tensor->shape.size() != rank) {
      return fail(
          fmt::format("its array '{}' has {} dimensions, expected {}", name, tensor->shape.size(), rank));
    }
    return tensor;
  }

  /// Reads an ascending list that is not empty and within bounds.
  std::vector<float> list(std::string_view name, double least, double most) {
    const Tensor* tensor = array(name, ElementType::Float32, 1);
    if (tensor == nullptr) return {};
    std::vector<float> values = tensor->floats();
    if (values.empty() || !is_ascending(values)) {
      fail(fmt::format("its array '{}' is not an ascending list of numbers", name));
    } else if (values.front() < least || values.back() > most) {
      fail(fmt::format("its array '{}' has values outside {:.4g} to {:.4g}", name, least, most));
    }
    return values;
  }

  /// Finds an array of numbers whose leading extents are given, followed by those of a grid of nodes.
  const Tensor* table(std::string_view name, const std::vector<std::size_t>& leading,
                      std::size_t least_nodes) {
    const Tensor* tensor = array(name, ElementType::Float32, leading.size() + 2);
    if (tensor == nullptr) return nullptr;
    if (!std::equal(leading.begin(), leading.end(), tensor->shape.begin())) {
      return fail(fmt::format("its array '{}' has the shape {}, which does not fit the other arrays", name,
                              fmt::join(tensor->shape, " x ")));
    }
    const NodeGrid grid = grid_of(*tensor);
    if (std::min(grid.width, grid.height) < least_nodes || std::max(grid.width, grid.height) > MostNodes) {
      return fail(fmt::format("its array '{}' has {} x {} nodes", name, grid.height, grid.width));
    }
    return tensor;
  }

  static NodeGrid grid_of(const Tensor& tensor) { return {tensor.shape.back(), tensor.shape.end()[-2]}; }

  BilinearTable bilinear(std::string_view name, float (*bounded)(float),
                         const std::vector<std::size_t>& leading, std::size_t channels) {
    const Tensor* tensor = table(name, leading, 1);
    if (tensor == nullptr) return {};
    return {grid_of(*tensor), channels, bounded_values(*tensor, bounded)};
  }

  BilinearWarp warp(std::string_view name, const std::vector<std::size_t>& leading) {
    const Tensor* tensor = table(name, leading, 2);
    if (tensor == nullptr) return {};
    return {grid_of(*tensor), bounded_values(*tensor, bounded_above_zero)};
  }

  std::nullptr_t fail(std::string what) {
    if (error_.empty()) error_ = std::move(what);
    return nullptr;
  }

 private:
  static std::vector<float> bounded_values(const Tensor& tensor, float (*bounded)(float)) {
    std::vector<float> values = tensor.floats();
    for (float& value : values) value = bounded(value);
    return values;
  }

  const TensorFile& file_;
  std::string error_;
};

/// Returns how far azimuths reach, or nothing if it is neither a full, a half nor a quarter turn.
std::optional<AzimuthRange> range_of(const std::vector<float>& azimuths) {
  if (azimuths.size() <= 2) return AzimuthRange::Isotropic;
  const double extent = double(azimuths.back()) - double(azimuths.front());
  if (std::abs(extent - FullTurn) < AzimuthTolerance) return AzimuthRange::Full;
  if (std::abs(extent - FullTurn / 2) < AzimuthTolerance) return AzimuthRange::Half;
  if (std::abs(extent - FullTurn / 4) < AzimuthTolerance) {
    const double quarters = azimuths.front() / (FullTurn / 4);
    if (std::abs(quarters - std::round(quarters)) < AzimuthTolerance) return AzimuthRange::Quarter;
  }
  return std::nullopt;
}

void read_colours(TableReader& reader, const TensorFile& file, const std::vector<std::size_t>& views,
                  RglTables& tables) {
  std::vector<std::size_t> leading = views;
  if (file.find("spectra") != nullptr) {
    tables.wavelengths = reader.list("wavelengths", 1, 1e6);
    leading.push_back(tables.wavelengths.size());
    tables.spectra = reader.bilinear("spectra", bounded_finite, leading, leading[2]);
    if (reader.error().empty()) tables.rgb = tables.spectra.mixed(rgb_weights(tables.wavelengths));
  } else if (file.find("rgb") != nullptr) {
    leading.push_back(3);
    tables.rgb = reader.bilinear("rgb", bounded_finite, leading, 3);
  } else {
    reader.fail("it has neither an array 'spectra' nor 'rgb'");
  }
}

}  // namespace

std::optional<RglTables> read_rgl_tables(const TensorFile& file, std::string& error) {
  TableReader reader(file);
  RglTables tables;
  std::vector<float> azimuths = reader.list("phi_i", -2 * FullTurn, 2 * FullTurn);
  std::vector<float> angles = reader.list("theta_i", 0, QuarterTurn + AzimuthTolerance);
  const std::vector<std::size_t> views = {azimuths.size(), angles.size()};
  if (reader.error().empty()) {
    const auto range = range_of(azimuths);
    if (!range) reader.fail("its azimuths 'phi_i' cover neither a full, a half nor a quarter turn");
    tables.range = range.value_or(AzimuthRange::Isotropic);
    tables.first_azimuth = tables.range == AzimuthRange::Isotropic
                               ? (double(azimuths.front()) + double(azimuths.back())) / 2
                               : azimuths.front();
    tables.views = SliceGrid(std::move(azimuths), std::move(angles));
  }
  tables.ndf = reader.bilinear("ndf", bounded_above_zero, {}, 1);
  tables.sigma = reader.bilinear("sigma", bounded_above_zero, {}, 1);
  tables.visible = reader.warp("vndf", views);
  tables.luminance = reader.warp("luminance", views);
  read_colours(reader, file, views, tables);
  if (const Tensor* jacobian = reader.array("jacobian", ElementType::UInt8, 1)) {
    if (jacobian->count() != 1)
      reader.fail("its array 'jacobian' is not one number");
    else
      tables.is_divided_by_ndf = jacobian->bytes.front() != 0;
  }
  if (const Tensor* description = reader.array("description", ElementType::UInt8, 1))
    tables.description = description->bytes;
  error = reader.error();
  if (!error.empty()) return std::nullopt;
  return tables;
}

}  // namespace reflectance
