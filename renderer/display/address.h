#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace display {

/// The address of an image viewer: a Unix-domain socket, which only programs of its user can connect to, or
/// a TCP address; the default is tev's.
struct Address {
  std::string host = "127.0.0.1";
  std::string port = "14158";
  std::string path = {};  ///< of the socket; empty: the host and port

  std::string text() const { return path.empty() ? host + ":" + port : path; }
};

/// Parses the absolute path of a socket, `HOST:PORT`, `HOST`, `:PORT`, or `[HOST]:PORT` for a host with
/// colons; parts left out default to tev's address on this machine. Empty if the text is no address.
std::optional<Address> address_of(std::string_view text);

/// Returns the address where renders look for a viewer and viewers listen unless told otherwise: a socket of
/// this user in the folder XDG_RUNTIME_DIR, or else /tmp; or tev's host with the port from the environment
/// variable GRANADA_DISPLAY_PORT, if it is a valid one, for programs that know TCP only.
Address default_address();

/// Returns an address of the same kind that no other viewer listens at; its port 0 means any free one.
Address free_address();

}  // namespace display
