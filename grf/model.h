#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "grf/math.h"
#include "grf/source_location.h"

namespace grf {

/// A word as the value of a parameter, such as a method's name.
struct Word {
  std::string text;

  /// Compares case-insensitively.
  friend bool operator==(const Word& a, const Word& b);
};

/// The value of a parameter: a number, a boolean, an RGB triple (for a reflectance), or a word.
using Value = std::variant<float, bool, Colour, Word>;

/// Channels of an image. A single one is data, as the file stores it: from 0 to 1, if the file has integers.
/// `Rgb` is a colour, decoded as that of a texture.
enum class ImageChannel { Red, Green, Blue, Alpha, Rgb };

/// An image that varies a parameter over faces, by their texture coordinates.
struct ParameterMap {
  /// The image, as written, relative to the folder of the file that names it; quotes as in a mesh's name.
  std::string file;
  ImageChannel channel = ImageChannel::Red;

  bool operator==(const ParameterMap&) const = default;
};

/// A named argument of a model, `name = value` or `name = texture "file" channel * value`.
struct Argument {
  std::string name;
  Value value;  ///< with a map, a number or a colour, which multiplies the image
  SourceLocation location;
  std::optional<ParameterMap> map = std::nullopt;

  friend bool operator==(const Argument& a, const Argument& b);
};

/// A BRDF or a sampling scheme as data: a keyword and named values, as they were written. The catalogue
/// defines the keywords, names and ranges (`check`), so an unknown model survives a round trip.
struct Model {
  std::string keyword;
  std::vector<Argument> arguments;
  SourceLocation location;

  /// Compares keywords and names case-insensitively.
  friend bool operator==(const Model& a, const Model& b);
};

/// A reference, by name, to a definition in scope.
struct Reference {
  std::string name;
  SourceLocation location;

  bool operator==(const Reference&) const = default;
};

/// A term of a weighted sum of BRDFs, or a layer of weight 1.
struct CombineTerm {
  float weight = 0;  ///< 0 or more
  Reference brdf;

  bool operator==(const CombineTerm&) const = default;
};

// BRDFs and sampling schemes are distinct types, so that a variant can hold either.

/// A BRDF as data: a model with its arguments.
struct BrdfModel : Model {
  /// The terms of a `combine`, at least one; the base of a `coat`; the base and the top of a `layer`; empty
  /// for other models.
  std::vector<CombineTerm> terms;
  /// The data file after the keyword (`measured`), empty if there is none: as written, relative to the folder
  /// of the file that names it; quotes as in a mesh's name.
  std::string data_file;
  /// The text file that holds this instance and is named instead of it; empty if the instance is written
  /// inline. Such an instance is no `combine`, since its file has no definitions.
  std::string instance_file;

  bool operator==(const BrdfModel&) const = default;
};

/// Returns the names of a layered model's BRDFs in the order of its terms: `base` of a `coat`, `base` and
/// `top` of a `layer`, none for another keyword.
std::span<const std::string_view> layer_names(std::string_view keyword);

/// The largest number of layers above each other.
constexpr std::size_t MostLayers = 8;

/// Returns whether a BRDF consists of layers above each other, each of which names a BRDF.
bool is_layered(const BrdfModel& brdf);

/// A sampling scheme as data.
struct PdfModel : Model {
  bool operator==(const PdfModel&) const = default;
};

/// Returns the word for a channel in GRF: `r`, `g`, `b`, `a` or `rgb`.
std::string_view word_of(ImageChannel channel);
/// Returns the channel that a word means, without regard to case, or nothing.
std::optional<ImageChannel> find_channel(std::string_view word);

/// Returns whether an image varies a parameter.
bool has_maps(const Model& model);
/// Returns the path of the image of an argument that has one, relative to the file that the argument is in.
std::string map_path(const Argument& argument);

/// Returns whether a model is written as only its keyword: it reads as a reference if a definition of its
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
