#include "text_lines.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <fast_float/fast_float.h>

#include "obj_check.hpp"

namespace polylap::io {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

}  // namespace

std::string quote(std::string_view token) {
    constexpr std::size_t longest = 32;
    std::string text(token.substr(0, longest));
    for (char& c : text)
        if (c < ' ' || c > '~') c = '?';
    return '\'' + text + (token.size() > longest ? "…'" : "'");
}

bool parse_finite(std::string_view token, double& value) {
    if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
    const char* const last = token.data() + token.size();
    const auto [rest, status] = fast_float::from_chars(token.data(), last, value);
    return status == std::errc() && rest == last && std::isfinite(value);
}

bool parse_whole(std::string_view token, std::int64_t& value) {
    const char* const last = token.data() + token.size();
    const auto [rest, status] = std::from_chars(token.data(), last, value);
    if (status == std::errc::result_out_of_range)
        value = token[0] == '-' ? std::numeric_limits<std::int64_t>::min() : std::numeric_limits<std::int64_t>::max();
    return status != std::errc::invalid_argument && rest == last;
}

bool is_word(std::string_view token, std::string_view word) {
    return std::equal(word.begin(), word.end(), token.begin(), token.end(), [](char w, char t) {
        return w == (t >= 'A' && t <= 'Z' ? static_cast<char>(t - 'A' + 'a') : t);
    });
}

std::string refuse_foreign(std::string_view bytes, const char* format) {
    if (bytes.find_first_not_of(" \t\r\n") == std::string_view::npos) return "the file is empty";
    const auto foreign = obj::recognise_foreign(bytes);
    return foreign.empty() || foreign == format ? std::string() : "this is " + std::string(foreign) + ", not " + format;
}

std::int64_t line_of(std::string_view text, std::size_t byte) {
    LineScanner scanner(text.substr(0, byte));
    while (scanner.bytes_left() > 0)
        scanner.skip_line();
    return scanner.line();
}

bool LineScanner::next_line() {
    if (started_) skip_line();
    started_ = true;
    for (; at_ != text_.size(); skip_line()) {
        while (at_ != text_.size() && is_blank(text_[at_]))
            ++at_;
        if (!at_line_end() && !at_comment()) return true;
    }
    return false;
}

std::string_view LineScanner::next_token() {
    while (at_ != text_.size() && is_blank(text_[at_]))
        ++at_;
    const std::size_t first = at_;
    while (!at_line_end() && !is_blank(text_[at_]) && !at_comment())
        ++at_;
    return text_.substr(first, at_ - first);
}

std::string_view LineScanner::next_word() {
    for (;;) {
        if (const auto token = next_token(); !token.empty()) return token;
        if (!next_line()) return {};
    }
}

void LineScanner::skip_line() {
    while (!at_line_end())
        ++at_;
    if (at_ == text_.size()) return;
    at_ += text_[at_] == '\r' && at_ + 1 != text_.size() && text_[at_ + 1] == '\n' ? 2 : 1;
    ++line_;
}

}  // namespace polylap::io
