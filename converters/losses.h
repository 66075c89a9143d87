// What a scene cannot hold of a file that was read, and a file of a scene that is written: said in one
// warning a kind.
#pragma once

#include <array>
#include <cstddef>

#include "grf/diagnostics.h"

namespace convert {

enum class Loss {
  Texture,
  BumpMap,
  OtherMap,
  TextureCoordinates,
  Transparency,
  PhysicallyBasedParameters,
  SmoothingGroup,
  VertexColour,
  ShortFace,
  Line,
  Point,
  // What only some formats have.
  Camera,
  LightSource,
  Animation,
  EmissionMap,
  SecondTextureCoordinates,
  SingularTransform,
  // What only GRF has, for writers.
  Brdf,
  SamplingScheme,
  Irradiance,
  AreaLight,
};

class Losses {
 public:
  void add(Loss loss, std::size_t count = 1) { counts_[static_cast<std::size_t>(loss)] += count; }

  /// "12 faces lost their texture: ...", a warning for each kind that occurred.
  void report(const grf::SourceLocation& location, grf::Diagnostics& diagnostics) const;

 private:
  std::array<std::size_t, static_cast<std::size_t>(Loss::AreaLight) + 1> counts_ = {};
};

}  // namespace convert
