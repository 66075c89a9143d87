// The schemas of USD that the tests know: types of values, attributes of prims, and what they must hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/converters/usd/usda_stage.h"

namespace test {

/// A type of values. A number has one row and one column.
struct UsdaType {
  enum class Kind : std::uint8_t { Number, String, Asset };
  Kind kind = Kind::Number;
  std::size_t rows = 1;
  std::size_t columns = 1;
  bool is_integer = false;
};

/// Returns a type by name; throws std::runtime_error if there is none.
const UsdaType& usda_type(const std::string& name);

/// Checks a stage against the schemas; throws std::runtime_error.
void check_usda(const UsdaStage& stage, const std::string& folder);

}  // namespace test
