// The options of a render. One table says their keys, values, defaults and meanings: OP files, the command
// line and documents follow from it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "grf/keywords.h"
#include "grf/math.h"
#include "grf/source_location.h"
#include "renderer/transport/plan/effect.h"

namespace options {

struct ImageSize {
  int width = 0;
  int height = 0;

  bool operator==(const ImageSize&) const = default;
};

struct IntegerPair {
  int first = 0;
  int second = 0;

  bool operator==(const IntegerPair&) const = default;
};

/// Where options were given in a file, by their keys. Where a thing was written makes it no other thing.
struct OptionLocations : std::map<std::string_view, grf::SourceLocation> {
  bool operator==(const OptionLocations&) const { return true; }

  /// Or that of nothing, for an option of the command line.
  grf::SourceLocation of(std::string_view key) const {
    const auto found = find(key);
    return found == end() ? grf::SourceLocation() : found->second;
  }
};

/// Options of the sampling scheme. An absent one keeps the scheme's default; see `scheme_model`.
struct SchemeOptions {
  std::string name;  ///< a word of the table; empty: what the scene says
  std::optional<float> lobe_exponent;
  std::optional<float> anisotropic_nu;
  std::optional<float> anisotropic_nv;
  std::optional<int> trees_over_theta;
  std::optional<int> trees_over_phi;
  std::optional<float> mean_tries;
  std::optional<int> tree_resolution;
  std::optional<bool> releases_table;
  std::optional<IntegerPair> factors_u;  ///< theta, phi
  std::optional<IntegerPair> factors_p;  ///< theta, phi
  std::optional<IntegerPair> factors;    ///< J, K
  std::optional<bool> factors_by_half_vector;
  std::string factors_file;                   ///< without its endings
  std::optional<IntegerPair> cdf_resolution;  ///< theta, phi
  std::optional<bool> compresses_cdf;

  bool operator==(const SchemeOptions&) const = default;
};

struct RenderOptions : SchemeOptions {
  std::string scene;   ///< path of the GRF file
  std::string output;  ///< path of the image; empty: the scene's name with .exr
  ImageSize size = {500, 400};
  float exposure = 0;  ///< stops, of 8-bit outputs
  /// What an EXR output shows besides the image: words of the table.
  std::vector<std::string> layers;
  std::optional<grf::Vec3f> viewer;  ///< the eye, in world coordinates; absent: framed to the scene
  std::optional<grf::Vec3f> target;  ///< the point looked at; absent: the scene's centre
  grf::Vec3f up = grf::Vec3f(0, 1, 0);
  float field_of_view = 45;               ///< vertical, degrees
  grf::Vec3f background = grf::Vec3f(0);  ///< radiance, W/(sr m2)
  std::string environment;                ///< path of an environment map or background image
  std::string projection = "latlong";     ///< of that image: latlong or backplate
  std::optional<IntegerPair> resampling;  ///< M and N
  std::string integrator = "path";        ///< naive or path
  int depth = 5;
  int branches = 2;
  std::optional<int> samples;  ///< a pixel; see `samples_a_pixel`
  bool pixel_radial = false;
  bool pixel_random = true;
  IntegerPair pixel_samples = {1, 1};  ///< across and down a pixel
  int secondary_rays_root = 10;
  std::string points = "sobol";     ///< or independent
  std::string precision = "float";  ///< or double
  bool ray_casting = false;
  bool uses_irradiance = false;
  /// Words of transport::effect_words; what is in the first and not in the second may be in the image.
  std::vector<std::string> only = all_effects(), without;
  std::string kernel = "auto";        ///< auto or full
  std::optional<float> target_error;  ///< sqrt(relMSE) of the image
  bool adaptive = false;              ///< more samples where the error is
  std::optional<float> max_seconds;
  std::string checkpoint;  ///< path; empty: none
  std::uint32_t seed = 0;
  int threads = 0;  ///< 0: all
  bool shows_window = false;
  std::string display_server;          ///< HOST:PORT; empty: none
  bool writes_memory = false;          ///< `mem.op` beside the image
  bool writes_sampling_time = false;   ///< `samplingTime`
  bool writes_rendering_time = false;  ///< `renderingTime`
  bool writes_prebuild_time = false;   ///< `prebuildTime`
  OptionLocations locations;

  transport::EffectSet effects() const;

  /// Of the integrator path. Where BPT_Samples is not given, as many as the thesis' estimator would take, so
  /// that an old OP file costs about what it did.
  int samples_a_pixel() const;

  bool operator==(const RenderOptions&) const = default;

 private:
  static std::vector<std::string> all_effects() {
    const auto words = transport::effect_words();
    return {words.begin(), words.end()};
  }
};

/// A number with its legal values. Those of reals are open intervals where `open` says so. The field may be
/// one that knows whether it was given.
template <class Number, class Field = Number>
struct NumberOption {
  Field RenderOptions::*field;
  Number minimum;
  Number maximum;
  bool open = false;
};
template <class Field>
struct BooleanOption {
  Field RenderOptions::*field;
};
/// One of some words, of which the field gets the spelling of the table.
struct WordOption {
  std::string RenderOptions::*field;
  std::vector<std::string_view> words;
};
/// Some of some words, divided by commas; or `all`, or `none`.
struct ListOption {
  std::vector<std::string> RenderOptions::*field;
  std::vector<std::string_view> words;
};
template <class Field>
struct PairOption {
  Field RenderOptions::*field;
  int minimum;  ///< of both
  int maximum;
  bool descending = false;  ///< the second is at most the first
};
struct PathOption {
  std::string RenderOptions::*field;
  bool can_be_none = false;  ///< the word `none` means no file, and leaves the field empty
  /// Of the files that it may name, lower case, without the dot; none: whatever they are called.
  std::vector<std::string_view> extensions = {};
  bool is_written = false;  ///< the render makes the file; else it has to be there
  bool is_stem = false;     ///< the name is without the extension

  bool means_none(std::string_view word) const { return can_be_none && grf::same_keyword(word, "none"); }
};
/// A program on the network, HOST:PORT; the word `none` leaves the field empty.
struct AddressOption {
  std::string RenderOptions::*field;
};
struct SizeOption {
  ImageSize RenderOptions::*field;
};
struct VectorOption {
  grf::Vec3f RenderOptions::*field;
  float minimum;  ///< of each component
};
struct PlaceOption {
  std::optional<grf::Vec3f> RenderOptions::*field;
};

/// What options are about, in the order of the table.
enum class OptionGroup { Image, View, Estimator, Effects, Running, Scheme, Times };

std::string_view title_of(OptionGroup group);

struct OptionInfo {
  std::string_view key;   ///< of OP files, `BPT_Depth`
  std::string_view flag;  ///< of the command line, `--depth`; empty: only in files
  std::variant<PathOption, AddressOption, SizeOption, VectorOption, PlaceOption, NumberOption<int>,
               NumberOption<std::uint32_t>, NumberOption<float>, NumberOption<int, std::optional<int>>,
               NumberOption<float, std::optional<float>>, BooleanOption<bool>,
               BooleanOption<std::optional<bool>>, WordOption, ListOption, PairOption<IntegerPair>,
               PairOption<std::optional<IntegerPair>>>
      value;
  std::string_view values;         ///< what stands behind the key, `int int`
  std::string_view default_value;  ///< in words
  std::string_view meaning;
  OptionGroup group = OptionGroup::Image;
};

const std::vector<OptionInfo>& option_table();

/// The option that a key means: without regard to case, `BPT Depth` and `Depth` too. Or null.
const OptionInfo* find_option(std::string_view key);

/// How many words an option's value has.
std::size_t word_count(const OptionInfo& option);

/// Sets an option from words. Returns what is wrong, or nothing. Paths are taken as they stand.
std::optional<std::string> set_option(RenderOptions& options, const OptionInfo& option,
                                      const std::vector<std::string>& words);

/// The words from which `set_option` makes the same value; none for what was not given and has no default of
/// its own.
std::vector<std::string> option_words(const RenderOptions& options, const OptionInfo& option);

}  // namespace options
