// Evaluates the fit of Oren and Nayar 1994 (equations 31 to 34), with interreflection. Sines and tangents
// come from the directions' components, and factors that vanish at grazing from the elevation: tan(beta) is
// multiplied by it.
vec3 oren(vec3 u, vec3 v, real s, vec3 r) {
  if (below_horizon(u, v)) return vec3(0);
  real su = sqrt(u.x * u.x + u.y * u.y);
  real sv = sqrt(v.x * v.x + v.y * v.y);
  bool u_is_lower = su * v.z > sv * u.z;
  real sine_alpha = u_is_lower ? su : sv;
  real cosine_alpha = u_is_lower ? u.z : v.z;
  real sine_beta = u_is_lower ? sv : su;
  real cosine_beta = u_is_lower ? v.z : u.z;
  // The cosine of the azimuths' difference, and 1 minus its magnitude. At the normal it is undefined and beta
  // = 0 cancels it.
  real scale = su * sv;
  real cp = scale > real(1e-30f) ? max(real(-1), min(real(1), (u.x * v.x + u.y * v.y) / scale)) : real(0);
  real sp = scale > real(1e-30f) ? (u.x * v.y - u.y * v.x) / scale : real(1);
  real one_minus_cp = min(real(1), sp * sp / (1 + abs(cp)));
  real alpha = atan2(sine_alpha, cosine_alpha) * (2 / PI);
  real over_horizon = atan2(cosine_beta, sine_beta) * (2 / PI);
  real beta = 1 - over_horizon;
  real s2 = s * s;
  real c1 = 1 - s2 / (2 * (s2 + real(0.33)));
  real q = s2 / (s2 + real(0.09));
  // sin(alpha) - (2 beta/pi)^3, computed from 1 minus each.
  real back = sine_alpha;
  if (cp < 0) {
    back = over_horizon * (3 + over_horizon * (over_horizon - 3)) -
           cosine_alpha * cosine_alpha / (1 + sine_alpha);
  }
  real c2 = real(0.45) * q * back;
  real ab = alpha * beta;
  real c3 = real(0.125) * q * ab * ab;
  real direct = c1 + cp * c2 * (sine_beta / cosine_beta) + one_minus_cp * c3 * ((su + sv) / (u.z + v.z));
  real between_facets = real(0.17) * s2 / (s2 + real(0.13)) * (1 - cp * beta * beta);
  return bounded(r / PI * (vec3(direct) + r * between_facets));
}
