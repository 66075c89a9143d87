#include <algorithm>
#include <charconv>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

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

template <class Number>
Problem set(RenderOptions& options, const NumberOption<Number>& option,
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

Problem set(RenderOptions& options, const PathOption& option, const std::vector<std::string>& words) {
  if (words[0].empty()) return "found an empty name, expected that of a file";
  options.*option.field = words[0];
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

}  // namespace

const std::vector<OptionInfo>& option_table() {
  constexpr int LargestInt = std::numeric_limits<int>::max();
  constexpr std::uint32_t LargestSeed = std::numeric_limits<std::uint32_t>::max();
  using Options = RenderOptions;
  static const std::vector<OptionInfo> table = {
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
      {"BPT_Depth", "--depth", NumberOption<int>{&Options::depth, 0, LargestInt}, "int", "5",
       "the most scattering events on a path: 0 emission only, 1 direct light only"},
      {"BPT_Samples", "--samples", NumberOption<int>{&Options::samples, 1, LargestInt}, "int", "100",
       "samples a pixel"},
      {"BPT_Seed", "--seed", NumberOption<std::uint32_t>{&Options::seed, 0, LargestSeed}, "int", "0",
       "the same seed gives the same image, bit for bit"},
      {"BPT_Threads", "--threads", NumberOption<int>{&Options::threads, 0, 4096}, "int", "0",
       "threads to use; 0: all"},
  };
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
  if (std::holds_alternative<SizeOption>(option.value)) return 2;
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
