#include <algorithm>
#include <charconv>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

#include "grf/diagnostics.h"
#include "grf/keywords.h"
#include "renderer/options/render_options.h"

namespace options {
namespace {

using Problem = std::optional<std::string>;

constexpr float Largest = std::numeric_limits<float>::max();

template <class Number>
bool parse(const std::string& word, Number& number) {
  const char* first = word.data() + (word.starts_with('+') ? 1 : 0);
  const char* last = word.data() + word.size();
  const auto [end, error] = std::from_chars(first, last, number);
  if (error != std::errc() || end != last) return false;
  if constexpr (std::is_floating_point_v<Number>) return number >= -Largest && number <= Largest;
  return true;
}

template <class Number, class Field>
Problem set(RenderOptions& options, const NumberOption<Number, Field>& option,
            const std::vector<std::string>& words) {
  Number number = {};
  const std::string kind = std::is_floating_point_v<Number> ? "a number" : "a whole number";
  const std::string range = option.open
                                ? fmt::format("{} between {} and {}", kind, option.minimum, option.maximum)
                                : fmt::format("{} from {} to {}", kind, option.minimum, option.maximum);
  const bool parsed = parse(words[0], number);
  const bool inside = option.open ? number > option.minimum && number < option.maximum
                                  : number >= option.minimum && number <= option.maximum;
  if (!parsed || !inside) return fmt::format("found '{}', expected {}", words[0], range);
  options.*option.field = number;
  return std::nullopt;
}

template <class Field>
Problem set(RenderOptions& options, const BooleanOption<Field>& option,
            const std::vector<std::string>& words) {
  const bool is_true = grf::same_keyword(words[0], "true");
  if (!is_true && !grf::same_keyword(words[0], "false")) {
    return fmt::format("found '{}', expected true or false", words[0]);
  }
  options.*option.field = is_true;
  return std::nullopt;
}

Problem set(RenderOptions& options, const WordOption& option, const std::vector<std::string>& words) {
  for (const std::string_view word : option.words) {
    if (!grf::same_keyword(words[0], word)) continue;
    options.*option.field = word;
    return std::nullopt;
  }
  const std::string suggestion = grf::did_you_mean(words[0], {option.words.begin(), option.words.end()});
  return fmt::format("found '{}', expected one of {}{}", words[0], fmt::join(option.words, ", "),
                     suggestion.empty() ? "" : ": " + suggestion);
}

Problem set(RenderOptions& options, const PairOption& option, const std::vector<std::string>& words) {
  IntegerPair pair;
  const auto right = [&](int number) { return number >= option.minimum && number <= option.maximum; };
  if (!parse(words[0], pair.first) || !parse(words[1], pair.second) || !right(pair.first) ||
      !right(pair.second) || (option.descending && pair.second > pair.first)) {
    return fmt::format("found '{} {}', expected two whole numbers from {} to {}{}", words[0], words[1],
                       option.minimum, option.maximum,
                       option.descending ? ", the second at most the first" : "");
  }
  options.*option.field = pair;
  return std::nullopt;
}

Problem set(RenderOptions& options, const PathOption& option, const std::vector<std::string>& words) {
  if (words[0].empty()) return "found an empty name, expected that of a file";
  options.*option.field = option.means_none(words[0]) ? std::string() : words[0];
  return std::nullopt;
}

Problem set(RenderOptions& options, const SizeOption& option, const std::vector<std::string>& words) {
  constexpr int LargestSide = 65535;
  ImageSize size;
  const auto wrong = [](int side) { return side < 1 || side > LargestSide; };
  if (!parse(words[0], size.width) || !parse(words[1], size.height) || wrong(size.width) ||
      wrong(size.height)) {
    return fmt::format("found '{} {}', expected a width and a height from 1 to {}", words[0], words[1],
                       LargestSide);
  }
  options.*option.field = size;
  return std::nullopt;
}

Problem parse_vector(const std::vector<std::string>& words, float minimum, grf::Vec3f& vector) {
  for (int i = 0; i < 3; ++i) {
    if (parse(words[static_cast<std::size_t>(i)], vector[i]) && vector[i] >= minimum) continue;
    const std::string range = minimum == 0 ? " of 0 or more" : "";
    return fmt::format("found '{}', expected three numbers{}", words[static_cast<std::size_t>(i)], range);
  }
  return std::nullopt;
}

Problem set(RenderOptions& options, const VectorOption& option, const std::vector<std::string>& words) {
  grf::Vec3f vector;
  if (Problem problem = parse_vector(words, option.minimum, vector)) return problem;
  options.*option.field = vector;
  return std::nullopt;
}

Problem set(RenderOptions& options, const PlaceOption& option, const std::vector<std::string>& words) {
  grf::Vec3f place;
  if (Problem problem = parse_vector(words, -Largest, place)) return problem;
  options.*option.field = place;
  return std::nullopt;
}

/// `BPT_Pixel_SampleRes`, `BPT Pixel SampleRes` and `Pixel_SampleRes` are the same key.
std::string canonical(std::string_view key) {
  std::string plain = grf::lower_case(key);
  std::replace(plain.begin(), plain.end(), ' ', '_');
  return plain.starts_with("bpt_") ? plain.substr(4) : plain;
}

/// Of the image and the light.
std::vector<OptionInfo> image_options() {
  constexpr int LargestInt = std::numeric_limits<int>::max();
  constexpr std::uint32_t LargestSeed = std::numeric_limits<std::uint32_t>::max();
  using Options = RenderOptions;
  return {
      {"BPT_Scene", "", PathOption{&Options::scene}, "path", "required", "the GRF scene"},
      {"BPT_Image_Resolution", "--size", SizeOption{&Options::size}, "int int", "500 400",
       "width and height in pixels"},
      {"BPT_Output_Image", "--output", PathOption{&Options::output}, "path", "the scene's name with .exr",
       "the image; the extension says the type, exr or png"},
      {"BPT_Viewer", "", PlaceOption{&Options::viewer}, "x y z", "framed to the scene",
       "the eye, in world coordinates"},
      {"BPT_VLook", "", PlaceOption{&Options::target}, "x y z", "the scene's centre", "the point looked at"},
      {"BPT_Up", "", VectorOption{&Options::up, -Largest}, "x y z", "0 1 0",
       "the direction up; where it is parallel to the view, the z axis"},
      {"BPT_FieldOfView", "", NumberOption<float>{&Options::field_of_view, 0, 180, true}, "float", "45",
       "vertical field of view in degrees"},
      {"BPT_Background", "", VectorOption{&Options::background, 0}, "r g b", "0 0 0",
       "radiance that comes from where nothing is, W/(sr m2)"},
      {"BPT_EM_Background", "--environment", PathOption{&Options::environment, true}, "path", "none",
       "environment map or background image: exr, hdr, pfm, png, jpg or tga, the 8-bit ones in sRGB"},
      {"BPT_EM_Projection", "", WordOption{&Options::projection, {"latlong", "backplate"}}, "word", "latlong",
       "latlong: light from all around, y up, the image's centre looks down -z, its right is +x; backplate: "
       "a plain image behind the scene that lights nothing"},
      {"BPT_RIS", "--ris", PairOption{&Options::resampling, 1, 65536, true}, "int int", "off",
       "M and N of resampled importance sampling with an environment map: N of M directions that follow the "
       "BRDF are chosen by the light from them"},
      {"BPT_Depth", "--depth", NumberOption<int>{&Options::depth, 0, LargestInt}, "int", "5",
       "the most scattering events on a path: 0 emission only, 1 direct light only"},
      {"BPT_Samples", "--samples", NumberOption<int>{&Options::samples, 1, LargestInt}, "int", "100",
       "samples a pixel"},
      {"BPT_Seed", "--seed", NumberOption<std::uint32_t>{&Options::seed, 0, LargestSeed}, "int", "0",
       "the same seed gives the same image, bit for bit"},
      {"BPT_Threads", "--threads", NumberOption<int>{&Options::threads, 0, 4096}, "int", "0",
       "threads to use; 0: all"},
      {"BPT_TargetError", "--target-error",
       NumberOption<float, std::optional<float>>{&Options::target_error, 0, Largest, true}, "float", "none",
       "stop once the estimated error, sqrt(relMSE) of the image, is no more than this, such as 0.02; "
       "without "
       "BPT_Samples, after as many samples as that takes"},
      {"BPT_MaxTime", "--time",
       NumberOption<float, std::optional<float>>{&Options::max_seconds, 0, Largest, true}, "float", "none",
       "stop after so many seconds of rendering, with what there is; without BPT_Samples, not before"},
      {"BPT_Checkpoint", "--checkpoint", PathOption{&Options::checkpoint, true}, "path", "none",
       "where to keep what a render resumes from, every minute and at its end: the same command goes on from "
       "it, and with more samples from a finished one too"},
      {"BPT_DisplayWindow", "", BooleanOption<bool>{&Options::shows_window}, "bool", "false",
       "show the image as it forms, in a viewer that listens at 127.0.0.1:14158"},
  };
}

/// Of the sampling schemes.
std::vector<OptionInfo> scheme_options() {
  using Options = RenderOptions;
  using Real = NumberOption<float, std::optional<float>>;
  using Whole = NumberOption<int, std::optional<int>>;
  using Flag = BooleanOption<std::optional<bool>>;
  constexpr float LargestExponent = 1e6F;
  constexpr int LargestTable = 65536;
  return {
      {"BPT_Pdf_Name", "--pdf",
       WordOption{&Options::name,
                  {"Diffuse", "Specular", "Hemisphere", "Sphere", "Anisotropic", "Disk", "Adaptive",
                   "Factored", "CascadeCDF", "Reject", "Own", "Auto"}},
       "word", "the scene's, else Auto",
       "the sampling scheme of all BRDFs, in place of the scene's: Diffuse, Specular, Hemisphere, Sphere, "
       "Anisotropic, Disk (or Adaptive), Factored, CascadeCDF, Reject, Own (the BRDF's sampler) or Auto"},
      {"BPT_Pdf_LobeExponent", "", Real{&Options::lobe_exponent, 0, LargestExponent}, "float",
       "the BRDF's own", "exponent for Hemisphere and Sphere"},
      {"BPT_Pdf_AnisoNu", "", Real{&Options::anisotropic_nu, 0, LargestExponent}, "float", "the BRDF's own",
       "exponent along x for Anisotropic"},
      {"BPT_Pdf_AnisoNv", "", Real{&Options::anisotropic_nv, 0, LargestExponent}, "float", "the BRDF's own",
       "exponent along y for Anisotropic"},
      {"BPT_Pdf_memstat", "", BooleanOption<bool>{&Options::writes_memory}, "bool", "false",
       "write the bytes that the tables of the schemes hold to `mem.op` beside the image"},
      {"BPT_QT_Precomputed", "", Whole{&Options::trees_over_theta, 1, LargestTable}, "int", "the scheme's",
       "quadtrees over theta for Disk"},
      {"BPT_QT_Anisotropic", "", Whole{&Options::trees_over_phi, 1, LargestTable}, "int", "the scheme's",
       "quadtrees over phi for Disk"},
      {"BPT_QT_avgnmax", "", Real{&Options::mean_tries, 1, LargestExponent, true}, "float", "the scheme's",
       "the mean number of tries that a leaf of a quadtree may need, for Disk"},
      {"BPT_QT_ImgRes", "", Whole{&Options::tree_resolution, 1, LargestTable}, "int", "the scheme's",
       "resolution of the dense sampling of the disc for Disk"},
      {"BPT_QT_release", "", Flag{&Options::releases_table}, "bool", "the scheme's",
       "free the table of BRDF values once the trees stand, for Disk"},
      {"BPT_Pdf_Factors_ResU", "", PairOption{&Options::factors_u, 1, LargestTable}, "int int",
       "the scheme's", "resolution over u for Factored, theta and phi"},
      {"BPT_Pdf_Factors_ResP", "", PairOption{&Options::factors_p, 1, LargestTable}, "int int",
       "the scheme's", "resolution over the other direction for Factored, theta and phi"},
      {"BPT_Pdf_Factors_JK", "", PairOption{&Options::factors, 1, LargestTable}, "int int", "the scheme's",
       "number of factors J and K for Factored"},
      {"BPT_Pdf_Factors_Half", "", Flag{&Options::factors_by_half_vector}, "bool", "the scheme's",
       "parametrise by the half vector, for Factored"},
      {"BPT_Pdf_Factors_File", "", PathOption{&Options::factors_file, true}, "path", "none",
       "for Factored, load NAME.txt and NAME_cdf.txt instead of factoring"},
      {"BPT_Pdf_CDF_Res", "", PairOption{&Options::cdf_resolution, 1, LargestTable}, "int int",
       "the scheme's", "resolution over the half vector for CascadeCDF, theta and phi"},
      {"BPT_Pdf_CDF_Compress", "", Flag{&Options::compresses_cdf}, "bool", "the scheme's",
       "compress the tables of CascadeCDF"},
      {"BPT_Chrono_Sampling", "", BooleanOption<bool>{&Options::writes_sampling_time}, "bool", "false",
       "append the seconds that all threads spent in drawing directions to `samplingTime` beside the image"},
      {"BPT_Chrono_Rendering", "", BooleanOption<bool>{&Options::writes_rendering_time}, "bool", "false",
       "append the seconds of the render to `renderingTime` beside the image"},
      {"BPT_Chrono_Prebuild", "", BooleanOption<bool>{&Options::writes_prebuild_time}, "bool", "false",
       "append the seconds that building the tables took to `prebuildTime` beside the image"},
  };
}

}  // namespace

const std::vector<OptionInfo>& option_table() {
  static const std::vector<OptionInfo> table = [] {
    std::vector<OptionInfo> options = image_options();
    std::vector<OptionInfo> of_schemes = scheme_options();
    for (OptionInfo& option : of_schemes) options.push_back(std::move(option));
    return options;
  }();
  return table;
}

const OptionInfo* find_option(std::string_view key) {
  const std::string wanted = canonical(key);
  const auto& table = option_table();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const OptionInfo& option) { return canonical(option.key) == wanted; });
  return found == table.end() ? nullptr : &*found;
}

std::size_t word_count(const OptionInfo& option) {
  if (std::holds_alternative<SizeOption>(option.value) || std::holds_alternative<PairOption>(option.value)) {
    return 2;
  }
  const bool is_vector =
      std::holds_alternative<VectorOption>(option.value) || std::holds_alternative<PlaceOption>(option.value);
  return is_vector ? 3 : 1;
}

std::optional<std::string> set_option(RenderOptions& options, const OptionInfo& option,
                                      const std::vector<std::string>& words) {
  if (words.size() != word_count(option)) {
    return fmt::format("found {} {}, expected {} ({})", words.size(), words.size() == 1 ? "value" : "values",
                       word_count(option), option.values);
  }
  return std::visit([&](const auto& value) { return set(options, value, words); }, option.value);
}

}  // namespace options
