#include "raw_builder.hpp"

#include <algorithm>

namespace polylap::io {
namespace {

/// Corners up to which comparing all pairs beats sorting.
constexpr std::size_t pairwise_corners = 24;

/// A vertex that appears twice, or -1.
Index repeated(std::span<const Index> corners, std::vector<Index>& scratch) {
    if (corners.size() <= pairwise_corners) {
        for (std::size_t i = 1; i < corners.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (corners[i] == corners[j]) return corners[i];
        return -1;
    }
    scratch.assign(corners.begin(), corners.end());
    std::sort(scratch.begin(), scratch.end());
    const auto twin = std::adjacent_find(scratch.begin(), scratch.end());
    return twin == scratch.end() ? -1 : *twin;
}

}  // namespace

Error whole_file(std::string message) {
    return {ErrorCode::parse_error, std::move(message), -1, -1};
}

Error fault(Place place, std::int64_t element, const std::string& message, ErrorCode code) {
    const std::string where =
        place.line >= 0 ? "line " + std::to_string(place.line) : "byte " + std::to_string(place.byte);
    return {code, where + ": " + message, element, place.line};
}

Error cancelled() {
    return {ErrorCode::cancelled, "reading was cancelled", -1, -1};
}

std::string unsound(std::span<const Index> corners, std::vector<Index>& scratch) {
    if (corners.size() < 3)
        return "has " + std::to_string(corners.size()) + (corners.size() == 1 ? " corner" : " corners") +
               ", fewer than 3";
    const Index twin = repeated(corners, scratch);
    return twin < 0 ? std::string() : "has vertex " + std::to_string(twin) + " twice";
}

std::optional<Error> refuse_count(Place place, std::int64_t count, const char* what, std::size_t least_bytes,
                                  std::size_t bytes_left) {
    const std::string announced = std::to_string(count) + " " + what + " are announced, but ";
    if (count < 0) return fault(place, -1, announced + "a count cannot be negative");
    if (count > most) return fault(place, -1, announced + "a mesh holds at most " + std::to_string(most));
    if (static_cast<std::uint64_t>(count) > bytes_left / std::max<std::size_t>(least_bytes, 1))
        return fault(place, -1,
                     announced + "the " + std::to_string(bytes_left) + " bytes that follow cannot hold them");
    return std::nullopt;
}

std::optional<Error> RawBuilder::add_corner(Place place, std::int64_t vertex) {
    const std::int64_t vertices = expected_ < 0 ? this->vertex() : expected_;
    if (vertex < 0 || vertex >= vertices)
        return fault_of_face(place, "has the index " + std::to_string(vertex) + ", but the file has " +
                                        std::to_string(vertices) + " vertices, counted from 0");
    if (corners_.size() == static_cast<std::size_t>(most))
        return fault_of_face(place, "is one too many: a mesh holds at most " + std::to_string(most) + " corners");
    corners_.push_back(static_cast<Index>(vertex));
    return std::nullopt;
}

std::optional<Error> RawBuilder::finish_face(Place place) {
    if (rule_ == FaceRule::sound) {
        const auto first = static_cast<std::size_t>(offsets_.back());
        if (const auto what = unsound(std::span(corners_).subspan(first), scratch_); !what.empty())
            return fault_of_face(place, what, ErrorCode::bad_mesh);
    }
    offsets_.push_back(static_cast<Index>(corners_.size()));
    return std::nullopt;
}

Error RawBuilder::fault_of_vertex(Place place, const std::string& what) const {
    return fault(place, vertex(), "vertex " + std::to_string(vertex()) + " " + what);
}

Error RawBuilder::fault_of_face(Place place, const std::string& what, ErrorCode code) const {
    return fault(place, face(), std::string(noun_) + " " + std::to_string(face()) + " " + what, code);
}

RawMesh RawBuilder::finish() {
    const auto vertices = static_cast<Eigen::Index>(vertex());
    return {Eigen::Map<const Points>(coordinates_.data(), vertices, 3), std::move(offsets_), std::move(corners_), {}};
}

}  // namespace polylap::io
