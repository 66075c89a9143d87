#pragma once

#include <string>
#include <variant>
#include <vector>

#include "grf/math.h"
#include "grf/source_location.h"

namespace grf {

/// A number, a boolean, or an RGB triple for a parameter that is a reflectance.
using Value = std::variant<float, bool, Colour>;

/// `name = value`.
struct Argument {
  std::string name;
  Value value;
  SourceLocation location;

  friend bool operator==(const Argument& a, const Argument& b);
};

/// A BRDF or a sampling scheme as data: a keyword and named values, as they were written. Which keywords,
/// names and ranges exist is the catalogue's business (`check`), so an unknown model survives a round trip.
struct Model {
  std::string keyword;
  std::vector<Argument> arguments;
  SourceLocation location;

  /// Keywords and names are compared without regard to case.
  friend bool operator==(const Model& a, const Model& b);
};

/// Distinct types, so that a definition or an attribute can hold the one or the other.
struct BrdfModel : Model {
  bool operator==(const BrdfModel&) const = default;
};
struct PdfModel : Model {
  bool operator==(const PdfModel&) const = default;
};

/// An image that multiplies the colour of faces.
struct Texture {
  std::string
      file;  ///< as written, relative to the folder of the file that names it; quotes as in a mesh's name
  SourceLocation location;

  bool operator==(const Texture&) const = default;
};

}  // namespace grf
