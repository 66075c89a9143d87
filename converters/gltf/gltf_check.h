// A checksum tells the reader that the scene in the extras of a file still matches the rest of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace convert {

/// The member of the extras with the checksum: eight hexadecimal digits, which count as zeros in the checksum
/// itself.
inline constexpr std::string_view CheckMember = "\"check\":\"";
inline constexpr std::string_view NoCheck = "00000000";

/// Computes the CRC-32 of a file's JSON, with zeros for the checksum, and of its binary buffer. Any program
/// that changes the file writes different JSON or drops the extras.
std::string check_of(std::string json, std::string_view buffer);

/// Returns the checksum stored in the JSON, or an empty text.
std::string_view stated_check(std::string_view json);

}  // namespace convert
