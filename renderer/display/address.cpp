#include "renderer/display/address.h"

#include <algorithm>
#include <cstdlib>

#include <sys/un.h>
#include <unistd.h>

namespace display {
namespace {

/// The longest path of a socket, without the zero that ends it.
constexpr std::size_t LongestPath = sizeof(sockaddr_un::sun_path) - 1;

/// A path of a viewer that listens besides another one is longer by the number of its process.
constexpr std::size_t LongestNumber = 11;

/// Returns the TCP address that the environment asks for.
std::optional<Address> address_of_environment() {
  const char* port = std::getenv("GRANADA_DISPLAY_PORT");
  return port != nullptr ? address_of(std::string(":") + port) : std::nullopt;
}

std::string own_path() {
  const char* folder = std::getenv("XDG_RUNTIME_DIR");
  std::string path = std::string(folder != nullptr ? folder : "") + "/granada-display";
  const bool is_usable = folder != nullptr && *folder == '/' && path.size() + LongestNumber <= LongestPath;
  return is_usable ? path : "/tmp/granada-display-" + std::to_string(::getuid());
}

}  // namespace

std::optional<Address> address_of(std::string_view text) {
  Address address;
  if (text.starts_with('/')) {
    address.path = text;
    return text.size() <= LongestPath ? std::optional(address) : std::nullopt;
  }
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
  if (auto address = address_of_environment()) return *address;
  return {.path = own_path()};
}

Address free_address() {
  if (address_of_environment()) return {.port = "0"};
  return {.path = own_path() + "-" + std::to_string(::getpid())};
}

}  // namespace display
