// BRDF presets are the thesis' tables, and everyday materials.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

/// A BRDF with a name that people know.
struct Preset {
  std::string_view name;
  std::string_view brdf;  ///< GRF text of a BRDF instance
};

/// Presets under one title.
struct PresetTable {
  std::string_view title;
  std::vector<Preset> presets;
};

/// The BRDFs of table 5.5, by its names, which the measurements of the thesis' chapter 5 use.
const PresetTable& thesis_models();

/// The presets of table 5.5; then polished dielectrics with the indices of refraction of table 2.1 (without
/// vacuum and air, which reflect nothing), and rough metals with those of table 2.2. The indices are means
/// over the spectrum, so colours are in ks. Then metals, thin films, matt surfaces, plastics and fabrics,
/// which reflect at most what they receive.
const std::vector<PresetTable>& preset_tables();

/// Returns the GRF text of an entry of table 5.5, which must exist.
std::string thesis_model(std::string_view name);

}  // namespace reflectance
