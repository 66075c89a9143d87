// Finds the place of a cosine in a table of what a layer transmits, whose rows are denser towards grazing: the row
// below it, of 16, and the fraction of the way to the next.
int transmission_row(real c) {
  int row = int(sqrt(max(c, real(0))) * 16);
  return row > 15 ? 15 : row;
}
real transmission_fraction(real c, int row) { return (c * 256 - real(row * row)) / real(2 * row + 1); }
