// Risks are what can make the image of a valid scene wrong or noisy: `grfconvert check --deep` and the editor
// list them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grf/catalogue.h"
#include "grf/scene.h"
#include "grf/scene_path.h"

namespace convert {

/// The kinds of risks, from those that make an image most wrong to those that are rarely seen.
enum class RiskKind {
  LampInSolid,          ///< a closed surface encloses a lamp, so that it illuminates nothing outside
  EnergyGain,           ///< a BRDF reflects more light than it receives
  DuplicateMesh,        ///< a mesh lies exactly on another one
  DuplicateFaces,       ///< faces of one mesh with the same corners: rays hit either of them
  NormalsAgainstFaces,  ///< vertex normals point to the back of their face
  InwardFaces,          ///< fronts point to the inside, or disagree: emission and exports have the wrong side
  FarFromMiddle,        ///< coordinates in single precision resolve the mesh coarsely
  UvWithoutArea,        ///< a textured face shows a single line or point of its image
  FacesWithoutArea,     ///< faces that no ray hits
};

struct RiskInfo {
  RiskKind kind;
  std::string_view name;    ///< in JSON
  std::string_view title;   ///< a short sentence
  std::string_view test;    ///< how it is found, for documents
  std::string_view advice;  ///< what to do, a sentence
};
/// Returns the table of all kinds, in their order.
const std::vector<RiskInfo>& risk_infos();
const RiskInfo& info_of(RiskKind kind);

/// A risk of one mesh, mesh light, area light or definition.
struct Risk {
  RiskKind kind = RiskKind::FacesWithoutArea;
  /// The fraction of the object's faces, or of the range of its BRDF or coordinates, that is affected; over
  /// 0, up to 1. Risks of the same kind are ranked by it.
  double share = 1;
  grf::ScenePath path;               ///< to the block or the definition
  grf::SourceLocation location;      ///< of the same
  std::vector<std::uint32_t> faces;  ///< of its mesh, ascending; empty: all of it
  std::string message;               ///< what is wrong, with the name of the object
};

/// Finds the risks of a scene, ranked: those that change an image most come first. The scene must have passed
/// `grf::check`. Takes time linear in the size of the scene, apart from sorting, and from lamps: only the
/// 64 largest lamps are tested against solids.
std::vector<Risk> risks_of(const grf::Scene& scene, const grf::Catalogue& catalogue);

}  // namespace convert
