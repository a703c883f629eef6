#include <array>

#include "operators/vertex_weights.hpp"
#include "polylap/operators/alexa_wardetzky.hpp"
#include "polylap/operators/alexa_wardetzky_weighted.hpp"
#include "polylap/operators/cotan.hpp"
#include "polylap/operators/normalized_graph.hpp"
#include "polylap/operators/orthogonal_dual.hpp"
#include "polylap/operators/planar.hpp"
#include "polylap/operators/tutte.hpp"
#include "polylap/operators/umbrella.hpp"
#include "polylap/operators/weighted_cotan.hpp"

namespace polylap {

// THE operator table: one line per operator, in the order of the menus.
std::span<const OperatorInfo* const> operators() noexcept {
    static constexpr std::array table{
        &umbrella_info,        &tutte_info,           &normalized_graph_info,         &cotan_info,
        &weighted_cotan_info,  &alexa_wardetzky_info, &alexa_wardetzky_weighted_info, &planar_info,
        &orthogonal_dual_info,
    };
    return table;
}

std::array<const OperatorInfo*, 2> opening_pair() noexcept {
    return {&alexa_wardetzky_info, &planar_info};
}

std::span<const PropertyInfo> properties() noexcept {
    static constexpr std::array table{
        PropertyInfo{"symmetric", "Symmetric", "S = Sᵀ: as much weight from i to j as back.",
                     &PropertyClaims::symmetric},
        PropertyInfo{"local", "Local", "Weights only between vertices that share a face.", &PropertyClaims::local},
        PropertyInfo{"positiveWeights", "Weights ≥ 0", "No weight off the diagonal is negative.",
                     &PropertyClaims::positive_weights},
        PropertyInfo{"positiveSemidefinite", "PSD", "No function has negative Dirichlet energy.",
                     &PropertyClaims::positive_semidefinite},
        PropertyInfo{"constantsInKernel", "S 1 = 0", "Constant functions have no Laplacian.",
                     &PropertyClaims::constants_in_kernel},
        PropertyInfo{"linearPrecision", "Linear precision",
                     "Linear functions have no Laplacian at inner vertices whose surroundings lie in one plane.",
                     &PropertyClaims::linear_precision},
        PropertyInfo{"maximumPrinciple", "Maximum principle",
                     "Harmonic functions stay within the range of their boundary values.",
                     &PropertyClaims::maximum_principle},
        PropertyInfo{"convergent", "Convergent", "Solutions approach the smooth ones under refinement.",
                     &PropertyClaims::convergent},
    };
    return table;
}

namespace {

std::string quoted(std::string_view text) {
    return "'" + std::string(text) + "'";
}

/// Only what holds on every mesh can be relied on.
Structure structure_of(const PropertyClaims& claims) {
    if (claims.symmetric.where != Claim::yes) return Structure::general;
    if (claims.positive_semidefinite.where != Claim::yes) return Structure::symmetric;
    return Structure::positive_semidefinite;
}

std::string owner_of(const OperatorInfo& info) {
    return "operator " + quoted(info.id);
}

}  // namespace

std::string_view claim_name(Claim claim) noexcept {
    switch (claim) {
        case Claim::yes:
            return "yes";
        case Claim::planar:
            return "planar";
        case Claim::triangles:
            return "triangles";
        case Claim::some:
            return "some";
        case Claim::no:
            return "no";
    }
    return "unknown";
}

Result<const OperatorInfo*> find_operator(std::string_view id) {
    return guard_memory([&]() -> Result<const OperatorInfo*> {
        std::string known;
        for (const OperatorInfo* info : operators()) {
            if (id == info->id) return info;
            known += (known.empty() ? "" : ", ") + std::string(info->id);
        }
        return Error{ErrorCode::unknown_operator, "there is no operator " + quoted(id) + "; known are " + known};
    });
}

Result<OperatorSpec> make_spec(std::string_view id, Settings settings) {
    return guard_memory([&]() -> Result<OperatorSpec> {
        const auto info = find_operator(id);
        if (!info) return info.error();
        auto values = parse_settings(owner_of(**info), (*info)->parameters, settings);
        if (!values) return values.error();
        return OperatorSpec{.id = std::string(id), .values = *std::move(values)};
    });
}

Result<OperatorSpec> complete_spec(OperatorSpec spec) {
    return guard_memory([&]() -> Result<OperatorSpec> {
        const auto info = find_operator(spec.id);
        if (!info) return info.error();
        auto values = complete_values(owner_of(**info), (*info)->parameters, std::move(spec.values));
        if (!values) return values.error();
        spec.values = *std::move(values);
        if (!spec.vertex_weights.empty() && !(*info)->takes_vertex_weights) {
            return Error{ErrorCode::bad_argument, owner_of(**info) + " takes no vertex weights"};
        }
        if (Status status = check_weights_finite(spec.vertex_weights); !status) return status.error();
        return spec;
    });
}

Result<OperatorMatrices> build_operator(const PolygonMesh& mesh, const OperatorSpec& spec, Monitor monitor) {
    return guard_memory([&]() -> Result<OperatorMatrices> {
        OperatorMatrices matrices;
        if (Status status = rebuild_operator(mesh, spec, matrices, monitor); !status) return status.error();
        return matrices;
    });
}

Status rebuild_operator(const PolygonMesh& mesh, const OperatorSpec& spec, OperatorMatrices& matrices,
                        Monitor monitor) {
    return guard_memory([&]() -> Status {
        const auto complete = complete_spec(spec);
        if (!complete) return complete.error();
        if (Status status = check_vertex_weights(mesh, complete->vertex_weights); !status) return status.error();
        const OperatorInfo& info = **find_operator(complete->id);
        matrices.structure = structure_of(info.claims);
        return info.build(mesh, *complete, matrices, monitor);
    });
}

}  // namespace polylap
