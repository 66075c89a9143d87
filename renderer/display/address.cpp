#include "renderer/display/address.h"

#include <algorithm>
#include <cstdlib>

namespace display {

std::optional<Address> address_of(std::string_view text) {
  Address address;
  std::string_view host = text;
  std::string_view port;
  if (text.starts_with('[')) {
    const std::size_t end = text.find(']');
    if (end == std::string_view::npos) return std::nullopt;
    host = text.substr(1, end - 1);
    port = text.substr(end + 1);
  } else if (const std::size_t colon = text.find(':'); colon != std::string_view::npos) {
    host = text.substr(0, colon);
    port = text.substr(colon);
  }
  if (!host.empty()) address.host = host;
  if (port.empty()) return host.empty() ? std::nullopt : std::optional(address);
  const bool is_number =
      std::all_of(port.begin() + 1, port.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (port[0] != ':' || port.size() < 2 || port.size() > 6 || !is_number) return std::nullopt;
  address.port = port.substr(1);
  const int number = std::stoi(address.port);
  return number >= 1 && number <= 65535 ? std::optional(address) : std::nullopt;
}

Address default_address() {
  const char* port = std::getenv("GRANADA_DISPLAY_PORT");
  if (port == nullptr) return {};
  return address_of(std::string(":") + port).value_or(Address());
}

}  // namespace display
