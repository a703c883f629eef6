#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "polylap/base/monitor.hpp"
#include "polylap/mesh/mesh_io.hpp"

// What the readers of all formats share.
namespace polylap::io {

/// The most vertices, faces or corners that a mesh can have.
inline constexpr std::int64_t most = std::numeric_limits<Index>::max();

/// Which faces pass: any, which is what repair starts from, or only those that a mesh may have.
enum class FaceRule : std::uint8_t { any, sound };

/// Where in a file something stands: a line of a text, from 1, or a byte, from 0.
struct Place {
    std::int64_t line = -1;
    std::int64_t byte = -1;
};
inline Place at_line(std::int64_t line) {
    return {line, -1};
}
inline Place at_byte(std::size_t byte) {
    return {-1, static_cast<std::int64_t>(byte)};
}

/// An error of the file as a whole.
Error whole_file(std::string message);
Error fault(Place place, std::int64_t element, const std::string& message, ErrorCode code = ErrorCode::parse_error);
Error cancelled();

/// Looks at the monitor once for many bytes.
class Ticker {
public:
    Ticker(Monitor monitor, std::size_t total) : monitor_(monitor), total_(total) {}
    /// False: stop.
    bool proceed(std::size_t done) {
        constexpr std::size_t tick_bytes = 1 << 16;
        if (done - ticked_ < tick_bytes) return true;
        ticked_ = done;
        return monitor_.proceed(static_cast<double>(done) / static_cast<double>(total_));
    }

private:
    Monitor monitor_;
    std::size_t total_;
    std::size_t ticked_ = 0;
};

/// What forbids these corners in a mesh, e.g. "has vertex 1 twice"; empty: nothing.
/// @param scratch overwritten; may be reused from face to face
std::string unsound(std::span<const Index> corners, std::vector<Index>& scratch);

/// Refuses a count that cannot be: no mesh holds so many, or the bytes that are left cannot, each element taking at
/// least `least_bytes`. Memory is reserved only for what passed here.
/// @param what the plural, e.g. "vertices"
std::optional<Error> refuse_count(Place place, std::int64_t count, const char* what, std::size_t least_bytes,
                                  std::size_t bytes_left);

/// Collects vertices and faces, and refuses what can be in no mesh.
class RawBuilder {
public:
    /// @param noun what messages call a face
    explicit RawBuilder(FaceRule rule, const char* noun = "face") : rule_(rule), noun_(noun) {}

    /// For a file that says its counts, which passed refuse_count: a corner may then be any of these vertices, and
    /// otherwise one of those added so far.
    void expect(std::int64_t vertices, std::int64_t faces) {
        expected_ = vertices;
        coordinates_.reserve(3 * static_cast<std::size_t>(vertices));
        offsets_.reserve(static_cast<std::size_t>(faces) + 1);
    }
    void add_vertex(const double* xyz) { coordinates_.insert(coordinates_.end(), xyz, xyz + 3); }

    /// Adds a corner of the face that is being read. Any number may come in.
    std::optional<Error> add_corner(Place place, std::int64_t vertex);
    std::optional<Error> finish_face(Place place);

    std::int64_t vertex() const { return static_cast<std::int64_t>(coordinates_.size() / 3); }  ///< The next one.
    std::int64_t face() const { return static_cast<std::int64_t>(offsets_.size()) - 1; }        ///< The one being read.
    Error fault_of_vertex(Place place, const std::string& what) const;
    Error fault_of_face(Place place, const std::string& what, ErrorCode code = ErrorCode::parse_error) const;

    RawMesh finish();

private:
    FaceRule rule_;
    const char* noun_;
    std::int64_t expected_ = -1;
    std::vector<double> coordinates_;
    std::vector<Index> offsets_{0}, corners_, scratch_;
};

Result<RawMesh> read_obj(std::string_view text, FaceRule rule, Monitor monitor);
Result<RawMesh> read_off(std::string_view bytes, FaceRule rule, Monitor monitor);
Result<RawMesh> read_ply(std::string_view bytes, FaceRule rule, Monitor monitor);
Result<RawMesh> read_stl(std::string_view bytes, FaceRule rule, Monitor monitor);

}  // namespace polylap::io
