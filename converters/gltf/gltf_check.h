// How the reader knows that the scene in the extras of a file is still the one that the rest of it shows.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace convert {

/// The member of the extras that holds the check: eight digits in hexadecimal. Where the JSON is summed up,
/// they are zeros.
inline constexpr std::string_view CheckMember = "\"check\":\"";
inline constexpr std::string_view NoCheck = "00000000";

/// The sum (CRC-32) of a file's JSON with zeros for the check, and of its binary buffer. Any program that
/// changes the file writes other JSON or leaves the extras out.
std::string check_of(std::string json, std::string_view buffer);

/// The check that stands in the JSON, or an empty text.
std::string_view stated_check(std::string_view json);

}  // namespace convert
