#include "obj_faces.hpp"

#include <istream>
#include <streambuf>

// Under a name of our own: a program that links polylap may have its own tinyobjloader, of another version or with
// float.
#define tinyobj polylap_tinyobj
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

namespace polylap::obj {
namespace {

/// Bytes between two looks at the monitor.
constexpr std::size_t tick_bytes = 1 << 16;

/// Hands out the pieces one after the other, without copying. Ends early when the monitor says so, which is how the
/// parser is stopped.
class PieceBuffer : public std::streambuf {
public:
    PieceBuffer(const std::vector<std::string_view>& pieces, Monitor monitor) : pieces_(pieces), monitor_(monitor) {
        for (const std::string_view piece : pieces)
            total_ += piece.size();
    }

    bool cancelled() const { return cancelled_; }

protected:
    int_type underflow() override {
        while (rest_.empty() && next_ < pieces_.size())
            rest_ = pieces_[next_++];
        if (rest_.empty() || cancelled_ || !proceed()) return traits_type::eof();
        const std::size_t length = std::min(rest_.size(), tick_bytes);
        char* const first = const_cast<char*>(rest_.data());  // never written: nothing puts back other characters
        setg(first, first, first + length);
        rest_.remove_prefix(length);
        done_ += length;
        return traits_type::to_int_type(*first);
    }

private:
    bool proceed() {
        if (done_ - ticked_ < tick_bytes) return true;
        ticked_ = done_;
        cancelled_ = !monitor_.proceed(static_cast<double>(done_) / static_cast<double>(total_));
        return !cancelled_;
    }

    const std::vector<std::string_view>& pieces_;
    Monitor monitor_;
    std::string_view rest_;
    std::size_t next_ = 0;
    std::size_t total_ = 0, done_ = 0, ticked_ = 0;
    bool cancelled_ = false;
};

struct Collector {
    Faces faces;
    int vertices = 0;
};

void on_vertex(void* user, double, double, double, double) {
    ++static_cast<Collector*>(user)->vertices;
}

void on_face(void* user, polylap_tinyobj::index_t* indices, int count) {
    auto& [faces, vertices] = *static_cast<Collector*>(user);
    for (int i = 0; i < count; ++i) {
        const int index = indices[i].vertex_index;
        faces.corners.push_back(index > 0 ? index - 1 : vertices + index);
    }
    faces.offsets.push_back(static_cast<Index>(faces.corners.size()));
}

}  // namespace

Result<Faces> read_faces(const Script& script, Monitor monitor) {
    Collector collector;
    collector.faces.offsets.reserve(static_cast<std::size_t>(script.faces) + 1);
    collector.faces.corners.reserve(static_cast<std::size_t>(script.corners));
    collector.faces.offsets.push_back(0);

    polylap_tinyobj::callback_t callbacks;
    callbacks.vertex_cb = on_vertex;
    callbacks.index_cb = on_face;
    PieceBuffer buffer(script.statements, monitor);
    std::istream stream(&buffer);
    const bool parsed = polylap_tinyobj::LoadObjWithCallback(stream, callbacks, &collector);

    if (buffer.cancelled()) return Error{ErrorCode::cancelled, "reading was cancelled", -1, -1};
    const auto& [offsets, corners] = collector.faces;
    if (!parsed || collector.vertices != script.vertices() ||
        static_cast<std::int64_t>(offsets.size()) != script.faces + 1 ||
        static_cast<std::int64_t>(corners.size()) != script.corners)
        return Error{ErrorCode::parse_error, "the OBJ parser saw other vertices or faces than the check before it", -1,
                     -1};
    return std::move(collector.faces);
}

}  // namespace polylap::obj
