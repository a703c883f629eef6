#include "obj_faces.hpp"

#include <istream>
#include <numeric>
#include <span>
#include <streambuf>

// Under a name of our own: a program that links polylap may have its own tinyobjloader, of another version or with
// float.
#define tinyobj polylap_tinyobj
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

namespace polylap::obj {
namespace {

/// Hands out the pieces one after the other, without copying. Ends early when the monitor says so, which is how the
/// parser is stopped.
class PieceBuffer : public std::streambuf {
public:
    PieceBuffer(const std::vector<std::string_view>& pieces, Monitor monitor)
        : pieces_(pieces),
          ticker_(monitor,
                  std::accumulate(pieces.begin(), pieces.end(), std::size_t{0},
                                  [](std::size_t sum, std::string_view piece) { return sum + piece.size(); })) {}

    bool cancelled() const { return cancelled_; }

protected:
    int_type underflow() override {
        while (rest_.empty() && next_ < pieces_.size())
            rest_ = pieces_[next_++];
        if (rest_.empty() || cancelled_ || !proceed()) return traits_type::eof();
        constexpr std::size_t most_at_once = 1 << 16;  // so that the ticker is asked now and then
        const std::size_t length = std::min(rest_.size(), most_at_once);
        char* const first = const_cast<char*>(rest_.data());  // never written: nothing puts back other characters
        setg(first, first, first + length);
        rest_.remove_prefix(length);
        done_ += length;
        return traits_type::to_int_type(*first);
    }

private:
    bool proceed() {
        cancelled_ = !ticker_.proceed(done_);
        return !cancelled_;
    }

    const std::vector<std::string_view>& pieces_;
    io::Ticker ticker_;
    std::string_view rest_;
    std::size_t next_ = 0;
    std::size_t done_ = 0;
    bool cancelled_ = false;
};

struct Collector {
    Faces faces;
    std::span<const std::int64_t> bare_faces;  ///< Those that are still to come.
    int vertices = 0;

    void finish_face() { faces.offsets.push_back(static_cast<Index>(faces.corners.size())); }
    void finish_bare_faces() {
        for (; !bare_faces.empty() && bare_faces.front() + 1 == static_cast<std::int64_t>(faces.offsets.size());
             bare_faces = bare_faces.subspan(1))
            finish_face();
    }
};

void on_vertex(void* user, double, double, double, double) {
    ++static_cast<Collector*>(user)->vertices;
}

void on_face(void* user, polylap_tinyobj::index_t* indices, int count) {
    auto& collector = *static_cast<Collector*>(user);
    collector.finish_bare_faces();
    for (int i = 0; i < count; ++i) {
        const int index = indices[i].vertex_index;
        collector.faces.corners.push_back(index > 0 ? index - 1 : collector.vertices + index);
    }
    collector.finish_face();
}

}  // namespace

Result<Faces> read_faces(const Script& script, Monitor monitor) {
    Collector collector;
    collector.faces.offsets.reserve(static_cast<std::size_t>(script.faces) + 1);
    collector.faces.corners.reserve(static_cast<std::size_t>(script.corners));
    collector.faces.offsets.push_back(0);
    collector.bare_faces = script.bare_faces;

    polylap_tinyobj::callback_t callbacks;
    callbacks.vertex_cb = on_vertex;
    callbacks.index_cb = on_face;
    PieceBuffer buffer(script.statements, monitor);
    std::istream stream(&buffer);
    const bool parsed = polylap_tinyobj::LoadObjWithCallback(stream, callbacks, &collector);
    collector.finish_bare_faces();

    if (buffer.cancelled()) return io::cancelled();
    const auto& [offsets, corners] = collector.faces;
    if (!parsed || collector.vertices != script.vertices() ||
        static_cast<std::int64_t>(offsets.size()) != script.faces + 1 ||
        static_cast<std::int64_t>(corners.size()) != script.corners)
        return io::whole_file("the OBJ parser saw other vertices or faces than the check before it");
    return std::move(collector.faces);
}

}  // namespace polylap::obj
