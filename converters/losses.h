// Losses of a conversion: features that GRF cannot represent on import, or a format on export, reported in
// one warning per kind.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "grf/diagnostics.h"

namespace convert {

/// What a conversion can lose, one kind for each warning.
enum class Loss {
  Texture,
  BumpMap,
  OtherMap,
  TextureCoordinates,
  Transparency,
  SmoothingGroup,
  VertexColour,
  DegenerateFace,
  Line,
  Point,
  // Features that only some formats have.
  Camera,
  LightSource,
  PunctualLight,
  SpotCone,
  Animation,
  EmissionMap,
  Transmission,
  SecondTextureCoordinates,
  SingularTransform,
  TextureImage,
  TextureWrap,
  NormalMap,
  OcclusionMap,
  Unlit,
  BackEmission,
  VertexValues,
  UnplacedMesh,
  Skin,
  MorphTarget,
  NumberedColour,
  SecondColour,
  EmbeddedFile,
  Subdivision,
  // Features that only GRF has, for writers.
  Brdf,
  ParameterMap,
  SamplingScheme,
  Irradiance,
  AreaLight,
  Emission,
  Opacity,
  Cutoff,
  // Features that some written formats lack.
  FaceColour,
  Normal,
  Polygon,
  LooseVertex,
  MeshName,
  Alpha,
  BadNormal,
  BadTextureCoordinates,
  Edge,
  // Features that OBJ files have, or lack.
  TextureOption,
  DeepTextureCoordinate,
  FlatNormal,
  Observer,
  // Features that scenes of renderers lack.
  BrdfFormula,
  BrdfTexture,
  BrdfVertexColour,
  MirrorFresnel,
  GlassColour,
  EmitterNormal,
  Backplate,
  // Features that files of USD and MaterialX lack.
  BrdfNearest,
  EmissionOfOneSide,
  Geometry,
};

/// Counts what a conversion loses.
class Losses {
 public:
  /// Counts more losses of one kind.
  void add(Loss loss, std::size_t count = 1) { counts_[static_cast<std::size_t>(loss)] += count; }

  /// Returns the number of losses of one kind.
  std::size_t count(Loss loss) const { return counts_[static_cast<std::size_t>(loss)]; }

  /// Reports losses on import, one warning per kind: "12 faces lost their texture: ...".
  void report(const grf::SourceLocation& location, grf::Diagnostics& diagnostics) const;

  /// Reports losses on export: the reason is that the format does not have the feature.
  void report_written(const grf::SourceLocation& location, std::string_view format,
                      grf::Diagnostics& diagnostics) const;

 private:
  std::array<std::size_t, static_cast<std::size_t>(Loss::Geometry) + 1> counts_ = {};
};

}  // namespace convert
