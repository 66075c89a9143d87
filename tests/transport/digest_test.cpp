#include "renderer/transport/digest.h"

#include <gtest/gtest.h>

namespace {

using transport::digest_of;
using transport::digest_of_hex;
using transport::extended;
using transport::hex;

// NIST, "Secure Hash Standard", FIPS 180-4: examples of SHA-256.
constexpr const char* OfAbc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
constexpr const char* OfNothing = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
constexpr const char* OfTwoBlocks = "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1";
constexpr const char* TwoBlocks = "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq";

TEST(Digest, IsSha256) {
  EXPECT_EQ(hex(digest_of("abc")), OfAbc);
  EXPECT_EQ(hex(digest_of("")), OfNothing);
  EXPECT_EQ(hex(digest_of(TwoBlocks)), OfTwoBlocks);
}

TEST(Digest, OfPiecesIsThatOfTheWhole) {
  const std::string_view all = TwoBlocks;
  for (std::size_t size = 0; size <= all.size(); ++size) {
    transport::DigestBuilder builder;
    builder.add(all.substr(0, size)).add(all.substr(size));
    EXPECT_EQ(hex(builder.digest()), OfTwoBlocks) << size;
  }
}

TEST(Digest, IsExtendedByWhatFollowsItsBytes) {
  const transport::Digest abc = digest_of("abc");
  const std::string bytes(abc.begin(), abc.end());
  EXPECT_EQ(extended(abc, "more"), digest_of(bytes + "more"));
  EXPECT_NE(extended(abc, ""), abc);
}

TEST(Digest, IsReadFromItsDigits) {
  EXPECT_EQ(digest_of_hex(OfAbc), digest_of("abc"));
  const std::string digits = OfAbc;
  for (const std::string& wrong : {std::string(), digits.substr(1), digits + "0", "g" + digits.substr(1),
                                   "+" + digits.substr(1), "B" + digits.substr(1)}) {
    EXPECT_FALSE(digest_of_hex(wrong)) << wrong;
  }
}

}  // namespace
