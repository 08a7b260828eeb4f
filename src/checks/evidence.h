#pragma once

#include <string>
#include <utility>
#include <vector>

namespace checks {

/// What a check found: a sentence for each thing it looked at.
class Evidence
{
public:
    /// Notes what was looked at. If it is not as it should be, the check has failed.
    void require(bool as_it_should_be, std::string sentence, std::string sentence_otherwise)
    {
        passed_ = passed_ && as_it_should_be;
        sentences_.push_back(as_it_should_be ? std::move(sentence) : std::move(sentence_otherwise));
    }

    bool passed() const { return passed_ && !sentences_.empty(); }
    const std::vector<std::string>& sentences() const { return sentences_; }

private:
    bool passed_ = true;
    std::vector<std::string> sentences_;
};

} // namespace checks
