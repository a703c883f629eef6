#ifdef POLYLAP_WIDE_KERNELS  // else this machine is no x86-64

#define POLYLAP_LANES 8
#define POLYLAP_TILE_VECTORS 3
#define POLYLAP_TILE_COLUMNS 8
#include "solve/dense/kernels_body.inc"

namespace polylap::dense {

extern const Kernels kernels_avx512;
const Kernels kernels_avx512{"avx512", factor, downdate, forward, backward, scratch_doubles};

}  // namespace polylap::dense

#endif
