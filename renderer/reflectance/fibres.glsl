// Evaluates the sheen of a layer of fibres, which scatters light many times, by a linearly transformed cosine
// (LTC; Zeltner, Burley and Chiang 2022), whose tables are fitted by functions (MaterialX 1.39, Hill).

// Returns the directional albedo for the cosine of the view's angle.
real sheen_albedo(real c, real rough) {
  real width =
      rough * (real(0.0206607f) + real(1.58491f) * rough) / (real(0.0379424f) + rough * (real(1.32227f) + rough));
  real cubic = real(1.7932f) - real(0.95943f) * rough * rough;
  real centre = rough * (real(-0.193854f) + rough * (real(-1.14885f) + rough * cubic)) / (real(0.046391f) + rough);
  real base = rough * (real(0.000654023f) + (real(-0.0207818f) + real(0.119681f) * rough) * rough) /
              (real(1.26264f) + rough * (real(-1.92021f) + rough));
  real place = (c - centre) / width;
  return min(real(1), max(real(0), exp(-place * place / 2) / (width * real(2.5066283f)) + base));
}

// Returns the two numbers of the inverse transformation: the scale of x and y, and the shear of x by z, over the
// sine of the view's angle. x is the view's azimuth.
real sheen_scale(real c, real rough) {
  return (real(2.58126f) * c + real(0.813703f) * rough) * rough /
         (1 + real(0.310327f) * c * c + real(2.60994f) * c * rough);
}
real sheen_shear(real c, real rough) {
  real cube = rough * rough * rough;
  return (rough - 1) * cube /
         ((real(0.0000254053f) + real(1.71228f) * c - real(1.71506f) * c * rough + real(1.34174f) * rough * rough) *
          sqrt(1 + c));
}

// Returns the pdf of the transformed cosine, over the cosine of v.
real sheen_lobe(vec3 u, vec3 v, real rough) {
  real scale = sheen_scale(u.z, rough);
  real shear = sheen_shear(u.z, rough);
  real along = u.x * v.x + u.y * v.y;
  real sheared = shear * shear * (u.x * u.x + u.y * u.y);
  real length2 = scale * scale * (v.x * v.x + v.y * v.y) + v.z * (2 * scale * shear * along + v.z * (1 + sheared));
  real stretch = scale / length2;
  return stretch * stretch / PI;
}
