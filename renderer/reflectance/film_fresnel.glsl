// Evaluates what facets reflect under a thin film, by the interference of the light that both of its sides reflect
// (Airy's sum), for unpolarised light at 28 wavelengths.
//
// Drivers inline each call of `film_reflectance`, and then take a second to compile it: models call it in loops over
// angles and bases, and not once for each.

// The reflection of one polarisation: its amplitudes at the film's front, and at the base by channel.
struct FilmSides {
  real front;
  vec3 base_real;
  vec3 base_imaginary;
};

// Returns the amplitude (a - b)/(a + b) of complex a and b: its real and its imaginary part.
vec3 film_amplitude(real a, real a_imaginary, real b, real b_imaginary) {
  real sum = a + b;
  real sum_imaginary = a_imaginary + b_imaginary;
  real square = sum * sum + sum_imaginary * sum_imaginary;
  if (!(square > 0)) return vec3(0);
  real difference = a * a - b * b + (a_imaginary * a_imaginary - b_imaginary * b_imaginary);
  return vec3(difference / square, 2 * (a_imaginary * b - a * b_imaginary) / square, 0);
}

// Returns the amplitudes at the base for one channel: of s- and, if `is_p`, p-polarised light that the film
// refracts; `normal` is the film's index times the cosine in it.
vec3 film_base(real c, real s2, real normal, real film, real n, real k, bool is_p) {
  vec3 root = fresnel_root(c, s2, n, k);
  if (!is_p) return film_amplitude(normal, real(0), root.x, root.y);
  real film2 = film * film;
  return film_amplitude((n - k) * (n + k) * normal, 2 * n * k * normal, film2 * root.x, film2 * root.y);
}

FilmSides film_sides(real c, real s2, real normal, real film, vec3 n, vec3 k, bool is_p) {
  real film2 = is_p ? film * film : real(1);
  vec3 red = film_base(c, s2, normal, film, n.x, k.x, is_p);
  vec3 green = film_base(c, s2, normal, film, n.y, k.y, is_p);
  vec3 blue = film_base(c, s2, normal, film, n.z, k.z, is_p);
  FilmSides sides;
  sides.front = (film2 * c - normal) / (film2 * c + normal);
  sides.base_real = vec3(red.x, green.x, blue.x);
  sides.base_imaginary = vec3(red.y, green.y, blue.y);
  return sides;
}

// Returns the reflectance where light that crosses the film to and fro is late by a phase of this cosine and
// sine. Both sides of the quotient are sums of squares; where they vanish, nearly perfect mirrors resonate.
real film_quotient(real front, real late_real, real late_imaginary) {
  real sum = front + late_real;
  real product = 1 + front * late_real;
  real below = product * product + front * front * late_imaginary * late_imaginary;
  return below > 0 ? min(real(1), (sum * sum + late_imaginary * late_imaginary) / below) : real(1);
}
vec3 film_reflected(FilmSides sides, real cosine, real sine) {
  vec3 late_real = sides.base_real * cosine - sides.base_imaginary * sine;
  vec3 late_imaginary = sides.base_real * sine + sides.base_imaginary * cosine;
  return vec3(film_quotient(sides.front, late_real.x, late_imaginary.x),
              film_quotient(sides.front, late_real.y, late_imaginary.y),
              film_quotient(sides.front, late_real.z, late_imaginary.z));
}

vec3 film_wave(real phase, FilmSides s, FilmSides p) {
  real cosine = cos(phase);
  real sine = sin(phase);
  return (film_reflected(s, cosine, sine) + film_reflected(p, cosine, sine)) * real(0.5f);
}

// Returns the weight of a wavelength, of 28, in linear sRGB: numbers from scripts/sum_film_waves.
vec3 film_colour(int i) {
  if (i < 14) {
    if (i < 7) {
      if (i < 3) {
        if (i < 1) {
          return vec3(0.0001216f, 0.0002040f, -0.0000300f);
        }
        if (i < 2) {
          return vec3(0.0026644f, 0.0005895f, -0.0001490f);
        }
        return vec3(0.0198602f, -0.0006338f, -0.0004507f);
      }
      if (i < 5) {
        if (i < 4) {
          return vec3(0.0781874f, -0.0083939f, -0.0010002f);
        }
        return vec3(0.1868877f, -0.0216098f, -0.0021877f);
      }
      if (i < 6) {
        return vec3(0.2933773f, -0.0214271f, -0.0050738f);
      }
      return vec3(0.3162984f, 0.0143935f, -0.0103868f);
    }
    if (i < 10) {
      if (i < 8) {
        return vec3(0.2436705f, 0.0786882f, -0.0168451f);
      }
      if (i < 9) {
        return vec3(0.1362446f, 0.1397412f, -0.0218393f);
      }
      return vec3(0.0345288f, 0.1803871f, -0.0239623f);
    }
    if (i < 12) {
      if (i < 11) {
        return vec3(-0.0394440f, 0.1957460f, -0.0226049f);
      }
      return vec3(-0.0793605f, 0.1856224f, -0.0169283f);
    }
    if (i < 13) {
      return vec3(-0.0843139f, 0.1469716f, -0.0052734f);
    }
    return vec3(-0.0675522f, 0.0956698f, 0.0118991f);
  }
  if (i < 21) {
    if (i < 17) {
      if (i < 15) {
        return vec3(-0.0484770f, 0.0569802f, 0.0337116f);
      }
      if (i < 16) {
        return vec3(-0.0308699f, 0.0306044f, 0.0658041f);
      }
      return vec3(-0.0176870f, 0.0113343f, 0.1132019f);
    }
    if (i < 19) {
      if (i < 18) {
        return vec3(-0.0073340f, -0.0030873f, 0.1595080f);
      }
      return vec3(0.0056279f, -0.0134525f, 0.1769429f);
    }
    if (i < 20) {
      return vec3(0.0153088f, -0.0192221f, 0.1746545f);
    }
    return vec3(0.0171319f, -0.0199934f, 0.1608532f);
  }
  if (i < 24) {
    if (i < 22) {
      return vec3(0.0111844f, -0.0148520f, 0.1220536f);
    }
    if (i < 23) {
      return vec3(0.0080362f, -0.0086234f, 0.0647031f);
    }
    return vec3(0.0046418f, -0.0039446f, 0.0265326f);
  }
  if (i < 26) {
    if (i < 25) {
      return vec3(0.0016347f, -0.0013811f, 0.0100362f);
    }
    return vec3(0.0001258f, -0.0003318f, 0.0041143f);
  }
  if (i < 27) {
    return vec3(-0.0002627f, -0.0000178f, 0.0018566f);
  }
  return vec3(-0.0002312f, 0.0000387f, 0.0008600f);
}

// Returns the reflectance for light at the angle of this cosine and squared sine, of a film this many
// nanometres thick. Colours beyond linear sRGB are clamped.
vec3 film_reflectance(real c, real s2, real thickness, real film, vec3 n, vec3 k) {
  real normal = sqrt((film - 1) * (film + 1) + c * c);
  FilmSides s = film_sides(c, s2, normal, film, n, k, false);
  FilmSides p = film_sides(c, s2, normal, film, n, k, true);
  real path = 4 * PI * thickness * normal;
  real first = path / 720;
  real apart = path * (real(1) / 385 - real(1) / 720) / 27;
  vec3 sum = vec3(0);
  for (int i = 0; i < 28; ++i) sum = sum + film_colour(i) * film_wave(first + apart * real(i), s, p);
  return min(max(sum, real(0)), real(1));
}

// Returns the mean over the hemisphere, weighted by the cosine: by the Gauss-Legendre rule of two values of
// its square.
vec3 film_mean(real thickness, real film, vec3 n, vec3 k) {
  vec3 sum = vec3(0);
  for (int i = 0; i < 2; ++i) {
    bool is_flat = i == 0;
    sum = sum + film_reflectance(is_flat ? real(0.45970084f) : real(0.88807383f),
                                 is_flat ? real(0.78867513f) : real(0.21132487f), thickness, film, n, k);
  }
  return sum * real(0.5f);
}

// Returns the reflectance of a facet that reflects v to u.
vec3 film_at_half(vec3 u, vec3 v, real thickness, real film, vec3 n, vec3 k) {
  return film_reflectance(cosine_at_half(u, v), squared_sine_at_half(u, v), thickness, film, n, k);
}
