#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mesh {

/// What is wrong with a piece of input, as a sentence without its full stop; empty: nothing is.
using Cause = std::string;

/// Walks through the statements of an OBJ text, and through the words of each.
/// It copies nothing, so a statement of any length, continued over any number of lines, costs its length
/// once.
class ObjStatements
{
public:
    /// `text` must outlive this object. A UTF-8 byte order mark at its start is skipped.
    explicit ObjStatements(std::string_view text);

    /// Moves on to the next statement that has a word, past what is left of this one; false at the end of the
    /// text.
    bool next_statement();

    /// Returns the statement's next word; empty at its end. `#` at the start of a word ends the statement.
    std::string_view next_word();

    /// The 1-based line on which the current statement begins.
    int statement_line() const { return statement_line_; }

    /// The 1-based line of the word read last; it differs from statement_line() after a continued line.
    int word_line() const { return word_line_; }

private:
    bool at_line_end() const;
    std::size_t continuation_length() const;
    void skip_line_end();
    void skip_blanks();
    void skip_comment();

    std::string_view text_;
    std::size_t at_ = 0;
    bool in_statement_ = false;
    int line_ = 1;
    int statement_line_ = 1;
    int word_line_ = 1;
};

/// What check_obj_text found, and on which 1-based line (0: the whole text).
struct TextFault
{
    int line = 0;
    Cause cause;
};

/// Finds out whether `text` can be an OBJ text at all: not empty, not too long, no over-long line, no binary
/// data.
TextFault check_obj_text(std::string_view text);

} // namespace mesh
