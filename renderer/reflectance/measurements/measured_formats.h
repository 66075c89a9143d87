// The file formats of measured BRDFs, which are told apart by content.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "renderer/reflectance/measurements/angle_grid.h"
#include "renderer/reflectance/measurements/scattered_table.h"
#include "renderer/reflectance/merl_table.h"

namespace reflectance {

/// A table of measured values of any kind, not null.
using MeasuredTable = std::variant<std::shared_ptr<const MerlTable>, std::shared_ptr<const AngleGrid>,
                                   std::shared_ptr<const ScatteredTable>>;

/// One file format that `measured` reads.
struct MeasuredFormat {
  std::string_view name;
  std::string_view extension;  ///< without the dot; a file may have another one
  bool (*sniff)(std::string_view bytes) = nullptr;
  /// Reads the bytes of a file, or returns nothing after an error, which names the file and, of a text, line
  /// and column; or of MERL, where the file was asked for.
  std::optional<MeasuredTable> (*read)(std::string_view bytes, const std::string& path,
                                       const grf::SourceLocation& asked_for_at,
                                       grf::Diagnostics& diagnostics) = nullptr;
};

std::span<const MeasuredFormat> measured_formats();

/// Finds the format of a file's bytes; null if none has it.
const MeasuredFormat* find_measured_format(std::string_view bytes);

/// Returns whether bytes are those of a file of the RGL data base, which the model `rgl` reads.
bool sniff_rgl(std::string_view bytes);

}  // namespace reflectance
