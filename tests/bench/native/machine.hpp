#pragma once

#include <ostream>
#include <vector>

#include "harness.hpp"

namespace polylap::bench {

/// {"machine": what it was measured on and with, "rows": [one object per line]}
void write_json(const std::vector<Row>& rows, std::ostream& out);

}  // namespace polylap::bench
