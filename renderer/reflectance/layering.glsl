// Functions of models that are made of layers and of mixtures.

// Returns what is between two values. Where the second one has all weight, no digits of a dark colour are lost.
vec3 mixed(vec3 first, vec3 second, real weight) {
  return first * (1 - weight) + second * weight;
}

real largest_channel(vec3 colour) { return max(colour.x, max(colour.y, colour.z)); }

// Returns the part of light that a layer transmits to what is below it, by its albedos at u and at v: the same
// for both directions, and never more than what it does not reflect.
real layer_below(real albedo_u, real albedo_v) { return 1 - min(real(1), max(albedo_u, albedo_v)); }

// The places and weights of a rule for means over the hemisphere, weighted by the cosine: that of Gauss and Jacobi.
vec3 hemisphere_cosines() { return vec3(0.21234054f, 0.59053314f, 0.91141204f); }
vec3 hemisphere_weights() { return vec3(0.13965396f, 0.45848221f, 0.40186383f); }
