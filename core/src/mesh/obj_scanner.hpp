#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace polylap::obj {

/// Cuts OBJ text into statements and tokens without copying it: joins `\` continuations, drops comments, knows the
/// line.
class Scanner {
public:
    explicit Scanner(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

    /// Goes to the next statement and reads its keyword. False at the end of the text.
    bool next_statement();

    /// The next token of the statement; empty at its end.
    std::string_view next_token();

    /// Reads past the rest of the statement.
    void finish_statement();
    /// Reads past the rest of the line: a `\` at the end of a group name or path must not swallow the face below it.
    void skip_line();

    std::string_view keyword() const { return keyword_; }
    std::int64_t line() const { return line_; }  ///< Where the statement starts, from 1.
    const char* position() const { return at_; }
    /// The finished statement with its line end, comments and continuations cut out.
    const std::vector<std::string_view>& pieces() const { return pieces_; }

private:
    /// Length of the line end at p, 0 if there is none. A lone CR counts, as it does for tinyobjloader.
    std::size_t line_end_length(const char* p) const;
    bool ends_token(const char* p) const;
    void cut(std::string_view replacement);

    const char* at_;
    const char* end_;
    const char* piece_ = nullptr;  ///< Start of the piece that is being read.
    std::int64_t line_ = 0;
    std::int64_t current_line_ = 1;
    std::string_view keyword_;
    std::vector<std::string_view> pieces_;
};

}  // namespace polylap::obj
