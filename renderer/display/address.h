#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace display {

/// The network address of an image viewer; the default is tev's.
struct Address {
  std::string host = "127.0.0.1";
  std::string port = "14158";

  std::string text() const { return host + ":" + port; }
};

/// Parses `HOST:PORT`, `HOST`, `:PORT`, or `[HOST]:PORT` for a host with colons; parts left out default to
/// tev's address on this machine. Empty if the text is no address.
std::optional<Address> address_of(std::string_view text);

/// Returns the address where renders look for a viewer and viewers listen unless told otherwise: tev's on
/// this machine, with the port from the environment variable GRANADA_DISPLAY_PORT, if it is a valid one.
/// Users who share a machine need different ports.
Address default_address();

}  // namespace display
