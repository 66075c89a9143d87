#pragma once

#include <string>
#include <variant>
#include <vector>

#include "grf/math.h"
#include "grf/source_location.h"

namespace grf {

/// A word as a value, such as a method's name.
struct Word {
  std::string text;

  /// Without regard to case.
  friend bool operator==(const Word& a, const Word& b);
};

/// A number, a boolean, an RGB triple for a parameter that is a reflectance, or a word.
using Value = std::variant<float, bool, Colour, Word>;

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

/// The name of a definition in scope.
struct Reference {
  std::string name;
  SourceLocation location;

  bool operator==(const Reference&) const = default;
};

/// A BRDF of a weighted sum.
struct CombineTerm {
  float weight = 0;  ///< 0 or more
  Reference brdf;

  bool operator==(const CombineTerm&) const = default;
};

// Distinct types, so that a definition or an attribute can hold the one or the other.

struct BrdfModel : Model {
  /// What `combine` adds up, one term at least; other models have none.
  std::vector<CombineTerm> terms;
  /// The file of data behind the keyword (`measured`), empty if there is none: as written, relative to the
  /// folder of the file that names it; quotes as in a mesh's name.
  std::string data_file;
  /// The text file that holds this instance, in place of which it is named; empty if it is written out.
  /// Such an instance is no `combine`, since its file has no definitions.
  std::string instance_file;

  bool operator==(const BrdfModel&) const = default;
};

struct PdfModel : Model {
  bool operator==(const PdfModel&) const = default;
};

/// True of a model that is written as its keyword alone: it reads as a reference where a definition of its
/// kind has that name.
bool is_bare_word(const BrdfModel& brdf);
bool is_bare_word(const PdfModel& pdf);

/// An image that multiplies the colour of faces.
struct Texture {
  std::string
      file;  ///< as written, relative to the folder of the file that names it; quotes as in a mesh's name
  SourceLocation location;

  bool operator==(const Texture&) const = default;
};

}  // namespace grf
