#include "converters/vrml/source.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "converters/text_encoding.h"
#include "converters/vrml/gzip.h"
#include "converters/wording.h"
#include "grf/text_file.h"

namespace convert::vrml {
namespace {

constexpr std::string_view Vrml1Header = "#VRML V1.0 ascii";
constexpr std::string_view Vrml97Header = "#VRML V2.0 utf8";

/// The maximum decompressed size, against zip bombs.
constexpr std::size_t LargestInflated = std::size_t{256} << 20U;

std::optional<Version> version_of(std::string_view text) {
  if (text.starts_with(grf::ByteOrderMark)) text.remove_prefix(grf::ByteOrderMark.size());
  if (text.starts_with(Vrml1Header)) return Version::Vrml1;
  if (text.starts_with(Vrml97Header)) return Version::Vrml97;
  return std::nullopt;
}

std::string_view what_is_wrong(Inflated::State state) {
  switch (state) {
    case Inflated::State::CutOff:
      return "the compressed file is truncated";
    case Inflated::State::Damaged:
      return "the compressed file is damaged";
    case Inflated::State::TooLarge:
      return "the compressed file unpacks to more than 256 MB: unpack it first";
    case Inflated::State::Whole:
      break;
  }
  return {};
}

bool is_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

}  // namespace

void Source::Place::pass(std::string_view text) {
  for (const char c : text) {
    if (c == '\n') {
      ++line;
      column = 1;
    } else if (is_character(c)) {
      ++column;
    }
  }
}

Source::Source(std::shared_ptr<const std::string> text, std::shared_ptr<const grf::SourceFile> file,
               Version version, bool is_compressed)
    : text_(std::move(text)), file_(std::move(file)), version_(version), is_compressed_(is_compressed) {
  Place place;
  for (std::string_view rest = *text_;;) {
    checkpoints_.push_back(place);
    if (rest.size() < CheckpointDistance) break;
    place.pass(rest.substr(0, CheckpointDistance));
    rest.remove_prefix(CheckpointDistance);
  }
}

grf::SourceLocation Source::location(std::size_t offset) const {
  const std::size_t checkpoint = offset / CheckpointDistance;
  Place place = checkpoints_[checkpoint];
  place.pass(text().substr(checkpoint * CheckpointDistance, offset % CheckpointDistance));
  return {file_, place.line, place.column};
}

bool sniff(std::string_view first_bytes) {
  constexpr std::size_t Enough = 64;
  if (!is_gzip(first_bytes)) return version_of(first_bytes).has_value();
  return version_of(inflate_gzip(first_bytes, Enough).text).has_value();
}

std::shared_ptr<const Source> read_source(const std::string& path, const grf::SourceLocation& asked_for_at,
                                          grf::Diagnostics& diagnostics) {
  const auto bytes = grf::read_file(path, diagnostics, asked_for_at);
  return bytes ? make_source(*bytes, path, asked_for_at, diagnostics) : nullptr;
}

std::shared_ptr<const Source> make_source(std::string_view bytes, const std::string& path,
                                          const grf::SourceLocation& asked_for_at,
                                          grf::Diagnostics& diagnostics) {
  const auto fail = [&](std::string_view message) {
    diagnostics.error({std::make_shared<grf::SourceFile>(grf::SourceFile{path, asked_for_at, {}}), 0, 0},
                      message);
    return nullptr;
  };
  if (bytes.empty()) return fail("the file is empty, expected a VRML world");
  std::string inflated;
  const bool is_compressed = is_gzip(bytes);
  if (is_compressed) {
    Inflated result = inflate_gzip(bytes, LargestInflated);
    if (result.state != Inflated::State::Whole) return fail(what_is_wrong(result.state));
    if (result.rest > 0) {
      return fail(fmt::format("{} the end of the compressed file",
                              counted(result.rest, "byte follows", "bytes follow")));
    }
    inflated = std::move(result.text);
    bytes = inflated;
  }
  auto text = std::make_shared<const std::string>(to_utf8(bytes));
  const auto version = version_of(*text);
  if (!version) {
    return fail(
        fmt::format("this is not VRML: expected '{}' or '{}' in the first line", Vrml97Header, Vrml1Header));
  }
  if (text->find('\0') != std::string::npos) return fail("there are zero bytes in the file, which is text");
  auto file = std::make_shared<grf::SourceFile>(grf::SourceFile{path, asked_for_at, text});
  return std::make_shared<const Source>(std::move(text), std::move(file), *version, is_compressed);
}

}  // namespace convert::vrml
