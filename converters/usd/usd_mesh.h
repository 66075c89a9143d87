#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "converters/losses.h"
#include "converters/usd/exchange_material.h"
#include "converters/usd/usd_text.h"
#include "grf/mesh.h"

namespace convert {

/// A mesh to be written as a prim.
struct UsdMesh {
  const grf::Mesh* mesh = nullptr;
  std::string name;                    ///< an identifier
  std::string original;                ///< UTF-8; empty: there was no name
  std::string looks;                   ///< the path of the prim with its materials
  std::vector<std::size_t> materials;  ///< of each surface; not used for surfaces without faces
};

/// Puts a mesh with a subset of faces for each material. Returns the names of the subsets with the indices of
/// their materials.
std::vector<std::pair<std::string, std::size_t>> put_usd_mesh(UsdText& text, const UsdMesh& usd_mesh,
                                                              const ExchangeMaterials& materials,
                                                              Losses& losses);

}  // namespace convert
