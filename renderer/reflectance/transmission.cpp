#include "renderer/reflectance/transmission.h"

namespace reflectance {

Transmission::Transmission(const Table& table) : table_(table) {
  // The integral of t(c) 2 c dc over each interval, by Simpson's rule, which is exact for linear t.
  for (std::size_t row = 0; row + 1 < Rows; ++row) {
    const float low = cosine(row);
    const float high = cosine(row + 1);
    const float at_low = mean(table_[row]);
    const float at_high = mean(table_[row + 1]);
    const float middle = (low + high) / 2 * (at_low + at_high) / 2;
    mean_ += (high - low) / 3 * (low * at_low + 4 * middle + high * at_high);
  }
}

Transmission Transmission::through(const Transmission& other) const {
  Table table;
  for (std::size_t row = 0; row < Rows; ++row) table[row] = table_[row] * other.table_[row];
  return Transmission(table);
}

}  // namespace reflectance
