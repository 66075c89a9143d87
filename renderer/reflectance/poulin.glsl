// Parallel cylinders of radius 1 along x, their centres d apart, over a floor h above the centres. Functions
// work in the cross-section: a direction has its elevation there, a point of a cylinder its angle a from the
// normal.

// The part of a cylinder and its floor visible from a direction.
struct Seen {
  real low;
  real high;
  real hidden;
};

// Half a cylinder's width above the floor, the steepest angle of its arc, and the floor's width.
real cylinder_width(real h) { return sqrt((1 - h) * (1 + h)); }
real steepest(real d, real h) {
  real width = cylinder_width(h);
  return width < d / 2 ? atan2(width, h) : atan2(d / 2, sqrt((1 - d / 2) * (1 + d / 2)));
}
real floor_width(real d, real h) { return max(real(0), d - 2 * cylinder_width(h)); }
bool is_plane(real d, real h) { return d < real(1e-6) || cylinder_width(h) < real(1e-6); }

// Computes visibility for a direction with y > 0; the other side is its mirror image. Below the steepest
// slope the neighbour hides the arc from the angle psi - asin(1 - d cos(psi)) on, psi being the direction's
// own. All is written with the elevation pi/2 - psi, so that the short arcs near the horizon keep their
// digits.
Seen seen_from_right(real y, real z, real d, real h) {
  real slope = steepest(d, h);
  real elevation = atan2(z, y);
  Seen seen;
  seen.low = max(-slope, -elevation);
  seen.high = slope;
  seen.hidden = real(0);
  if (elevation >= slope) return seen;
  real radius = sqrt(y * y + z * z);
  real clearance = min(real(1), d * z / (2 * radius));
  real edge = 2 * atan2(sqrt(clearance), sqrt(1 - clearance)) - elevation;
  seen.high = max(seen.low, min(slope, edge));
  // (radius - h y) / z, minus half the width.
  real hidden = z / (radius + y) + (1 - h) * y / z - cylinder_width(h);
  seen.hidden = min(floor_width(d, h), max(real(0), hidden));
  return seen;
}
Seen seen_from(vec3 w, real d, real h) {
  Seen seen = seen_from_right(abs(w.y), w.z, d, h);
  if (w.y < 0) {
    real low = -seen.high;
    seen.high = -seen.low;
    seen.low = low;
  }
  return seen;
}

// Returns the floor length both visible and lit: shadows on the same side overlap, on opposite ones add.
real floor_in_common(vec3 u, vec3 v, real hidden_u, real hidden_v, real d, real h) {
  real hidden = u.y * v.y > 0 ? max(hidden_u, hidden_v) : hidden_u + hidden_v;
  return max(real(0), floor_width(d, h) - hidden);
}

// Returns sin(x) - x.
real sine_excess(real x) {
  if (abs(x) > 1) return sin(x) - x;
  real x2 = x * x;
  real series = 1 - x2 / 110 * (1 - x2 / 156 * (1 - x2 / 210));
  return -x * x2 / 6 * (1 - x2 / 20 * (1 - x2 / 42 * (1 - x2 / 72 * series)));
}

// Integrates (u.m)(v.m) over an arc of normals m, in closed form.
real arc_projected(vec3 u, vec3 v, real low, real high) {
  real length = max(real(0), high - low);
  real s = sin((low + high) / 2);
  real c = cos((low + high) / 2);
  real um = u.y * s + u.z * c;
  real vm = v.y * s + v.z * c;
  real across = (u.y * c - u.z * s) * (v.y * c - v.z * s);
  return max(real(0), length * um * vm + sine_excess(length) / 2 * (um * vm - across));
}

// An integrand over an arc, (u.m)(v.m)(m.h)^n, of the angle x from one of its points: u.m is u.x cos(x) + u.y
// sin(x) and v.m that of v plus v.z. m.h is that of h; where it is near 1 it comes from the half vector's
// angle from that point, whose half has the tangent -offset.
struct ArcLobe {
  vec2 u;
  vec3 v;
  vec2 h;
  real n;
  real offset;
  real centre;
  real extent;
};

// Evaluates at t = tan(x/2), which needs no trigonometry, with dx = 2 dt / (1 + t^2).
real arc_lobe_at(ArcLobe arc, real t) {
  real q = 1 / (1 + t * t);
  real c = 1 - 2 * t * t * q;
  real s = 2 * t * q;
  real from_half = t + arc.offset;
  real one_minus_cos = 2 * from_half * from_half * q / (1 + arc.offset * arc.offset);
  real projected =
      max(real(0), arc.u.x * c + arc.u.y * s) * max(real(0), arc.v.x * c + arc.v.y * s + arc.v.z);
  real log_lobe =
      one_minus_cos < real(0.5) ? log1p(-one_minus_cos) : log(max(real(1e-30f), arc.h.x * c + arc.h.y * s));
  return projected * exp(arc.n * log_lobe) * 2 * q;
}
real arc_lobe_pair(ArcLobe arc, real place, real weight) {
  real x = arc.extent * place;
  return weight * (arc_lobe_at(arc, arc.centre - x) + arc_lobe_at(arc, arc.centre + x));
}

// Integrates by 32-point Gauss-Legendre quadrature.
real arc_lobe_integral(ArcLobe arc) {
  return arc.extent * (arc_lobe_pair(arc, real(0.0483076656877383162), real(0.0965400885147278006)) +
                       arc_lobe_pair(arc, real(0.1444719615827964934), real(0.0956387200792748594)) +
                       arc_lobe_pair(arc, real(0.2392873622521370745), real(0.0938443990808045654)) +
                       arc_lobe_pair(arc, real(0.3318686022821276497), real(0.0911738786957638847)) +
                       arc_lobe_pair(arc, real(0.4213512761306353454), real(0.0876520930044038111)) +
                       arc_lobe_pair(arc, real(0.5068999089322293900), real(0.0833119242269467552)) +
                       arc_lobe_pair(arc, real(0.5877157572407623290), real(0.0781938957870703065)) +
                       arc_lobe_pair(arc, real(0.6630442669302152009), real(0.0723457941088485062)) +
                       arc_lobe_pair(arc, real(0.7321821187402896804), real(0.0658222227763618468)) +
                       arc_lobe_pair(arc, real(0.7944837959679424069), real(0.0586840934785355471)) +
                       arc_lobe_pair(arc, real(0.8493676137325699701), real(0.0509980592623761762)) +
                       arc_lobe_pair(arc, real(0.8963211557660521240), real(0.0428358980222266807)) +
                       arc_lobe_pair(arc, real(0.9349060759377396892), real(0.0342738629130214331)) +
                       arc_lobe_pair(arc, real(0.9647622555875064308), real(0.0253920653092620595)) +
                       arc_lobe_pair(arc, real(0.9856115115452683354), real(0.0162743947309056706)) +
                       arc_lobe_pair(arc, real(0.9972638618494815635), real(0.0070186100094700966)));
}

// Returns the tangent of half an angle within pi/2.
real half_tangent(real x) { return sin(x) / (1 + cos(x)); }

// Integrates (u.m)(v.m)(m.h)^n over an arc, clipped to where the lobe exceeds 1e-10 of its peak; with `once`,
// (u.m)(m.h)^n. Angles are from the arc's point nearest to h, which keeps the digits of arcs that are short
// or have narrow lobes.
real arc_lobe(vec3 u, vec3 v, real low, real high, real n, bool once) {
  vec3 h = u + v;
  real radius2 = h.y * h.y + h.z * h.z;
  real psi = atan2(h.y, h.z);
  real reach = PI / 2;
  if (n > 1) reach = atan2(sqrt(-expm1(real(-46.051701859880914) / n)), exp(real(-23.025850929940457) / n));
  real near = min(max(psi, low), high);
  real first = half_tangent(max(low - near, psi - near - reach));
  real last = half_tangent(min(high - near, psi - near + reach));
  if (!(first < last)) return real(0);
  real s = sin(near);
  real c = cos(near);
  ArcLobe arc;
  arc.u = vec2(u.y * s + u.z * c, u.y * c - u.z * s);
  arc.v = once ? vec3(0, 0, 1) : vec3(v.y * s + v.z * c, v.y * c - v.z * s, 0);
  arc.h = vec2(h.y * s + h.z * c, h.y * c - h.z * s) / sqrt(radius2);
  arc.n = n;
  arc.offset = half_tangent(near - psi);
  arc.centre = (first + last) / 2;
  arc.extent = (last - first) / 2;
  return exp(-n / 2 * log1p(h.x * h.x / radius2)) * arc_lobe_integral(arc);
}

vec3 poulin(vec3 u, vec3 v, real d, real h, real n, vec3 ks, vec3 kd) {
  if (below_horizon(u, v)) return vec3(0);
  real scale = half_power_scale(n);
  real plane = 1;
  real arc_lobes = 0;
  real arc_diffuse = 0;
  if (!is_plane(d, h)) {
    Seen a = seen_from(u, d, h);
    Seen b = seen_from(v, d, h);
    real low = max(a.low, b.low);
    real high = min(a.high, b.high);
    real area = d * u.z * v.z;
    arc_diffuse = arc_projected(u, v, low, high) / area;
    arc_lobes = low < high ? arc_lobe(u, v, low, high, n, false) / area : real(0);
    plane = floor_in_common(u, v, a.hidden, b.hidden, d, h) / d;
  }
  return bounded(kd / PI * (arc_diffuse + plane) + ks * (scale * (arc_lobes + plane * half_power(u, v, n))));
}
