#define POLYLAP_LANES 2
#define POLYLAP_TILE_VECTORS 2
#define POLYLAP_TILE_COLUMNS 4
#include "solve/dense/kernels_body.inc"

namespace polylap::dense {

extern const Kernels kernels_baseline;
const Kernels kernels_baseline{"baseline", factor, downdate, forward, backward, scratch_doubles};

}  // namespace polylap::dense
