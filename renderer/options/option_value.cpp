// Values of options are converted from words and back.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

#include "grf/diagnostics.h"
#include "grf/keywords.h"
#include "renderer/options/render_options.h"

namespace options {
namespace {

constexpr float LargestNumber = std::numeric_limits<float>::max();

using Problem = std::optional<std::string>;

template <class Number>
bool parse(const std::string& word, Number& number) {
  const char* first = word.data() + (word.starts_with('+') ? 1 : 0);
  const char* last = word.data() + word.size();
  const auto [end, error] = std::from_chars(first, last, number);
  if (error != std::errc() || end != last) return false;
  if constexpr (std::is_floating_point_v<Number>) return number >= -LargestNumber && number <= LargestNumber;
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

/// Finds a word in the table, case-insensitively; empty if it is not there.
std::string_view known_word(std::string_view word, const std::vector<std::string_view>& words) {
  const auto found = std::find_if(words.begin(), words.end(),
                                  [&](std::string_view known) { return grf::same_keyword(word, known); });
  return found == words.end() ? std::string_view() : *found;
}

std::string expected_words(std::string_view word, const std::vector<std::string_view>& words) {
  const std::string suggestion = grf::did_you_mean(word, {words.begin(), words.end()});
  return fmt::format("found '{}', expected one of {}{}", word, fmt::join(words, ", "),
                     suggestion.empty() ? "" : ": " + suggestion);
}

Problem set(RenderOptions& options, const WordOption& option, const std::vector<std::string>& words) {
  const std::string_view known = known_word(words[0], option.words);
  if (known.empty()) return expected_words(words[0], option.words);
  options.*option.field = known;
  return std::nullopt;
}

Problem set(RenderOptions& options, const ListOption& option, const std::vector<std::string>& words) {
  std::vector<std::string_view> chosen;
  std::vector<std::string_view> allowed = option.words;
  allowed.insert(allowed.end(), {"all", "none"});
  if (grf::same_keyword(words[0], "all")) {
    chosen = option.words;
  } else if (!grf::same_keyword(words[0], "none")) {
    for (std::string_view rest = words[0]; !rest.empty();) {
      const std::size_t comma = std::min(rest.find(','), rest.size());
      const std::string_view known = known_word(rest.substr(0, comma), option.words);
      if (known.empty()) return expected_words(rest.substr(0, comma), allowed);
      chosen.push_back(known);
      rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
  }
  auto& field = options.*option.field;
  field.clear();
  for (const std::string_view word : option.words) {
    if (std::find(chosen.begin(), chosen.end(), word) != chosen.end()) field.emplace_back(word);
  }
  return std::nullopt;
}

template <class Field>
Problem set(RenderOptions& options, const PairOption<Field>& option, const std::vector<std::string>& words) {
  IntegerPair pair;
  const auto right = [&](int number) { return number >= option.minimum && number <= option.maximum; };
  if (!parse(words[0], pair.first) || !parse(words[1], pair.second) || !right(pair.first) ||
      !right(pair.second) || (option.descending && pair.second > pair.first)) {
    return fmt::format("found '{} {}', expected two whole numbers from {} to {}{}", words[0], words[1],
                       option.minimum, option.maximum,
                       option.descending ? ", the second no greater than the first" : "");
  }
  options.*option.field = pair;
  return std::nullopt;
}

Problem set(RenderOptions& options, const PathOption& option, const std::vector<std::string>& words) {
  if (words[0].empty()) return "found an empty name, expected the name of a file";
  options.*option.field = option.means_none(words[0]) ? std::string() : words[0];
  return std::nullopt;
}

Problem set(RenderOptions& options, const AddressOption& option, const std::vector<std::string>& words) {
  constexpr int LargestPort = 65535;
  constexpr std::size_t LongestPath = 107;  // of a socket: see unix(7)
  const std::string& address = words[0];
  if (address.starts_with('/') && address.size() <= LongestPath) {
    options.*option.field = address;
    return std::nullopt;
  }
  const std::size_t colon = std::min(address.rfind(':'), address.size());
  int port = 0;
  const bool has_port = colon < address.size() && parse(address.substr(colon + 1), port);
  const bool is_none = grf::same_keyword(address, "none");
  if (!is_none && (colon == 0 || !has_port || port < 1 || port > LargestPort)) {
    return fmt::format(
        "found '{}', expected HOST:PORT, such as 127.0.0.1:14158, the path of a socket, or none", address);
  }
  options.*option.field = is_none ? std::string() : address;
  return std::nullopt;
}

Problem set(RenderOptions& options, const NameOption& option, const std::vector<std::string>& words) {
  if (words[0].empty()) return "found an empty name, expected a name, or none";
  options.*option.field = grf::same_keyword(words[0], "none") ? std::string() : words[0];
  return std::nullopt;
}

Problem parse_camera(const std::vector<std::string>& words, NamedCamera& camera) {
  camera.name = words[0];
  if (camera.name.empty() || grf::same_keyword(camera.name, "none"))
    return fmt::format("found the name '{}', expected another one", camera.name);
  std::array<float, CamerasOption::WordsOfCamera - 1> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!parse(words[i + 1], numbers[i])) return fmt::format("found '{}', expected a number", words[i + 1]);
  }
  camera.eye = {numbers[0], numbers[1], numbers[2]};
  camera.target = {numbers[3], numbers[4], numbers[5]};
  camera.up = {numbers[6], numbers[7], numbers[8]};
  camera.field_of_view = numbers[9];
  camera.lens_radius = numbers[10];
  camera.focus_distance = numbers[11];
  if (!(camera.field_of_view > 0 && camera.field_of_view < 180))
    return fmt::format("found '{}', expected a field of view between 0 and 180", words[10]);
  if (camera.lens_radius < 0 || camera.focus_distance < 0)
    return fmt::format("found '{} {}', expected a lens radius and a focus distance of 0 or more", words[11],
                       words[12]);
  if (camera.eye == camera.target)
    return fmt::format("the camera '{}' looks at its own position: the view direction is undefined",
                       camera.name);
  return std::nullopt;
}

Problem set(RenderOptions& options, const CamerasOption& option, const std::vector<std::string>& words) {
  std::vector<NamedCamera> cameras;
  for (std::size_t i = 0; i < words.size(); i += option.WordsOfCamera) {
    const auto first = words.begin() + static_cast<std::ptrdiff_t>(i);
    NamedCamera camera;
    if (Problem problem = parse_camera({first, first + option.WordsOfCamera}, camera)) return problem;
    const auto same = [&](const NamedCamera& other) { return other.name == camera.name; };
    if (std::any_of(cameras.begin(), cameras.end(), same))
      return fmt::format("two cameras have the name '{}'", camera.name);
    cameras.push_back(std::move(camera));
  }
  options.*option.field = std::move(cameras);
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
    const std::string range = minimum == 0 ? ", each 0 or more" : "";
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

Problem set(RenderOptions& options, const PointOption& option, const std::vector<std::string>& words) {
  grf::Vec3f place;
  if (Problem problem = parse_vector(words, -LargestNumber, place)) return problem;
  options.*option.field = place;
  return std::nullopt;
}

// Words of values.

using Words = std::vector<std::string>;

Words words_of(bool value) { return {value ? "true" : "false"}; }
Words words_of(float value) { return {fmt::format("{}", value)}; }
Words words_of(int value) { return {fmt::format("{}", value)}; }
Words words_of(std::uint32_t value) { return {fmt::format("{}", value)}; }
Words words_of(const IntegerPair& value) {
  return {fmt::format("{}", value.first), fmt::format("{}", value.second)};
}
Words words_of(const ImageSize& value) {
  return {fmt::format("{}", value.width), fmt::format("{}", value.height)};
}
Words words_of(const grf::Vec3f& value) {
  return {fmt::format("{}", value.x), fmt::format("{}", value.y), fmt::format("{}", value.z)};
}
Words words_of(const std::string& value) { return value.empty() ? Words() : Words{value}; }
Words words_of(const std::vector<std::string>& value) {
  return {value.empty() ? "none" : fmt::format("{}", fmt::join(value, ","))};
}
Words words_of(const std::vector<NamedCamera>& cameras) {
  Words words;
  for (const NamedCamera& camera : cameras) {
    words.push_back(camera.name);
    for (const grf::Vec3f& vector : {camera.eye, camera.target, camera.up}) {
      for (const std::string& word : words_of(vector)) words.push_back(word);
    }
    for (const float number : {camera.field_of_view, camera.lens_radius, camera.focus_distance})
      words.push_back(fmt::format("{}", number));
  }
  return words;
}
template <class Value>
Words words_of(const std::optional<Value>& value) {
  return value ? words_of(*value) : Words();
}

}  // namespace

int RenderOptions::samples_per_pixel() const {
  constexpr std::int64_t Most = std::numeric_limits<int>::max();
  if (samples) return *samples;
  const std::int64_t secondary_rays = std::int64_t(secondary_rays_root) * secondary_rays_root;
  const std::int64_t places = std::int64_t(pixel_samples.first) * pixel_samples.second;
  return static_cast<int>(places > Most / secondary_rays ? Most : places * secondary_rays);
}

transport::EffectSet RenderOptions::effects() const {
  const transport::EffectSet chosen = transport::effects_named(only);
  const transport::EffectSet left_out = transport::effects_named(without);
  transport::EffectSet effects;
  for (const transport::EffectInfo& info : transport::EffectInfos) {
    if (chosen.has(info.effect) && !left_out.has(info.effect)) effects.add(info.effect);
  }
  return effects;
}

bool is_repeated(const OptionInfo& option) { return std::holds_alternative<CamerasOption>(option.value); }

std::size_t word_count(const OptionInfo& option) {
  if (std::holds_alternative<SizeOption>(option.value) ||
      std::holds_alternative<PairOption<IntegerPair>>(option.value) ||
      std::holds_alternative<PairOption<std::optional<IntegerPair>>>(option.value)) {
    return 2;
  }
  if (is_repeated(option)) return CamerasOption::WordsOfCamera;
  const bool is_vector =
      std::holds_alternative<VectorOption>(option.value) || std::holds_alternative<PointOption>(option.value);
  return is_vector ? 3 : 1;
}

std::optional<std::string> set_option(RenderOptions& options, const OptionInfo& option,
                                      const std::vector<std::string>& words) {
  const std::size_t count = word_count(option);
  if (words.size() != count && (!is_repeated(option) || words.empty() || words.size() % count != 0)) {
    return fmt::format("found {} {}, expected {} ({})", words.size(), words.size() == 1 ? "value" : "values",
                       count, option.values);
  }
  return std::visit([&](const auto& value) { return set(options, value, words); }, option.value);
}

std::vector<std::string> option_words(const RenderOptions& options, const OptionInfo& option) {
  return std::visit([&](const auto& value) { return words_of(options.*value.field); }, option.value);
}

}  // namespace options
