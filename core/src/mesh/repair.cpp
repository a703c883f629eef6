#include "polylap/mesh/repair.hpp"

#include <algorithm>
#include <utility>

#include "repair_steps.hpp"
#include "weld.hpp"

namespace polylap {
namespace {

using Kind = RepairChange::Kind;

Error bad_mesh(std::string message, std::int64_t element = -1) {
    return {ErrorCode::bad_mesh, std::move(message), element};
}

/// Checks what RawMesh promises, so that nothing below can run out of bounds.
Status check(const RawMesh& raw) {
    for (Index v = 0; v < raw.positions.rows(); ++v)
        if (!raw.positions.row(v).allFinite())
            return bad_mesh("vertex " + std::to_string(v) + " has a coordinate that is not a finite number", v);
    if (raw.offsets.size() < 2) return bad_mesh("the mesh has no faces");
    if (raw.offsets.front() != 0 || static_cast<std::size_t>(raw.offsets.back()) != raw.corners.size() ||
        !std::is_sorted(raw.offsets.begin(), raw.offsets.end()))
        return bad_mesh("the face offsets must run from 0 to the number of corners");
    for (std::size_t f = 0; f + 1 < raw.offsets.size(); ++f)
        for (auto k = static_cast<std::size_t>(raw.offsets[f]); k < static_cast<std::size_t>(raw.offsets[f + 1]); ++k)
            if (raw.corners[k] < 0 || raw.corners[k] >= raw.positions.rows())
                return bad_mesh("face " + std::to_string(f) + " refers to vertex " + std::to_string(raw.corners[k]) +
                                    ", but there are " + std::to_string(raw.positions.rows()) +
                                    " vertices (counted from 0)",
                                static_cast<std::int64_t>(f));
    return Done{};
}

struct Wording {
    const char *name, *noun, *plural, *what;
};

Wording wording(Kind kind) noexcept {
    switch (kind) {
        case Kind::merged_vertices:
            return {"merged-vertices", "vertex", "vertices", "merged into another"};
        case Kind::repeated_corners:
            return {"repeated-corners", "face", "faces", "freed of repeated corners"};
        case Kind::degenerate_faces:
            return {"degenerate-faces", "face", "faces", "removed for having fewer than three corners or no area"};
        case Kind::duplicate_faces:
            return {"duplicate-faces", "face", "faces", "removed for having the same corners as an earlier one"};
        case Kind::turned_faces:
            return {"turned-faces", "face", "faces", "turned around to face as most of the area beside them does"};
        case Kind::unorientable_faces:
            return {"unorientable-faces", "face", "faces", "left as found: a surface with one side has no orientation"};
        case Kind::dropped_vertices:
            return {"dropped-vertices", "vertex", "vertices", "dropped, being in no face any more"};
    }
    return {"unknown", "element", "elements", "changed"};
}

class Repair {
public:
    Repair(const RawMesh& raw, RepairOptions options, Monitor monitor)
        : raw_(raw), options_(options), monitor_(monitor) {}

    Result<Repaired> run() {
        // About the shares of the time that a large mesh takes.
        if (!monitor_.proceed(0)) return cancelled();
        merged_ = merge_vertices(raw_.positions, options_.merge_distance);
        if (!monitor_.proceed(0.3)) return cancelled();
        clean_faces();
        if (!monitor_.proceed(0.5)) return cancelled();
        remove_duplicates();
        if (!monitor_.proceed(0.65)) return cancelled();
        turn_faces();
        if (!monitor_.proceed(0.9)) return cancelled();
        return finish();
    }

private:
    static Error cancelled() { return {ErrorCode::cancelled, "repair was cancelled", -1, -1}; }

    void note(Kind kind, std::vector<Index> elements) {
        if (elements.empty()) return;
        const auto [name, noun, plural, what] = wording(kind);
        constexpr std::size_t shown = 5;
        std::string message =
            std::to_string(elements.size()) + " " + (elements.size() == 1 ? noun : plural) + " " + what;
        for (std::size_t k = 0; k < std::min(shown, elements.size()); ++k)
            message += (k == 0 ? std::string(" (") + (elements.size() == 1 ? noun : plural) + " " : std::string(", ")) +
                       std::to_string(elements[k]);
        message += elements.size() > shown ? ", …)" : ")";
        changes_.push_back({kind, std::move(elements), std::move(message)});
    }

    /// Corners become the vertices that are left; faces without area go.
    void clean_faces() {
        std::vector<Index> shortened, degenerate, corners;
        std::vector<Index> last_face(merged_.size(), -1);
        for (std::size_t f = 0; f + 1 < raw_.offsets.size(); ++f) {
            const auto number = static_cast<Index>(f);
            corners.assign(raw_.corners.begin() + raw_.offsets[f], raw_.corners.begin() + raw_.offsets[f + 1]);
            for (Index& v : corners)
                v = merged_[static_cast<std::size_t>(v)];
            const std::size_t before = corners.size();
            drop_spikes(corners);
            std::erase_if(corners, [&](Index v) {
                return std::exchange(last_face[static_cast<std::size_t>(v)], number) == number;
            });
            if (corners.size() < 3 || has_no_area(raw_.positions, corners)) {
                degenerate.push_back(number);
                continue;
            }
            if (corners.size() < before) shortened.push_back(number);
            faces_.add(corners, number);
        }
        std::vector<Index> gone;
        for (std::size_t v = 0; v < merged_.size(); ++v)
            if (merged_[v] != static_cast<Index>(v)) gone.push_back(static_cast<Index>(v));
        note(Kind::merged_vertices, std::move(gone));
        note(Kind::repeated_corners, std::move(shortened));
        note(Kind::degenerate_faces, std::move(degenerate));
    }

    /// Their numbers in the file.
    std::vector<Index> originals(const std::vector<Index>& faces) const {
        std::vector<Index> numbers;
        numbers.reserve(faces.size());
        for (const Index f : faces)
            numbers.push_back(faces_.original[static_cast<std::size_t>(f)]);
        return numbers;
    }

    void remove_duplicates() {
        const auto duplicates = find_duplicates(faces_);
        if (duplicates.empty()) return;
        note(Kind::duplicate_faces, originals(duplicates));
        FaceList kept;
        for (Index f = 0; f < faces_.size(); ++f)
            if (!std::binary_search(duplicates.begin(), duplicates.end(), f))
                kept.add(std::as_const(faces_).face(f), faces_.original[static_cast<std::size_t>(f)]);
        faces_ = std::move(kept);
    }

    void turn_faces() {
        const Orientation orientation = orient(raw_.positions, faces_);
        for (const Index f : orientation.turned) {
            const auto face = faces_.face(f);
            std::reverse(face.begin() + 1, face.end());
        }
        note(Kind::turned_faces, originals(orientation.turned));
        note(Kind::unorientable_faces, originals(orientation.unorientable));
    }

    Result<Repaired> finish() {
        const auto faces = static_cast<Index>(raw_.offsets.size()) - 1;
        if (faces_.size() == 0)
            return bad_mesh(
                "repair leaves nothing: " +
                (faces == 1 ? std::string("the only face has") : "all " + std::to_string(faces) + " faces have") +
                " fewer than three corners or no area");
        std::vector<bool> used(merged_.size(), false), used_before(merged_.size(), false);
        for (const Index v : raw_.corners)
            used_before[static_cast<std::size_t>(merged_[static_cast<std::size_t>(v)])] = true;
        for (const Index v : faces_.corners)
            used[static_cast<std::size_t>(v)] = true;
        std::vector<Index> number(merged_.size(), -1), original_vertices, dropped;
        for (std::size_t v = 0; v < merged_.size(); ++v) {
            const auto vertex = static_cast<Index>(v);
            if (merged_[v] != vertex) continue;
            if (used_before[v] && !used[v]) {
                dropped.push_back(vertex);
                continue;
            }
            number[v] = static_cast<Index>(original_vertices.size());
            original_vertices.push_back(vertex);
        }
        note(Kind::dropped_vertices, std::move(dropped));
        for (Index& v : faces_.corners)
            v = number[static_cast<std::size_t>(v)];
        Points positions(static_cast<Eigen::Index>(original_vertices.size()), 3);
        for (std::size_t v = 0; v < original_vertices.size(); ++v)
            positions.row(static_cast<Eigen::Index>(v)) = raw_.positions.row(original_vertices[v]);
        auto mesh = PolygonMesh::create(std::move(positions), std::move(faces_.offsets), std::move(faces_.corners));
        if (!mesh) return mesh.error();
        return Repaired{*std::move(mesh), std::move(changes_), std::move(original_vertices),
                        std::move(faces_.original)};
    }

    const RawMesh& raw_;
    RepairOptions options_;
    Monitor monitor_;
    std::vector<Index> merged_;  ///< The vertex that each became.
    FaceList faces_;
    std::vector<RepairChange> changes_;
};

}  // namespace

Result<Repaired> repair(const RawMesh& raw, RepairOptions options, Monitor monitor) {
    return guard_memory([&]() -> Result<Repaired> {
        if (!(options.merge_distance >= 0 && options.merge_distance < 1))
            return Error{ErrorCode::bad_argument, "the distance to merge at must be at least 0 and less than 1"};
        if (auto status = check(raw); !status) return status.error();
        return Repair(raw, options, monitor).run();
    });
}

std::string_view repair_name(RepairChange::Kind kind) noexcept {
    return wording(kind).name;
}

}  // namespace polylap
