#include "renderer/reflectance/layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/halton.h"

namespace reflectance {
namespace {

using Table = Transmission::Table;

/// Directions at each cosine of the quadrature: the rows of the table, and one between two of them.
constexpr std::size_t Places = 2 * Transmission::Rows - 1;
constexpr int Samples = 512;
constexpr int Azimuths = 8;  ///< of which, for BRDFs that are not isotropic
constexpr int Iterations = 40;
constexpr float LeastCosine = 1e-4F;

float cosine_at(std::size_t place) {
  const float root = static_cast<float>(place) / (Places - 1);
  return std::max(LeastCosine, root * root);
}

Rgb least(const Rgb& a, const Rgb& b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }

/// Light that a BRDF reflects from some directions at one cosine, as samples.
class ReflectedLight {
 public:
  /// Adds so many samples of the light from a direction, which counts for a part of the whole.
  void add(const Brdf& brdf, const Vec3f& u, int count, float part) {
    for (int i = 0; i < count; ++i) {
      const auto drawn = own_sample(brdf, u, halton_point(static_cast<std::uint32_t>(i)));
      if (!drawn) continue;
      samples_.push_back({drawn->weight * (part / static_cast<float>(count)), drawn->direction.z});
    }
    const Rgb mirror = specular_weight(brdf, u);
    if (!is_black(mirror)) samples_.push_back({mirror * part, u.z});
  }

  Rgb albedo() const {
    Rgb sum(0);
    for (const Sample& sample : samples_) sum += sample.weight;
    return sum;
  }
  /// Returns the albedo when each direction counts by a table.
  Rgb albedo(const Table& table) const {
    Rgb sum(0);
    for (const Sample& sample : samples_) {
      sum += sample.weight * Transmission::interpolate(table, sample.cosine);
    }
    return sum;
  }

 private:
  struct Sample {
    Rgb weight;
    float cosine = 0;
  };
  std::vector<Sample> samples_;
};

/// Computes the symmetric scaling of a base below a top.
class Scaling {
 public:
  Scaling(const Brdf& base, const Brdf& top) {
    const int azimuths = is_anisotropic(base) || is_anisotropic(top) ? Azimuths : 1;
    const Reflector above(top, OwnScheme());
    for (std::size_t place = 0; place < Places; ++place) {
      const float cosine = cosine_at(place);
      const float sine = std::sqrt((1 - cosine) * (1 + cosine));
      Rgb transmitted(1);
      for (int i = 0; i < azimuths; ++i) {
        const float azimuth = 2 * Pi * (static_cast<float>(i) + 0.25F) / static_cast<float>(azimuths);
        const Vec3f u = from_angles(cosine, sine, azimuth);
        transmitted = least(transmitted, Rgb(1) - albedo(above, u, Samples / azimuths));
        below_[place].add(base, u, Samples / azimuths, 1 / static_cast<float>(azimuths));
      }
      for (int i = 0; i < 3; ++i) transmitted[i] = std::max(0.0F, transmitted[i]);
      wanted_[place] = transmitted * below_[place].albedo();
      if (place % 2 == 0) {
        for (int i = 0; i < 3; ++i) table_[place / 2][i] = std::sqrt(transmitted[i]);
      }
    }
  }

  Table run() {
    for (int i = 0; i < Iterations; ++i) iterate();
    bound();
    return table_;
  }

 private:
  void iterate() {
    Table next = table_;
    for (std::size_t row = 0; row < Transmission::Rows; ++row) {
      const Rgb reached = table_[row] * below_[2 * row].albedo(table_);
      for (int i = 0; i < 3; ++i) {
        if (reached[i] > 0) next[row][i] *= std::sqrt(wanted_[2 * row][i] / reached[i]);
      }
    }
    table_ = next;
  }

  // Between the rows the interpolated table may be too large. At grazing, where next to nothing is
  // transmitted, it is not known well enough to tell.
  void bound() {
    constexpr float Tolerated = 1e-3F;
    constexpr float Grazing = 0.01F;
    Rgb excess(1);
    for (std::size_t place = 0; place < Places; ++place) {
      if (cosine_at(place) < Grazing) continue;
      const Rgb reached = Transmission::interpolate(table_, cosine_at(place)) * below_[place].albedo(table_);
      for (int i = 0; i < 3; ++i) {
        excess[i] = std::max(excess[i], reached[i] / (wanted_[place][i] + Tolerated));
      }
    }
    for (Rgb& row : table_) {
      for (int i = 0; i < 3; ++i) row[i] /= std::sqrt(excess[i]);
    }
  }

  std::array<ReflectedLight, Places> below_;
  std::array<Rgb, Places> wanted_ = {};  ///< the albedo of the base below the top
  Table table_ = {};
};

void add_parts(CombinedBrdfs& parts, const Brdf& brdf, const Transmission* above) {
  const auto* sum = std::get_if<Combine>(&brdf);
  CombinedBrdfs own;
  if (sum == nullptr) {
    own.push_back({1, brdf, nullptr});
  } else if (sum->parts) {
    own = *sum->parts;
  }
  for (CombinedBrdf& part : own) {
    if (above != nullptr) {
      part.transmission = std::make_shared<const Transmission>(
          part.transmission ? part.transmission->through(*above) : *above);
    }
    parts.push_back(std::move(part));
  }
}

Combine layered(const Brdf& base, const Brdf& top, const Table& table) {
  auto parts = std::make_shared<CombinedBrdfs>();
  const Transmission transmission(table);
  add_parts(*parts, top, nullptr);
  add_parts(*parts, base, &transmission);
  return Combine{std::move(parts)};
}

}  // namespace

ModelTable<Coat> Coat::table() {
  constexpr auto Logarithmic = grf::ParameterScale::Logarithmic;
  return {
      .keyword = "coat",
      .title = "Coat over a BRDF",
      .paper = "Trowbridge and Reitz 1975, Sinkhorn and Knopp 1967",
      .parameters = {number_parameter(&Coat::ior, "ior", 1, 3, "index of refraction of the coat", Logarithmic,
                                      {"nreal"}),
                     number_parameter(&Coat::alpha, "alpha", 1e-4F, 1, "roughness of the coat's surface",
                                      Logarithmic),
                     reflectance_parameter(&Coat::tint, "tint",
                                           "what the coat lets through, in and out, at normal incidence")},
      .not_isotropic = "isotropic if the base is",
      .not_reciprocal = "reciprocal if the base is",
      .not_conserving = "reflects more than it receives if the base does",
      .argument_kind = grf::ModelInfo::ArgumentKind::Layers,
      .description =
          "A dielectric layer, such as varnish, over another BRDF of the scene, which `base` names: `coat "
          "base=wood ior=1.5 alpha=0.05`. The coat's surface is that of ggx. The base gets from each "
          "direction what the coat does not reflect, so that a white base remains white, and less in the "
          "colours that `tint` lacks: at grazing the way through the coat is longer. The base's highlight "
          "does not get wider by the coat's roughness.",
      .formula = R"(
f = ggx(ior, alpha) + t(u) t(v) base
t: such that the albedo of the second part is (1 - E(u)) times that of the base; E: the albedo of ggx
t = t tint^(1/(2 c')),  c' = sqrt(1 - (1 - cu^2)/ior^2))",
  };
}

Ggx Coat::facets() const {
  Ggx facets;
  facets.alpha = facets.ay = alpha;
  facets.nreal = Rgb(ior);
  facets.prepare();
  return facets;
}

Rgb Coat::clearness(float cosine) const {
  const float inside = std::sqrt(std::max(1e-6F, 1 - (1 - cosine) * (1 + cosine) / (ior * ior)));
  Rgb clear;
  for (int i = 0; i < 3; ++i) clear[i] = std::pow(tint[i], 1 / (2 * inside));
  return clear;
}

ModelTable<Layer> Layer::table() {
  return {
      .keyword = "layer",
      .title = "BRDF over a BRDF",
      .paper = "Sinkhorn and Knopp 1967",
      .not_isotropic = "isotropic if both BRDFs are",
      .not_reciprocal = "reciprocal if both BRDFs are",
      .not_conserving = "reflects more than it receives if one of its BRDFs does",
      .argument_kind = grf::ModelInfo::ArgumentKind::Layers,
      .description =
          "One BRDF of the scene over another: `layer base=cloth top=dust`. The base gets from each "
          "direction what the top does not reflect.",
      .formula = R"(
f = top + t(u) t(v) base
t: such that the albedo of the second part is (1 - E(u)) times that of the base; E: the albedo of top)",
  };
}

Combine layered(const Brdf& base, const Brdf& top) { return layered(base, top, Scaling(base, top).run()); }

Combine layered(const Brdf& base, const Coat& coat) {
  const Brdf top = coat.facets();
  Table table = Scaling(base, top).run();
  for (std::size_t row = 0; row < table.size(); ++row)
    table[row] *= coat.clearness(Transmission::cosine(row));
  return layered(base, top, table);
}

}  // namespace reflectance
