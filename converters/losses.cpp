#include "converters/losses.h"

#include <string_view>

#include <fmt/format.h>

#include "converters/wording.h"

namespace convert {
namespace {

struct LossText {
  std::string_view one;   ///< text after a count of one
  std::string_view many;  ///< text after any other count
  std::string_view why;
};

LossText text_of(Loss loss) {
  switch (loss) {
    case Loss::Texture:
      return {"face lost its texture", "faces lost their texture", "the format has none"};
    case Loss::BumpMap:
      return {"face lost its bump map", "faces lost their bump map", "GRF has none"};
    case Loss::OtherMap:
      return {"face lost its map of a parameter other than the diffuse colour",
              "faces lost their map of a parameter other than the diffuse colour",
              "GRF has no such parameter, or not by a factor and the same texture coordinates"};
    case Loss::ParameterMap:
      return {"face lost the images that vary its BRDF", "faces lost the images that vary their BRDF",
              "the format has a number for the face, which is that without the image"};
    case Loss::TextureCoordinates:
      return {"face lost its texture coordinates", "faces lost their texture coordinates",
              "the format has none"};
    case Loss::Transparency:
      return {"face lost its transparency", "faces lost their transparency", "it is read as opaque"};
    case Loss::SmoothingGroup:
      return {"face lost its smoothing group", "faces lost their smoothing group",
              "the file has no normals, so that faces are flat"};
    case Loss::VertexColour:
      return {"vertex lost its colour", "vertices lost their colour", "other vertices of the file have none"};
    case Loss::DegenerateFace:
      return {"face was left out", "faces were left out", "fewer than three corners"};
    case Loss::Line:
      return {"line was left out", "lines were left out", "GRF has only faces"};
    case Loss::Point:
      return {"point was left out", "points were left out", "GRF has only faces"};
    case Loss::Camera:
      return {"camera was left out", "cameras were left out", "a view is given when a scene is rendered"};
    case Loss::LightSource:
      return {"light was left out", "lights were left out", "GRF has only area lights"};
    case Loss::PunctualLight:
      return {"light became a small mesh that emits", "lights became small meshes that emit",
              "GRF has only area lights"};
    case Loss::SpotCone:
      return {"spot light lost its cone", "spot lights lost their cones",
              "faces of GRF emit to their whole front"};
    case Loss::Animation:
      return {"animation was left out", "animations were left out", "GRF scenes are static"};
    case Loss::Transmission:
      return {"face lost some of how glass transmits", "faces lost some of how glass transmits",
              "glass of GRF is clear, smooth, and tinted as a whole"};
    case Loss::EmissionMap:
      return {"face lost its map of emission", "faces lost their map of emission",
              "faces of GRF emit uniformly"};
    case Loss::SecondTextureCoordinates:
      return {"face lost its additional sets of texture coordinates",
              "faces lost their additional sets of texture coordinates", "GRF has one"};
    case Loss::SingularTransform:
      return {"mesh was left out", "meshes were left out", "its transform is singular"};
    case Loss::TextureImage:
      return {"face lost its texture", "faces lost their texture",
              "the file has no image for it that can be read"};
    case Loss::TextureWrap:
      return {"face lost the wrap mode of its texture", "faces lost the wrap mode of their texture",
              "textures of GRF repeat"};
    case Loss::NormalMap:
      return {"face lost its normal map", "faces lost their normal map", "GRF has none"};
    case Loss::OcclusionMap:
      return {"face lost its occlusion map", "faces lost their occlusion map",
              "occlusion is rendered, not textured"};
    case Loss::Unlit:
      return {"face lost its unlit shading", "faces lost their unlit shading",
              "it is diffuse, since GRF has no unlit surfaces"};
    case Loss::BackEmission:
      return {"face lost the emission of its back", "faces lost the emission of their back",
              "faces of GRF emit only from the front"};
    case Loss::VertexValues:
      return {"vertex lost attributes of an application", "vertices lost attributes of an application",
              "GRF has none"};
    case Loss::UnplacedMesh:
      return {"mesh was left out", "meshes were left out", "no node of the file uses it"};
    case Loss::Skin:
      return {"face lost its bones", "faces lost their bones",
              "GRF scenes are static: the bind pose is kept"};
    case Loss::MorphTarget:
      return {"face lost its morph targets", "faces lost their morph targets",
              "GRF scenes are static: the base shape is kept"};
    case Loss::NumberedColour:
      return {"face lost its colour", "faces lost their colour",
              "the file has an index into a colour table, and no table"};
    case Loss::SecondColour:
      return {"face lost its additional sets of vertex colours",
              "faces lost their additional sets of vertex colours", "GRF has one"};
    case Loss::EmbeddedFile:
      return {"embedded image was left out", "embedded images were left out",
              "no material uses it as its diffuse map"};
    case Loss::Subdivision:
      return {"object lost its subdivision", "objects lost their subdivision",
              "the faces are those that the file has, which are coarser"};
    case Loss::Brdf:
      return {"face lost its BRDF", "faces lost their BRDF", "the format has none"};
    case Loss::SamplingScheme:
      return {"face lost its sampling scheme", "faces lost their sampling scheme", "the format has none"};
    case Loss::Irradiance:
      return {"vertex lost its irradiance", "vertices lost their irradiance", "the format has none"};
    case Loss::AreaLight:
      return {"light was left out", "lights were left out", "the format has none with an area"};
    case Loss::Emission:
      return {"face lost its emission", "faces lost their emission", "the format has none"};
    case Loss::Opacity:
      return {"face lost its opacity", "faces lost their opacity", "the format has none"};
    case Loss::Cutoff:
      return {"face lost the cutoff of its opacity", "faces lost the cutoff of their opacity",
              "the format has none"};
    case Loss::FaceColour:
      return {"face lost its colour", "faces lost their colour", "the format has none"};
    case Loss::Normal:
      return {"vertex lost its normal", "vertices lost their normal", "the format has none"};
    case Loss::Polygon:
      return {"polygon was cut into triangles", "polygons were cut into triangles", "the format has none"};
    case Loss::LooseVertex:
      return {"vertex without a face was left out", "vertices without a face were left out",
              "the format has only faces"};
    case Loss::MeshName:
      return {"mesh lost its name", "meshes lost their name", "the format has none"};
    case Loss::Alpha:
      return {"vertex or face lost its alpha", "vertices or faces lost their alpha",
              "opacity in GRF is of faces, or of textures"};
    case Loss::BadNormal:
      return {"vertex lost its normal", "vertices lost their normal", "it has no direction"};
    case Loss::BadTextureCoordinates:
      return {"vertex lost its texture coordinates", "vertices lost their texture coordinates",
              "they are not finite"};
    case Loss::Edge:
      return {"edge was left out", "edges were left out", "GRF has only faces"};
    case Loss::TextureOption:
      return {"face lost an option of its texture (-clamp, -mm and so on)",
              "faces lost an option of their texture (-clamp, -mm and so on)",
              "GRF has only scale and offset"};
    case Loss::DeepTextureCoordinate:
      return {"texture coordinate lost its third number", "texture coordinates lost their third number",
              "textures are two-dimensional"};
    case Loss::FlatNormal:
      return {"face lost the normals of some corners", "faces lost the normals of some corners",
              "in OBJ all corners of a face have one, or none has"};
    case Loss::Observer:
      return {"observer was left out", "observers were left out", "the format has no irradiance"};
    case Loss::BrdfFormula:
      return {"face has a table in place of its BRDF's formula",
              "faces have tables in place of their BRDF's formula", "the format has other models"};
    case Loss::BrdfTexture:
      return {"face that is not diffuse has the mean colour of its texture",
              "faces that are not diffuse have the mean colour of their texture",
              "only diffuse BRDFs of the format have one"};
    case Loss::BrdfVertexColour:
      return {"face that is not diffuse, or has a texture, has the mean colour of its mesh's vertices",
              "faces that are not diffuse, or have a texture, have the mean colour of their mesh's vertices",
              "only diffuse BRDFs of the format have them"};
    case Loss::GlassColour:
      return {"face lost the colour of its glass", "faces lost the colour of their glass",
              "the renderer's glass is clear, as it is written"};
    case Loss::MirrorFresnel:
      return {"face lost the dependence of its specular (delta) part on the angle",
              "faces lost the dependence of their specular (delta) part on the angle",
              "mirrors of the format have one reflectance"};
    case Loss::EmitterNormal:
      return {"face that emits lost the normals of its vertices",
              "faces that emit lost the normals of their vertices", "its light would leave by them"};
    case Loss::Backplate:
      return {"backplate was left out", "backplates were left out", "the format has none"};
    case Loss::BrdfNearest:
      return {"face has the nearest material in place of its BRDF's formula",
              "faces have the nearest material in place of their BRDF's formula",
              "the format has other models"};
    case Loss::EmissionOfOneSide:
      return {"face that emits lost its dark back", "faces that emit lost their dark backs",
              "the other faces of the mesh are seen from both sides"};
    case Loss::Geometry:
      return {"mesh lost its geometry", "meshes lost their geometry", "the format has only materials"};
  }
  return {};
}

}  // namespace

void Losses::report(const grf::SourceLocation& location, grf::Diagnostics& diagnostics) const {
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    if (counts_[i] == 0) continue;
    const LossText text = text_of(static_cast<Loss>(i));
    diagnostics.loss(location, fmt::format("{}: {}", counted(counts_[i], text.one, text.many), text.why));
  }
}

void Losses::report_written(const grf::SourceLocation& location, std::string_view format,
                            grf::Diagnostics& diagnostics) const {
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    if (counts_[i] == 0) continue;
    const LossText text = text_of(static_cast<Loss>(i));
    diagnostics.loss(location,
                     fmt::format("{}: {} has none", counted(counts_[i], text.one, text.many), format));
  }
}

}  // namespace convert
