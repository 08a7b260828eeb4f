#include "mesh/obj_statements.h"

#include "mesh/obj_reader.h"

namespace mesh {
namespace {

constexpr std::string_view UTF8_MARK = "\xEF\xBB\xBF";
constexpr char DOS_END_OF_FILE = '\x1A'; // some old programs end their text files with it

bool is_line_end(char c)
{
    return c == '\n' || c == '\r';
}

bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/// The length of the line end at `at`: CR LF counts as one.
std::size_t line_end_length(std::string_view text, std::size_t at)
{
    return text[at] == '\r' && at + 1 < text.size() && text[at + 1] == '\n' ? 2 : 1;
}

bool is_control(char c)
{
    return static_cast<unsigned char>(c) < 0x20 && !is_blank(c) && !is_line_end(c);
}

} // namespace

ObjStatements::ObjStatements(std::string_view text) : text_(text)
{
    if (text_.substr(0, UTF8_MARK.size()) == UTF8_MARK) {
        at_ = UTF8_MARK.size();
    }
    if (!text_.empty() && text_.back() == DOS_END_OF_FILE) {
        text_.remove_suffix(1);
    }
}

bool ObjStatements::at_line_end() const
{
    return at_ >= text_.size() || is_line_end(text_[at_]);
}

/// How long a continuation, a backslash and the line end after it, is here; 0 where there is no continuation.
std::size_t ObjStatements::continuation_length() const
{
    if (text_[at_] != '\\') {
        return 0;
    }
    if (at_ + 1 >= text_.size()) {
        return 1; // the text ends where its last line should have been continued
    }
    return is_line_end(text_[at_ + 1]) ? 1 + line_end_length(text_, at_ + 1) : 0;
}

void ObjStatements::skip_line_end()
{
    at_ += line_end_length(text_, at_);
    ++line_;
}

void ObjStatements::skip_blanks()
{
    while (at_ < text_.size()) {
        if (is_blank(text_[at_])) {
            ++at_;
        } else if (const std::size_t length = continuation_length(); length > 0) {
            at_ += length;
            ++line_;
        } else {
            return;
        }
    }
}

void ObjStatements::skip_comment()
{
    while (!at_line_end()) { // a backslash does not continue a comment: it often ends a Windows path
        ++at_;
    }
}

bool ObjStatements::next_statement()
{
    if (in_statement_) {
        while (!next_word().empty())
            ;
        skip_comment();
        in_statement_ = false;
    }
    while (at_ < text_.size()) {
        if (is_line_end(text_[at_])) {
            skip_line_end();
        } else if (text_[at_] == '#') {
            skip_comment();
        } else if (is_blank(text_[at_]) || continuation_length() > 0) {
            skip_blanks();
        } else {
            statement_line_ = word_line_ = line_;
            in_statement_ = true;
            return true;
        }
    }
    return false;
}

std::string_view ObjStatements::next_word()
{
    skip_blanks();
    if (at_line_end() || text_[at_] == '#') {
        return {};
    }
    word_line_ = line_;
    const std::size_t begin = at_;
    while (!at_line_end() && !is_blank(text_[at_]) && continuation_length() == 0) {
        ++at_;
    }
    return text_.substr(begin, at_ - begin);
}

TextFault check_obj_text(std::string_view text)
{
    if (text.size() > MAX_OBJ_BYTES) {
        return {0, "the file has " + std::to_string(text.size() >> 20) + " MB and at most " +
                       std::to_string(MAX_OBJ_BYTES >> 20) +
                       " MB are read; reduce the number of polygons or split the model"};
    }
    const std::string_view start = text.substr(0, 2);
    if (start == "\xFF\xFE" || start == "\xFE\xFF") {
        return {1, "the text is stored as UTF-16; save it as UTF-8 or plain ASCII"};
    }

    int line = 1;
    std::size_t line_begin = 0;
    bool only_blanks = true;
    for (std::size_t at = 0; at < text.size();) {
        if (is_line_end(text[at])) {
            at += line_end_length(text, at);
            line_begin = at;
            ++line;
            continue;
        }
        if (is_control(text[at]) && !(text[at] == DOS_END_OF_FILE && at + 1 == text.size())) {
            return {line, "there is binary data here (a byte of value " +
                              std::to_string(static_cast<unsigned char>(text[at])) +
                              "); this is not an OBJ text file"};
        }
        if (at - line_begin >= MAX_OBJ_LINE_BYTES) {
            return {line, "the line is longer than " + std::to_string(MAX_OBJ_LINE_BYTES) +
                              " bytes; this is hardly an OBJ text file"};
        }
        only_blanks = only_blanks && is_blank(text[at]);
        ++at;
    }
    if (only_blanks) {
        return {0, "the file is empty"};
    }
    return {};
}

} // namespace mesh
