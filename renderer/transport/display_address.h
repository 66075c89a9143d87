#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace transport {

/// Where a viewer of renders listens; by default where tev does.
struct DisplayAddress {
  std::string host = "127.0.0.1";
  std::string port = "14158";

  std::string text() const { return host + ":" + port; }
};

/// `HOST:PORT`, `HOST`, `:PORT`, or `[HOST]:PORT` for one with colons in it; what is left out is tev's own
/// address on this machine. Nothing if that is no address.
std::optional<DisplayAddress> display_address_of(std::string_view text);

/// Where renders look for a viewer, and viewers listen, if nobody says another place: tev's own address on
/// this machine, with the port of the environment's GRANADA_DISPLAY_PORT, if that is one. People who share a
/// machine need a port each.
DisplayAddress usual_display_address();

}  // namespace transport
