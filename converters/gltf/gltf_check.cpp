#include "converters/gltf/gltf_check.h"

#include <fmt/format.h>
#include <zlib.h>

namespace convert {
namespace {

unsigned long sum(unsigned long before, std::string_view bytes) {
  if (bytes.empty()) return before;  // zlib starts again where there is no array
  return ::crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
}

/// Returns the offset of the checksum's digits, or npos.
std::size_t place_of_check(std::string_view json) {
  const std::size_t member = json.find(CheckMember);
  if (member == std::string_view::npos) return member;
  const std::size_t digits = member + CheckMember.size();
  return digits + NoCheck.size() <= json.size() ? digits : std::string_view::npos;
}

}  // namespace

std::string check_of(std::string json, std::string_view buffer) {
  const std::size_t digits = place_of_check(json);
  if (digits != std::string::npos) json.replace(digits, NoCheck.size(), NoCheck);
  return fmt::format("{:08x}", sum(sum(::crc32_z(0, nullptr, 0), json), buffer));
}

std::string_view stated_check(std::string_view json) {
  const std::size_t digits = place_of_check(json);
  return digits == std::string_view::npos ? std::string_view() : json.substr(digits, NoCheck.size());
}

}  // namespace convert
