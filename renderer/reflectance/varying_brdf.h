// Images vary parameters of a BRDF over a surface: their texels at a point make the BRDF there.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "grf/model.h"
#include "renderer/reflectance/brdf.h"

namespace reflectance {

/// A BRDF of which images vary parameters.
class VaryingBrdf {
 public:
  /// An image of a parameter.
  struct Map {
    std::string path;  ///< see grf::map_path
    grf::ImageChannel channel = grf::ImageChannel::Red;
    grf::SourceLocation location;
  };

  /// The model must be one that `grf::check` found valid, without data or parts.
  explicit VaryingBrdf(const grf::Model& model);

  const std::vector<Map>& maps() const { return maps_; }  ///< Returns the images, each once.

  /// Returns the BRDF at a point, given a texel per map; a single channel is in all three components. Values
  /// out of a parameter's range become its nearest end.
  Brdf at(std::span<const Rgb> texels) const;

  // These queries tell what the BRDF may have at some point; it is rather assumed than missed.
  bool may_be_specular() const { return may_be_specular_; }
  bool may_be_anisotropic() const { return may_be_anisotropic_; }
  bool is_diffuse() const { return std::holds_alternative<Diffuse>(brdf_); }  ///< everywhere

 private:
  /// A parameter that the image of this number varies.
  struct Varied {
    std::size_t map = 0;
    Rgb factor = Rgb(1);
    float minimum = 0;
    float maximum = 1;
    std::function<void(Brdf& brdf, const Rgb& value)> set;
  };
  template <class Model>
  void find_varied(const grf::Model& data);

  Brdf brdf_;
  std::vector<Map> maps_;
  std::vector<Varied> varied_;
  bool may_be_specular_ = false;
  bool may_be_anisotropic_ = false;
};

}  // namespace reflectance
