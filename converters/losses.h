// What a scene cannot hold of a file that was read, and a file of a scene that is written: said in one
// warning a kind.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

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
  // What only GRF has, for writers.
  Brdf,
  SamplingScheme,
  Irradiance,
  AreaLight,
  Emission,
  // What some formats that are written lack.
  FaceColour,
  Normal,
  Polygon,
  LooseVertex,
  MeshName,
  Alpha,
  BadNormal,
  BadTextureCoordinates,
  Edge,
  // What OBJ files have, or lack.
  TextureOption,
  DeepTextureCoordinate,
  FlatNormal,
  Observer,
};

class Losses {
 public:
  void add(Loss loss, std::size_t count = 1) { counts_[static_cast<std::size_t>(loss)] += count; }

  std::size_t count(Loss loss) const { return counts_[static_cast<std::size_t>(loss)]; }

  /// "12 faces lost their texture: ...", a warning for each kind that occurred.
  void report(const grf::SourceLocation& location, grf::Diagnostics& diagnostics) const;

  /// The same of a file that is written in a format: what was lost, that format has not.
  void report_written(const grf::SourceLocation& location, std::string_view format,
                      grf::Diagnostics& diagnostics) const;

 private:
  std::array<std::size_t, static_cast<std::size_t>(Loss::Observer) + 1> counts_ = {};
};

}  // namespace convert
