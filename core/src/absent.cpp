// Stands in for what polylap-core.wasm does without, which a page loads when it is first asked for: the library's own
// files of these functions stay out of a program that has this one. Each answers not_included, an error that no other
// program meets.
#include <array>

#include "mesh/shape_builder.hpp"
#include "polylap/apply/explicit_step.hpp"
#include "polylap/operators/dual_vertices.hpp"
#include "solve/lu_factor.hpp"

namespace polylap {
namespace {

Error absent() {
    return {ErrorCode::not_included, "this build does without what it takes"};
}

}  // namespace

// What the page's own menu of meshes is made of.
std::span<const ShapeInfo* const> shapes() noexcept {
    static constexpr std::array table{&grid_shape, &saddle_shape, &torus_shape};
    return table;
}

Result<const ShapeInfo*> find_shape(std::string_view id) {
    for (const ShapeInfo* info : shapes()) {
        if (id == info->id) return info;
    }
    return absent();
}

struct LuFactor::Impl {};

LuFactor::LuFactor() = default;
LuFactor::LuFactor(LuFactor&&) noexcept = default;
LuFactor& LuFactor::operator=(LuFactor&&) noexcept = default;
LuFactor::~LuFactor() = default;

Status LuFactor::factor(const SparseMatrix& /*a*/) {
    return absent();
}

Matrix LuFactor::solve(const Eigen::Ref<const Matrix>& rhs) const {
    return rhs;  // Nothing has been factored that it could be asked with.
}

std::int64_t LuFactor::bytes() const noexcept {
    return 0;
}

Result<SmoothingStep> explicit_step(const OperatorMatrices& /*matrices*/, double /*time*/, const Points& /*points*/,
                                    std::span<const Index> /*fixed*/, Monitor /*monitor*/) {
    return absent();
}

Result<Stability> explicit_stability(const OperatorMatrices& /*matrices*/, std::span<const Index> /*fixed*/,
                                     Monitor /*monitor*/) {
    return absent();
}

Result<OrthogonalDual> orthogonal_dual(const PolygonMesh& /*mesh*/, DualOptions /*options*/, Monitor /*monitor*/) {
    return absent();
}

}  // namespace polylap
