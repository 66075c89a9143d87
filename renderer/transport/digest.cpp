#include "renderer/transport/digest.h"

#include <charconv>
#include <stdexcept>

#include <fmt/format.h>
#include <openssl/evp.h>

namespace transport {
namespace {

/// Throws if a function of OpenSSL failed, for which only lack of memory is a reason here.
void require(bool has_succeeded) {
  if (!has_succeeded) throw std::runtime_error("OpenSSL cannot compute a SHA-256 digest");
}

}  // namespace

void DigestBuilder::Free::operator()(evp_md_ctx_st* context) const { EVP_MD_CTX_free(context); }

DigestBuilder::DigestBuilder() : context_(EVP_MD_CTX_new()) {
  require(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
}

DigestBuilder& DigestBuilder::add(std::string_view bytes) {
  require(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()) == 1);
  return *this;
}

Digest DigestBuilder::digest() {
  Digest digest = {};
  require(EVP_DigestFinal_ex(context_.get(), digest.data(), nullptr) == 1);
  return digest;
}

Digest digest_of(std::string_view bytes) { return DigestBuilder().add(bytes).digest(); }

Digest extended(const Digest& before, std::string_view bytes) {
  return DigestBuilder()
      .add({reinterpret_cast<const char*>(before.data()), before.size()})
      .add(bytes)
      .digest();
}

std::string hex(const Digest& digest) { return fmt::format("{:02x}", fmt::join(digest, "")); }

std::optional<Digest> digest_of_hex(std::string_view text) {
  Digest digest = {};
  if (text.size() != 2 * digest.size()) return std::nullopt;
  for (std::size_t i = 0; i < digest.size(); ++i) {
    const char* from = text.data() + 2 * i;
    const auto [end, problem] = std::from_chars(from, from + 2, digest[i], 16);
    if (problem != std::errc() || end != from + 2) return std::nullopt;
  }
  return hex(digest) == text ? std::optional(digest) : std::nullopt;  // upper case is no name
}

}  // namespace transport
