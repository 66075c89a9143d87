// Render options are described by one table of their keys, values, defaults and meanings; OP files, the
// command line, the editor's dialog and documents follow from it.
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
#include "renderer/image/image.h"
#include "renderer/transport/effect.h"

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

/// A camera with a name: one of several of a scene, and one of the key cameras of a camera path.
struct NamedCamera {
  std::string name;
  grf::Vec3f eye = grf::Vec3f(0);     ///< world coordinates
  grf::Vec3f target = grf::Vec3f(0);  ///< the point looked at, world coordinates
  grf::Vec3f up = grf::Vec3f(0, 1, 0);
  float field_of_view = 45;  ///< vertical, degrees
  float lens_radius = 0;     ///< world units; 0: a pinhole camera
  float focus_distance = 0;  ///< world units, along the view direction; 0: to the target

  bool operator==(const NamedCamera&) const = default;
};

/// Source locations of options, by key. Locations do not take part in equality.
struct OptionLocations : std::map<std::string_view, grf::SourceLocation> {
  bool operator==(const OptionLocations&) const { return true; }

  /// Returns the location of an option, or an empty one for an option of the command line.
  grf::SourceLocation of(std::string_view key) const {
    const auto found = find(key);
    return found == end() ? grf::SourceLocation() : found->second;
  }
};

/// The reader of textures and environment maps, which is no option and takes no part in equality.
struct OptionImageReader {
  image::ImageReader read;  ///< empty: image::read_image

  bool operator==(const OptionImageReader&) const { return true; }
};

/// Options of the sampling scheme. An absent one keeps the scheme's default; see `scheme_model`.
struct SchemeOptions {
  std::string scheme;  ///< a word of the table; empty: each BRDF has the scene's scheme
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
  std::string factors_file;                   ///< path without `.txt` and `_cdf.txt`
  std::optional<IntegerPair> cdf_resolution;  ///< theta, phi
  std::optional<bool> compresses_cdf;

  bool operator==(const SchemeOptions&) const = default;
};

struct RenderOptions : SchemeOptions {
  std::string scene;   ///< path of the GRF file
  std::string output;  ///< path of the image; empty: the scene's name with .exr
  ImageSize size = {500, 400};
  float exposure = 0;  ///< exposure compensation of 8-bit outputs, stops
  /// Layers of EXR outputs besides the image: words of the table.
  std::vector<std::string> layers;
  std::optional<grf::Vec3f> eye;     ///< the eye, in world coordinates; absent: framed to the scene
  std::optional<grf::Vec3f> target;  ///< the point looked at; absent: the scene's centre
  grf::Vec3f up = grf::Vec3f(0, 1, 0);
  float field_of_view = 45;             ///< vertical, degrees
  float lens_radius = 0;                ///< world units; 0: a pinhole camera
  std::optional<float> focus_distance;  ///< world units, along the view direction; absent: to the target
  std::vector<NamedCamera> cameras;     ///< with different names
  std::string camera;  ///< the name of the one of these that renders; empty: that of the fields above
  int frames = 1;      ///< of an animation of the camera; 1: a still image
  int frame = 0;       ///< the one to render, from 1; 0: all
  std::string camera_path = "turntable";  ///< or linear or smooth, through `cameras`
  grf::Vec3f background = grf::Vec3f(0);  ///< radiance, W/(sr m2)
  std::string environment;                ///< path of an environment map or backplate
  std::string projection = "latlong";     ///< of that image: latlong or backplate
  float environment_rotation = 0;         ///< about the y axis, degrees, counter-clockwise seen from above
  float environment_scale = 1;            ///< factor of the radiance of that image
  std::optional<IntegerPair> resampling;  ///< M and N of resampled importance sampling
  std::string integrator = "path";        ///< naive or path
  int depth = 5;                          ///< the most bounces of a path
  int split_count = 2;                    ///< directions from the first non-specular hit
  std::optional<int> samples;             ///< per pixel; see `samples_per_pixel`
  bool pixel_radial = false;
  bool pixel_random = true;
  IntegerPair pixel_samples = {1, 1};  ///< across and down a pixel
  int secondary_rays_root = 10;
  std::string points = "sobol";     ///< or independent
  std::string precision = "float";  ///< or double
  bool ray_casting = false;
  bool uses_irradiance = false;
  /// Words of transport::effect_words; effects in the first and not in the second may be rendered.
  std::vector<std::string> only = all_effects(), without;
  std::string kernel = "auto";        ///< auto or full
  std::optional<float> target_error;  ///< sqrt(relMSE) of the image
  bool adaptive = false;              ///< adaptive sampling: more samples where the error is large
  std::optional<float> max_seconds;
  std::string checkpoint;  ///< path; empty: none
  std::uint32_t seed = 0;
  int threads = 0;  ///< 0: all
  bool shows_window = false;
  std::string display_server;          ///< HOST:PORT or the path of a socket; empty: none
  bool writes_memory = false;          ///< `mem.op` beside the image
  bool writes_sampling_time = false;   ///< `samplingTime`
  bool writes_rendering_time = false;  ///< `renderingTime`
  bool writes_prebuild_time = false;   ///< `prebuildTime`
  OptionLocations locations;
  OptionImageReader image_reader;

  transport::EffectSet effects() const;

  /// Returns the samples per pixel of the integrator path. Without BPT_Samples, as many as the thesis'
  /// estimator would take, so that an old OP file costs about as much as it did.
  int samples_per_pixel() const;

  bool operator==(const RenderOptions&) const = default;

 private:
  static std::vector<std::string> all_effects() {
    const auto words = transport::effect_words();
    return {words.begin(), words.end()};
  }
};

/// A number with its range, an open interval if `open`. The field may be an optional, which is empty if the
/// option was not given.
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
/// One of several words; the field gets the spelling of the table.
struct WordOption {
  std::string RenderOptions::*field;
  std::vector<std::string_view> words;
};
/// A comma-separated list of words; or `all`, or `none`.
struct ListOption {
  std::vector<std::string> RenderOptions::*field;
  std::vector<std::string_view> words;
};
template <class Field>
struct PairOption {
  Field RenderOptions::*field;
  int minimum;  ///< of both numbers
  int maximum;
  bool descending = false;  ///< the second is at most the first
};
struct PathOption {
  std::string RenderOptions::*field;
  bool can_be_none = false;  ///< the word `none` means no file, and leaves the field empty
  /// File name extensions that it accepts, lower case, without the dot; empty: any.
  std::vector<std::string_view> extensions = {};
  bool is_written = false;  ///< the render writes the file; else the file has to exist
  bool is_stem = false;     ///< the name is without the extension

  bool means_none(std::string_view word) const { return can_be_none && grf::same_keyword(word, "none"); }
};
/// A network address, HOST:PORT; the word `none` leaves the field empty.
struct AddressOption {
  std::string RenderOptions::*field;
};
/// A name, which the word `none` leaves empty.
struct NameOption {
  std::string RenderOptions::*field;
};
/// Cameras with names, one a line of the file: the option is the only one that may be given several times.
struct CamerasOption {
  static constexpr std::size_t WordsOfCamera = 13;

  std::vector<NamedCamera> RenderOptions::*field;
};
struct SizeOption {
  ImageSize RenderOptions::*field;
};
struct VectorOption {
  grf::Vec3f RenderOptions::*field;
  float minimum;  ///< of each component
};
struct PointOption {
  std::optional<grf::Vec3f> RenderOptions::*field;
};

/// Groups of options, in the order of the table.
enum class OptionGroup { Image, View, Estimator, Effects, Running, Scheme, Times };

std::string_view title_of(OptionGroup group);

struct OptionInfo {
  std::string_view key;   ///< key in OP files, `BPT_Depth`
  std::string_view flag;  ///< command-line flag, `--depth`; empty: only in files
  std::variant<PathOption, AddressOption, NameOption, CamerasOption, SizeOption, VectorOption, PointOption,
               NumberOption<int>, NumberOption<std::uint32_t>, NumberOption<float>,
               NumberOption<int, std::optional<int>>, NumberOption<float, std::optional<float>>,
               BooleanOption<bool>, BooleanOption<std::optional<bool>>, WordOption, ListOption,
               PairOption<IntegerPair>, PairOption<std::optional<IntegerPair>>>
      value;
  std::string_view values;         ///< types of the values, `int int`
  std::string_view default_value;  ///< as text
  std::string_view meaning;
  OptionGroup group = OptionGroup::Image;
};

const std::vector<OptionInfo>& option_table();

/// Finds the option of a key, case-insensitively; `BPT Depth` and `Depth` are BPT_Depth too. Null if unknown.
const OptionInfo* find_option(std::string_view key);

/// Returns the number of words of an option's value; of each value if the option is repeated.
std::size_t word_count(const OptionInfo& option);

/// Whether an option may have several values, each on a line of its own. Their words follow each other.
bool is_repeated(const OptionInfo& option);

/// Sets an option from words. Returns an error message, or nothing. Paths are not resolved.
std::optional<std::string> set_option(RenderOptions& options, const OptionInfo& option,
                                      const std::vector<std::string>& words);

/// Returns the words from which `set_option` makes the same value; empty if the option was not given and has
/// no default of its own.
std::vector<std::string> option_words(const RenderOptions& options, const OptionInfo& option);

}  // namespace options
