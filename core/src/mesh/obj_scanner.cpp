#include "obj_scanner.hpp"

namespace polylap::obj {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}

}  // namespace

std::size_t Scanner::line_end_length(const char* p) const {
    if (p == end_ || !is_line_end(*p)) return 0;
    return *p == '\r' && p + 1 != end_ && p[1] == '\n' ? 2 : 1;
}

bool Scanner::ends_token(const char* p) const {
    if (is_blank(*p) || is_line_end(*p) || *p == '#') return true;
    return *p == '\\' && (p + 1 == end_ || is_line_end(p[1]));
}

void Scanner::cut(std::string_view replacement) {
    if (at_ != piece_) pieces_.emplace_back(piece_, static_cast<std::size_t>(at_ - piece_));
    if (!replacement.empty()) pieces_.push_back(replacement);
}

bool Scanner::next_statement() {
    while (at_ != end_) {
        if (is_blank(*at_)) {
            ++at_;
        } else if (is_line_end(*at_) || *at_ == '#') {
            skip_line();
        } else {
            line_ = current_line_;
            piece_ = at_;
            pieces_.clear();
            keyword_ = next_token();
            return true;
        }
    }
    return false;
}

std::string_view Scanner::next_token() {
    for (;;) {
        while (at_ != end_ && is_blank(*at_))
            ++at_;
        if (at_ == end_ || *at_ != '\\' || !ends_token(at_)) break;
        cut(" ");
        ++at_;
        at_ += line_end_length(at_);
        piece_ = at_;
        ++current_line_;
    }
    const char* const first = at_;
    while (at_ != end_ && !ends_token(at_))
        ++at_;
    return {first, static_cast<std::size_t>(at_ - first)};
}

void Scanner::finish_statement() {
    while (!next_token().empty()) {
    }
    if (at_ != end_ && *at_ == '#') {
        cut("\n");
        skip_line();
    } else {
        skip_line();
        cut({});
    }
}

void Scanner::skip_line() {
    while (at_ != end_ && !is_line_end(*at_))
        ++at_;
    if (const std::size_t length = line_end_length(at_)) {
        at_ += length;
        ++current_line_;
    }
}

}  // namespace polylap::obj
