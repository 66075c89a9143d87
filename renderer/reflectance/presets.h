// BRDFs that others can start from: those of the thesis' tables.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reflectance {

struct Preset {
  std::string_view name;
  std::string_view brdf;  ///< GRF text of an instance
};

struct PresetTable {
  std::string_view title;
  std::vector<Preset> presets;
};

/// Table 5.5, by the names there: what the measurements of the thesis' chapter 5 are of.
const PresetTable& thesis_models();

/// The presets of table 5.5; then polished dielectrics with the indices of refraction of table 2.1 (without
/// vacuum and air, which reflect nothing), and rough metals with those of table 2.2. The indices are means
/// over the spectrum, so that colours are in ks.
const std::vector<PresetTable>& preset_tables();

/// The GRF text of an entry of table 5.5, which has to be there.
std::string thesis_model(std::string_view name);

}  // namespace reflectance
