// Wave optics of a Gaussian rough surface (He, Torrance, Sillion and Greenberg 1991), shared by `he` and
// `westin`. Heights and lengths are in micrometres, wavelengths in nanometres.

// Solves w + log(w) = x for w > 0, Lambert's W of exp(x). Newton's iterates rise to it from below.
real lambert_w(real x) {
  if (x < -40) return exp(x);
  real w = x > 1 ? x - log(x) : exp(x - 1);
  for (int i = 0; i < 8; ++i) {
    real next = w * (1 + x - log(w)) / (1 + w);
    bool is_near = abs(next - w) <= real(1e-7) * next;
    w = next;
    if (is_near) break;
  }
  return w;
}

// Returns lgamma(m + 1) minus Stirling's approximation. The series is accurate to 1e-13 from 10 on.
real stirling_error(real m) {
  real shift = real(0);
  while (m < 10) {
    shift += (m + real(0.5)) * log1p(1 / m) - 1;
    m += 1;
  }
  real x2 = 1 / (m * m);
  real series = 1 / real(1260) - x2 * (1 / real(1680) - x2 / real(1188));
  return shift + (1 / real(12) - x2 * (1 / real(360) - x2 * series)) / m;
}

// Returns m log(m/g) + g - m, where `excess` is g - m (Loader 2000, "Fast and accurate computation of
// binomial probabilities"). Near m = g by the series of r - log(1 + r), r = excess / m.
real poisson_deviance(real m, real g, real excess) {
  real r = excess / m;
  if (r < real(-0.5)) return m * log(m / g) + excess;
  if (abs(r) > real(0.2)) return m * (r - log1p(r));
  real s = r / (2 + r);
  real s2 = s * s;
  real series = 1 / real(9) + s2 * (1 / real(11) + s2 * (1 / real(13) + s2 / real(15)));
  series = 1 / real(3) + s2 * (1 / real(5) + s2 * (1 / real(7) + s2 * series));
  return excess * s - 2 * m * s * s2 * series;
}

// Returns a term g^m e^-g / (m! m) e^(-b/m) for any real m >= 1.
real kirchhoff_term(real m, real g, real b, real excess) {
  real exponent = poisson_deviance(m, g, excess) + b / m + stirling_error(m);
  return exp(-exponent) / (sqrt(2 * PI * m) * m);
}

// Sums from the largest term both ways, by the ratios of neighbours.
real sum_of_all_terms(real g, real b, real centre) {
  real largest = kirchhoff_term(centre, g, b, g - centre);
  real sum = largest;
  real term = largest;
  for (real m = centre; 16 * term > EPSILON * sum; m += 1) {
    term *= g * m / ((m + 1) * (m + 1)) * exp(b / (m * (m + 1)));
    sum += term;
  }
  term = largest;
  for (real m = centre; m > real(1.5) && 16 * term > EPSILON * sum; m -= 1) {
    term *= m * m / (g * (m - 1)) * exp(-b / (m * (m - 1)));
    sum += term;
  }
  return sum;
}

// Sums every step-th term times the step, as the terms are smooth in m over many m: the trapezoidal rule,
// exact to exp(-2 (pi width / step)^2), at a cost independent of g.
real sum_of_some_terms(real g, real b, real centre, real excess, real step) {
  real sum = kirchhoff_term(centre, g, b, excess);
  real term = sum;
  for (real x = step; 16 * term > EPSILON * sum; x += step) {
    term = kirchhoff_term(centre + x, g, b, excess - x);
    sum += term;
  }
  term = sum;
  for (real x = step; x < centre && 16 * term > EPSILON * sum; x += step) {
    term = kirchhoff_term(centre - x, g, b, excess + x);
    sum += term;
  }
  return sum * step;
}

// Returns the sum over m >= 1 of g^m e^-g / (m! m) e^(-b/m). The largest term is where m^2 log(m/g) = b.
real kirchhoff_sum(real g, real b) {
  if (!(g > real(1e-30))) return real(0);
  real y = b > real(1e-30) ? lambert_w(log(2 * b) - 2 * log(g)) / 2 : real(0);
  real centre = y > 1 ? sqrt(b / y) : g * exp(y);
  real place = max(real(1), centre);
  real width = place * sqrt(place / (place * place + 2 * b));
  if (width < 6) return sum_of_all_terms(g, b, floor(place));
  real excess = y > 1 ? g - centre : -g * expm1(y);
  return sum_of_some_terms(g, b, centre, excess, floor(real(0.8) * width));
}

// Returns the paper's shadowing over the cosine, S(w) / w.z: its Lambda has no exp(-x^2), as published.
real kirchhoff_shadowing_over_cosine(vec3 w, real sigma, real tau) {
  real sine = sqrt(w.x * w.x + w.y * w.y);
  real k = real(1.7724538509055160) * tau *
           (2 - erfc(min(tau * w.z / max(2 * sigma * sine, real(1e-30)), real(30))));
  return k / (k * w.z + 2 * sigma * sine);
}

// Returns the directional-diffuse part for one wavelength, D / pi without Fresnel, shadowing and geometry.
real kirchhoff_lobe(vec3 s, real sigma, real tau, real lambda) {
  real height = 2000 * PI * sigma / lambda * s.z;
  real length = 1000 * PI * tau / lambda;
  return length * length / (4 * PI) *
         kirchhoff_sum(height * height, length * length * (s.x * s.x + s.y * s.y));
}

vec3 kirchhoff(vec3 u, vec3 v, real sigma, real effective_sigma, real tau, vec3 lambda, real nreal,
               real nimag, vec3 ks, vec3 kd) {
  vec3 s = u + v;
  vec3 lobe = vec3(kirchhoff_lobe(s, effective_sigma, tau, lambda.x));
  if (lambda.y != lambda.x) lobe.y = kirchhoff_lobe(s, effective_sigma, tau, lambda.y);
  if (lambda.z != lambda.x) lobe.z = kirchhoff_lobe(s, effective_sigma, tau, lambda.z);
  // 4 (c/hz)^2 is split over the shadowing factors. The larger comes first, as the whole might overflow; the
  // same order for both ways keeps the model reciprocal down to denormal values.
  real geometry = (s.x * s.x + s.y * s.y + s.z * s.z) / s.z;
  real to_u = kirchhoff_shadowing_over_cosine(u, sigma, tau) * geometry;
  real to_v = kirchhoff_shadowing_over_cosine(v, sigma, tau) * geometry;
  lobe *= fresnel_at_half(u, v, nreal, nimag) * max(to_u, to_v);
  return bounded(ks * (lobe * min(to_u, to_v)) + kd / PI);
}

// Returns the weight of the delta part.
vec3 kirchhoff_specular(vec3 u, real sigma, real effective_sigma, real tau, vec3 lambda, real nreal, real nimag,
                      vec3 ks) {
  if (below_horizon(u, u)) return vec3(0);
  real shadowing = u.z * kirchhoff_shadowing_over_cosine(u, sigma, tau);
  real height = 4000 * PI * effective_sigma * u.z;
  vec3 phase = vec3(height / lambda.x, height / lambda.y, height / lambda.z);
  vec3 coherent = vec3(exp(-phase.x * phase.x), exp(-phase.y * phase.y), exp(-phase.z * phase.z));
  return ks * coherent * (fresnel(u.z, nreal, nimag) * shadowing * shadowing);
}
