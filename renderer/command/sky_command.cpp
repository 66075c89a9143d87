#include "renderer/command/sky_command.h"

#include <charconv>
#include <cstdio>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/command/json_values.h"
#include "renderer/image/image_file.h"
#include "renderer/sky/sky_map.h"

namespace command {
namespace {

using grf::ExitCode;

/// Reads so many numbers with a separator between them; nothing if the text is another one.
std::optional<std::vector<int>> numbers_of(const std::string& text, char separator, std::size_t count) {
  std::vector<int> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (numbers.size() < count) {
    int number = 0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc() || number < 0) return std::nullopt;
    numbers.push_back(number);
    at = next;
    if (numbers.size() == count) break;
    if (at == end || *at++ != separator) return std::nullopt;
  }
  return at == end ? std::optional(numbers) : std::nullopt;
}

/// Returns the settings, or why they are none.
std::string read(const SkyArguments& arguments, sky::SkySettings& settings) {
  const auto date = numbers_of(arguments.date, '-', 3);
  if (!date) return fmt::format("'{}' is no date such as 2026-06-21", arguments.date);
  const auto time = numbers_of(arguments.time, ':', 2);
  if (!time || (*time)[0] > 23 || (*time)[1] > 59)
    return fmt::format("'{}' is no time such as 10:30", arguments.time);
  settings.at = {arguments.latitude,  arguments.longitude, (*date)[0],
                 (*date)[1],          (*date)[2],          (*time)[0] + (*time)[1] / 60.0,
                 arguments.utc_offset};
  settings.turbidity = arguments.turbidity;
  settings.north = arguments.north;
  settings.width = arguments.width;
  return sky::problem_of(settings);
}

void print_map(const sky::SkyMap& map, const SkyArguments& arguments) {
  if (arguments.json) {
    nlohmann::ordered_json report;
    report["image"] = arguments.output;
    report["sun_azimuth"] = map.sun.azimuth;
    report["sun_elevation"] = map.sun.elevation;
    report["sun_illuminance"] = 1000 * map.sun_illuminance;
    report["sky_illuminance"] = 1000 * map.sky_illuminance;
    report["brightness"] = map.brightness();
    fmt::print("{}\n", json_text(report, false));
    return;
  }
  fmt::print("sun: azimuth {:.2f} degrees from north over east, elevation {:.2f} degrees\n", map.sun.azimuth,
             map.sun.elevation);
  fmt::print("horizontal illuminance: {:.1f} klux by the sun, {:.1f} klux by the sky\n", map.sun_illuminance,
             map.sky_illuminance);
  fmt::print("BPT_EM_Scale {:.2g} gives a white horizontal surface the radiance 1\n", map.brightness());
}

}  // namespace

ExitCode sky(const SkyArguments& arguments) {
  sky::SkySettings settings;
  if (const std::string problem = read(arguments, settings); !problem.empty()) {
    fmt::print(stderr, "bpt: {}\n", problem);
    return ExitCode::BadCommandLine;
  }
  grf::Diagnostics diagnostics;
  const sky::SkyMap map = sky::sky_map(settings);
  const bool is_written = image::write_image({map.image}, arguments.output, diagnostics);
  fmt::print(stderr, "{}", diagnostics.to_text());
  if (!is_written) return ExitCode::BadInput;
  print_map(map, arguments);
  return ExitCode::Done;
}

}  // namespace command
