#include "results.hpp"

#include <array>

#include <emscripten/bind.h>

namespace polylap::js {
namespace {

std::vector<float> relative(const Points& points, const Vector3& origin) {
    std::vector<float> result;
    result.reserve(static_cast<std::size_t>(points.size()));
    for (const auto& point : points.rowwise())
        for (int k = 0; k < 3; ++k)
            result.push_back(static_cast<float>(point[k] - origin[k]));
    return result;
}

template <class T>
val dense(const T& values) {
    return array(values.data(), static_cast<std::size_t>(values.size()));
}

std::string verdict_name(Measurement::Verdict verdict) {
    static constexpr std::array names{"holds", "fails", "not-measured"};
    return names[static_cast<std::size_t>(verdict)];
}

val told(const Measurement& measurement) {
    return object(entry("property", std::string(measurement.property->id)),
                  entry("verdict", verdict_name(measurement.verdict)), entry("value", measurement.value),
                  entry("text", measurement.text),
                  entry("vertices", list(measurement.vertices, [](Index v) { return val(v); })));
}

}  // namespace

Result<val> owned(Result<Session> session) {
    if (!session) return session.error();
    return val(std::make_shared<Session>(std::move(*session)));
}

val told(const Session::Shape& shape) {
    return object(entry("area", shape.measures.area), entry("volume", shape.volume ? val(*shape.volume) : val::null()),
                  entry("noVolume", shape.no_volume), entry("meanNonPlanarity", shape.measures.mean_non_planarity),
                  entry("meanSquaredEdge", shape.measures.mean_squared_edge));
}

val told(const std::optional<SmoothingSolve>& solve) {
    if (!solve) return val::null();
    return object(entry("solver", std::string(solver_name(solve->solver))), entry("iterations", solve->iterations));
}

val told(const Session::Repairs& repairs) {
    const auto change = [](const RepairChange& made) {
        return object(entry("kind", std::string(repair_name(made.kind))), entry("elements", array(made.elements)),
                      entry("message", made.message));
    };
    return object(entry("changes", list(repairs.changes, change)),
                  entry("originalVertices", array(repairs.original_vertices)),
                  entry("originalFaces", array(repairs.original_faces)));
}

val told(const Session::Weights& weights) {
    const WeightSummary& summary = weights.summary;
    std::vector<Index> pairs;
    std::vector<double> values;
    pairs.reserve(2 * summary.negative.size());
    values.reserve(summary.negative.size());
    for (const Weight& weight : summary.negative) {
        pairs.insert(pairs.end(), {weight.i, weight.j});
        values.push_back(weight.value);
    }
    return object(entry("negativeOrdered", summary.negative_ordered), entry("nonzeroOrdered", summary.nonzero_ordered),
                  entry("smallest", summary.smallest), entry("largest", summary.largest), entry("pairs", array(pairs)),
                  entry("values", array(values)), entry("segments", array(weights.segments)),
                  entry("segmentStarts", array(weights.segment_starts)),
                  entry("segmentPairs", array(weights.segment_pairs)));
}

val told(const Session::Row& row) {
    return object(entry("columns", array(row.entries.columns)), entry("values", array(row.entries.values)),
                  entry("mass", row.entries.mass), entry("segments", array(row.segments)),
                  entry("segmentStarts", array(row.segment_starts)), entry("segmentPairs", array(row.segment_pairs)));
}

val told(const FaceReport& face) {
    static_assert(sizeof(Eigen::Vector2d) == 2 * sizeof(double) && sizeof(Triangle) == 3 * sizeof(Index));
    return object(
        entry("corners", array(face.corners)), entry("vectorArea", triple(face.vector_area)),
        entry("normal", triple(face.normal)), entry("nonPlanarity", face.non_planarity),
        entry("projected", array(reinterpret_cast<const double*>(face.projected.data()), 2 * face.projected.size())),
        entry("triangles", array(reinterpret_cast<const Index*>(face.triangles.data()), 3 * face.triangles.size())),
        // Column by column in Eigen: transposed, row by row.
        entry("stiffness", face.stiffness ? dense(Matrix(face.stiffness->transpose())) : val::null()),
        entry("noStiffness", face.no_stiffness));
}

val told(const Session::Harmonic& harmonic) {
    return object(entry("values", array(harmonic.values.data(), static_cast<std::size_t>(harmonic.values.size()))),
                  entry("min", harmonic.min), entry("max", harmonic.max), entry("fixedMin", harmonic.fixed_min),
                  entry("fixedMax", harmonic.fixed_max), entry("outside", array(harmonic.outside)));
}

val told(const PropertyReport& report) {
    val modes = val::array();
    for (const auto& mode : report.kernel_modes.colwise())
        modes.call<void>("push", dense(mode));
    return object(entry("measurements", list(report.measurements, [](const Measurement& m) { return told(m); })),
                  entry("negativeOrdered", report.negative_ordered), entry("negativePairs", report.negative_pairs),
                  entry("smallestEigenvalue", report.smallest_eigenvalue),
                  entry("largestEigenvalue", report.largest_eigenvalue), entry("components", report.components),
                  entry("kernelDimension", report.kernel_dimension), entry("kernelComplete", report.kernel_complete),
                  entry("kernelModes", modes), entry("condition", report.condition),
                  entry("smallestMass", report.smallest_mass),
                  entry("smallestMassVertex", report.smallest_mass_vertex));
}

val told(const OrthogonalDual& dual, const Vector3& origin) {
    const std::size_t count = dual.edges.size();
    std::vector<Index> vertices, faces;
    std::vector<double> lengths, weights;
    vertices.reserve(2 * count);
    faces.reserve(2 * count);
    lengths.reserve(2 * count);
    weights.reserve(count);
    Points points(static_cast<Eigen::Index>(count), 3);
    for (std::size_t e = 0; e < count; ++e) {
        const DualEdge& edge = dual.edges[e];
        vertices.insert(vertices.end(), {edge.v0, edge.v1});
        faces.insert(faces.end(), {edge.face0, edge.face1});
        lengths.insert(lengths.end(), {edge.length0, edge.length1});
        weights.push_back(edge.weight);
        points.row(static_cast<Eigen::Index>(e)) = edge.point.transpose();
    }
    return object(
        entry("positions", array(relative(dual.vertices, origin))), entry("coordinates", dense(dual.vertices)),
        entry("edgeVertices", array(vertices)), entry("edgeFaces", array(faces)),
        entry("edgePoints", array(relative(points, origin))), entry("lengths", array(lengths)),
        entry("weights", array(weights)), entry("constraints", dual.constraints), entry("rank", dual.rank),
        entry("nullSpace", dual.null_space), entry("residual", dual.residual), entry("worstEdge", dual.worst_edge),
        entry("largestShift", dual.largest_shift), entry("worstFace", dual.worst_face), entry("usable", dual.usable));
}

val told(const ConvergenceStudy& study) {
    const auto level = [](const ConvergenceLevel& one) {
        return object(entry("vertices", one.vertices), entry("h", one.h), entry("error", one.error),
                      entry("order", one.order));
    };
    return object(entry("family", study.family), entry("problem", study.problem),
                  entry("onlyTriangles", study.only_triangles), entry("planarFaces", study.planar_faces),
                  entry("levels", list(study.levels, level)), entry("order", study.order),
                  entry("converges", study.converges), entry("failure", study.failure));
}

}  // namespace polylap::js
