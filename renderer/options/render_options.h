// The options of a render. One table says their keys, values, defaults and meanings: OP files, the command
// line and documents follow from it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "grf/math.h"

namespace options {

struct ImageSize {
  int width = 0;
  int height = 0;

  bool operator==(const ImageSize&) const = default;
};

struct RenderOptions {
  std::string scene;   ///< path of the GRF file
  std::string output;  ///< path of the image; empty: the scene's name with .exr
  ImageSize size = {500, 400};
  std::optional<grf::Vec3f> viewer;  ///< the eye, in world coordinates; absent: framed to the scene
  std::optional<grf::Vec3f> target;  ///< the point looked at; absent: the scene's centre
  grf::Vec3f up = grf::Vec3f(0, 1, 0);
  float field_of_view = 45;               ///< vertical, degrees
  grf::Vec3f background = grf::Vec3f(0);  ///< radiance, W/(sr m2)
  int depth = 5;
  int samples = 100;  ///< a pixel
  std::uint32_t seed = 0;
  int threads = 0;  ///< 0: all

  bool operator==(const RenderOptions&) const = default;
};

/// A number with its legal values. Those of reals are open intervals where `open` says so.
template <class Number>
struct NumberOption {
  Number RenderOptions::*field;
  Number minimum;
  Number maximum;
  bool open = false;
};
struct PathOption {
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

struct OptionInfo {
  std::string_view key;   ///< of OP files, `BPT_Depth`
  std::string_view flag;  ///< of the command line, `--depth`; empty: only in files
  std::variant<PathOption, SizeOption, VectorOption, PlaceOption, NumberOption<int>,
               NumberOption<std::uint32_t>, NumberOption<float>>
      value;
  std::string_view values;         ///< what stands behind the key, `int int`
  std::string_view default_value;  ///< in words
  std::string_view meaning;
};

const std::vector<OptionInfo>& option_table();

/// The option that a key means: without regard to case, `BPT Depth` and `Depth` too. Or null.
const OptionInfo* find_option(std::string_view key);

/// How many words an option's value has.
std::size_t word_count(const OptionInfo& option);

/// Sets an option from words. Returns what is wrong, or nothing. Paths are taken as they stand.
std::optional<std::string> set_option(RenderOptions& options, const OptionInfo& option,
                                      const std::vector<std::string>& words);

}  // namespace options
