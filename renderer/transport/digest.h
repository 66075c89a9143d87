// SHA-256 digests name contents: files, options, jobs and parts of images.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct evp_md_ctx_st;

namespace transport {

/// A digest of SHA-256 (FIPS 180-4).
using Digest = std::array<std::uint8_t, 32>;

/// Computes the digest of bytes that come in pieces.
class DigestBuilder {
 public:
  DigestBuilder();

  DigestBuilder& add(std::string_view bytes);
  /// Returns the digest of all bytes; to be called once.
  Digest digest();

 private:
  struct Free {
    void operator()(evp_md_ctx_st* context) const;
  };
  std::unique_ptr<evp_md_ctx_st, Free> context_;
};

Digest digest_of(std::string_view bytes);

/// Returns the digest of a digest and further bytes.
Digest extended(const Digest& before, std::string_view bytes);

/// Writes a digest as 64 hexadecimal digits in lower case.
std::string hex(const Digest& digest);

/// Reads what `hex` writes; empty if the text is anything else.
std::optional<Digest> digest_of_hex(std::string_view text);

}  // namespace transport
