// Elementary functions in float that are the same to the last bits in GLSL and in C++. A driver's log and
// pow may be off by several per cent near 1, which is where lobes are narrow.

// log(1 + x) for x > -1, within 2 units in the last place: 1 + x = 2^e (1 + f) with 1 + f from sqrt(1/2) to
// sqrt(2), and log(1 + f) = 2 atanh(f / (2 + f)). Where e is 0, f is x itself and no digit is lost.
real log1p_of(real x) {
  real y = 1.0f + x;
  int e = (floatBitsToInt(y) - 0x3f3504f3) >> 23;
  real f = e == 0 ? x : intBitsToFloat(floatBitsToInt(y) - e * 0x00800000) - 1.0f;
  real s = f / (2.0f + f);
  real s2 = s * s;
  real series = s2 * (0.33333333333f + s2 * (0.2f + s2 * (0.14285714286f + s2 * 0.11111111111f)));
  return real(e) * 0.69314718056f + 2.0f * (s + s * series);
}
