#include "converters/vrml/gzip.h"

#include <algorithm>
#include <array>
#include <new>

#include <zlib.h>

namespace convert::vrml {
namespace {

constexpr std::string_view Magic = "\x1F\x8B";

/// An RAII wrapper of a zlib stream.
class Stream {
 public:
  explicit Stream(std::string_view bytes) : bytes_(bytes) {
    constexpr int GzipAlone = 16;
    if (inflateInit2(&stream_, MAX_WBITS + GzipAlone) != Z_OK) throw std::bad_alloc();
  }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  ~Stream() { inflateEnd(&stream_); }

  /// Appends the next decompressed part to the text, and returns zlib's code.
  int next(std::string& text) {
    feed();
    std::array<char, std::size_t{1} << 16U> part;
    stream_.next_out = reinterpret_cast<Bytef*>(part.data());
    stream_.avail_out = static_cast<uInt>(part.size());
    const int code = inflate(&stream_, Z_NO_FLUSH);
    text.append(part.data(), part.size() - stream_.avail_out);
    return code;
  }

  /// Continues with the next member of the file (RFC 1952, section 2.2); returns false if there is none.
  bool next_member() {
    feed();
    const std::string_view rest(reinterpret_cast<const char*>(stream_.next_in), stream_.avail_in);
    return is_gzip(rest) && inflateReset(&stream_) == Z_OK;
  }

  /// Returns the number of unread bytes after zero padding, which archives have.
  std::size_t rest() const {
    const std::string_view fed(reinterpret_cast<const char*>(stream_.next_in), stream_.avail_in);
    const std::size_t zeros = std::min(fed.find_first_not_of('\0'), fed.size());
    return fed.size() - zeros + bytes_.size();
  }

 private:
  // The input is passed in chunks, since zlib has 32-bit sizes.
  void feed() {
    if (stream_.avail_in > 0) return;
    constexpr std::size_t LargestPart = std::size_t{1} << 30U;
    const std::string_view part = bytes_.substr(0, LargestPart);
    bytes_.remove_prefix(part.size());
    stream_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(part.data()));
    stream_.avail_in = static_cast<uInt>(part.size());
  }

  z_stream stream_ = {};
  std::string_view bytes_;
};

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with(Magic); }

Inflated inflate_gzip(std::string_view bytes, std::size_t most_bytes) {
  using State = Inflated::State;
  Inflated inflated;
  const auto ended = [&inflated](State state) {
    inflated.state = state;
    return std::move(inflated);
  };
  Stream stream(bytes);
  for (;;) {
    const int code = stream.next(inflated.text);
    if (inflated.text.size() > most_bytes) {
      inflated.text.resize(most_bytes);
      return ended(State::TooLarge);
    }
    if (code == Z_STREAM_END) {
      if (stream.next_member()) continue;
      inflated.rest = stream.rest();
      return ended(State::Whole);
    }
    if (code == Z_BUF_ERROR) return ended(State::CutOff);
    if (code != Z_OK) return ended(State::Damaged);
  }
}

}  // namespace convert::vrml
