// Spheres of GGX metals and dielectrics that Cycles has the like of, rendered by both.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "renderer/image/image.h"

namespace benchmark {

/// A BRDF of which Cycles has the like.
struct Material {
  std::string name;        ///< as in reports and names of files
  std::string in_bpt;      ///< the definition of `material` in a GRF file; {} stands for alpha
  std::string in_cycles;   ///< its nodes, for reports
  double tolerance = 2;    ///< of the mean radiance, per cent
  double alike_up_to = 1;  ///< the largest roughness at which Cycles computes the same, see the README
  /// The index of refraction, where the mean in white surroundings is computed; 0: facets reflect all light.
  std::optional<double> ior = std::nullopt;
  bool is_single = true;  ///< facets scatter no light to each other
};

/// All of them.
const std::vector<Material>& materials();

/// The roughnesses of the spheres, as Cycles has them: the square roots of alpha.
inline constexpr std::array<double, 5> Roughnesses = {0.1, 0.3, 0.5, 0.7, 1.0};

/// Where a sphere is.
enum class Surroundings { Studio, White };

struct MaterialSettings {
  std::filesystem::path folder;  ///< for scenes and images
  int size = 96;                 ///< width and height of an image, pixels
  int samples = 256;             ///< per pixel
  int threads = 2;
};

/// The mean radiance of a sphere, over channels and pixels.
struct SphereMeans {
  double all = 0;     ///< out to 0.98 of the radius
  double inner = 0;   ///< out to 0.85 of it
  double centre = 0;  ///< out to half of the radius
  double middle = 0;  ///< out to 0.85 of it
  double rim = 0;     ///< out to 0.98 of it
};

/// Returns the means of an image of such a scene.
SphereMeans means_of(const image::Image& image);

/// A sphere in both renderers.
struct SphereComparison {
  std::string material;
  double roughness = 0;
  SphereMeans bpt;
  SphereMeans cycles;
  image::Image bpt_image;
  image::Image cycles_image;
};

/// Renders a sphere per roughness. Throws if a renderer fails.
std::vector<SphereComparison> compare_material(const Material& material, Surroundings surroundings,
                                               const MaterialSettings& settings);

/// How facets mask and shadow each other: as bpt has it, or as Cycles.
enum class Masking { HeightCorrelated, Separable };

/// Returns the mean radiance of a sphere in white surroundings, as `SphereMeans::inner`, of a material with
/// `ior`: by quadrature, or by a random walk over the facets if these scatter light to each other.
double mean_in_white(const Material& material, double roughness, Masking masking);

/// Returns how much more radiance bpt has than Cycles, in per cent.
double difference(double bpt, double cycles);

}  // namespace benchmark
