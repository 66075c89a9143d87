// Elementary functions in float that agree to the last bits in GLSL and C++. A driver's log and pow may be
// off by several per cent near 1, which matters for narrow lobes.

// Returns log(2^e (1 + f)), for 1 + f from sqrt(1/2) to sqrt(2): log(1 + f) = 2 atanh(f / (2 + f)).
real log_of_parts(int e, real f) {
  real s = f / (2.0f + f);
  real s2 = s * s;
  real series = s2 * (0.33333333333f + s2 * (0.2f + s2 * (0.14285714286f + s2 * 0.11111111111f)));
  return real(e) * 0.69314718056f + 2.0f * (s + s * series);
}

// log(x) for x > 0 that is not denormal.
real log_of(real x) {
  int e = (floatBitsToInt(x) - 0x3f3504f3) >> 23;
  return log_of_parts(e, intBitsToFloat(floatBitsToInt(x) - e * 0x00800000) - 1.0f);
}

// log(1 + x) for x > -1, within 2 units in the last place: where e is 0, f is x itself and no digit is lost.
real log1p_of(real x) {
  real y = 1.0f + x;
  int e = (floatBitsToInt(y) - 0x3f3504f3) >> 23;
  return log_of_parts(e, e == 0 ? x : intBitsToFloat(floatBitsToInt(y) - e * 0x00800000) - 1.0f);
}

// exp(x) - 1: Taylor's series where the difference would cancel.
real expm1_of(real x) {
  if (abs(x) > 0.5f) return exp(x) - 1.0f;
  real series = 1.0f + x * 0.14285714286f * (1.0f + x * 0.125f);
  series = 1.0f + x * 0.2f * (1.0f + x * 0.16666666667f * series);
  return x * (1.0f + x * 0.5f * (1.0f + x * 0.33333333333f * (1.0f + x * 0.25f * series)));
}

// erfc(x) for x >= 0, within 1e-6 of its value: exp(-x^2) t P(t) with t = 1/(1 + x/2), and P fitted to
// exp(x^2) erfc(x) / t at Chebyshev's nodes.
real erfc_of(real x) {
  real t = 1.0f / (1.0f + 0.5f * x);
  real p = 0.090150443956f + t * (0.031957471514f - t * 0.018130735876f);
  p = 0.047112954871f + t * (0.112794144369f + t * (-0.256913428409f + t * p));
  p = 0.282111737043f + t * (0.246313834063f + t * (0.182508822202f + t * p));
  return exp(-x * x) * t * (0.282094685014f + t * p);
}

// The angle of the point (x, y), within 2e-7 of its value; a polynomial fitted to atan(z)/z in z^2.
real atan2_of(real y, real x) {
  real low = min(abs(x), abs(y));
  real high = max(abs(x), abs(y));
  real z = low / max(high, 1e-37f);
  real s = z * z;
  real p = 0.0421376235891f + s * (-0.0157312491221f + s * 0.00276628350175f);
  p = -0.141977977941f + s * (0.10618370637f + s * (-0.07456854826f + s * p));
  p = 0.999999981789f + s * (-0.333330367093f + s * (0.199918720291f + s * p));
  real angle = z * p;
  if (abs(y) > abs(x)) angle = 1.57079632679f - angle;
  if (x < 0) angle = 3.14159265359f - angle;
  return y < 0 ? -angle : angle;
}

// sin and cos of an angle up to pi/4 by their series.
real sin_series(real x) {
  real s = x * x;
  return x + x * s * (-0.16666666667f + s * (0.0083333333333f + s * (-0.00019841269841f + s * 2.7557319224e-6f)));
}
real cos_series(real x) {
  real s = x * x;
  real p = -0.0013888888889f + s * (0.000024801587302f - s * 2.7557319224e-7f);
  return 1.0f - s * (0.5f - s * (0.041666666667f + s * p));
}

// sin(x + turns pi/2), within 1e-7 of 1 for angles of some turns. pi/2 is in three parts, the first two of few
// digits, so that their products are exact.
real sin_of_parts(real x, int turns) {
  real k = floor(x * 0.63661977237f + 0.5f);
  real r = x - k * 1.5703125f - k * 4.83751296997e-4f - k * 7.54978995489e-8f;
  int quadrant = (int(k) + turns) & 3;
  real size = (quadrant & 1) == 0 ? sin_series(r) : cos_series(r);
  return quadrant < 2 ? size : -size;
}
real sin_of(real x) { return sin_of_parts(x, 0); }
real cos_of(real x) { return sin_of_parts(x, 1); }
