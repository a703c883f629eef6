#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace polylap::io {

/// A token as a message can show it: short, one line, plain ASCII.
std::string quote(std::string_view token);

/// The whole token as a finite number, correctly rounded.
bool parse_finite(std::string_view token, double& value);

/// The whole token as a whole number. One beyond 64 bits is given as the number nearest to it.
bool parse_whole(std::string_view token, std::int64_t& value);

/// Compares in ASCII without regard to case; `word` is in lower case.
bool is_word(std::string_view token, std::string_view word);

/// What a text is if it is certainly no text of a mesh format, in a sentence that ends with `format`, e.g. "this is an
/// HTML page, not an OFF file"; otherwise empty.
std::string refuse_foreign(std::string_view bytes, const char* format);

/// The line that holds a byte, from 1.
std::int64_t line_of(std::string_view text, std::size_t byte);

/// Cuts a text into lines and tokens without copying it. Lines end with LF, CRLF or CR.
class LineScanner {
public:
    /// @param comment the character from which the rest of a line is none of its tokens; 0: none
    /// @param line the number of the first line
    explicit LineScanner(std::string_view text, char comment = 0, std::int64_t line = 1)
        : text_(text), comment_(comment), line_(line) {}

    /// Goes to the next line that has a token. False at the end of the text.
    bool next_line();
    /// The next token of the line; empty at its end.
    std::string_view next_token();
    /// The next token of this or a later line; empty at the end of the text.
    std::string_view next_word();
    void skip_line();

    std::int64_t line() const { return line_; }
    std::size_t position() const { return at_; }
    std::size_t bytes_left() const { return text_.size() - at_; }

private:
    bool at_line_end() const { return at_ == text_.size() || text_[at_] == '\n' || text_[at_] == '\r'; }
    bool at_comment() const { return comment_ != 0 && text_[at_] == comment_; }

    std::string_view text_;
    char comment_;
    std::size_t at_ = 0;
    std::int64_t line_;
    bool started_ = false;
};

}  // namespace polylap::io
