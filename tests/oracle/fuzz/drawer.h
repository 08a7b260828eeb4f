#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace oracle::fuzz {

/// A program that draws random programs (draw_main.cpp), run beside this one and asked through pipes.
class Drawer
{
public:
    explicit Drawer(std::string executable) : executable_(std::move(executable)) {}
    Drawer(const Drawer&) = delete;
    Drawer& operator=(const Drawer&) = delete;
    ~Drawer() { stop(); }

    /// Asks for a seed's program, made without the calls that are not kept.
    void ask(unsigned seed, const std::vector<std::size_t>& kept);
    /// Asks for the version of the OpenGL that draws.
    void ask_version();
    /// Returns the pixels asked for and what was told; less than the pixels when the drawer ended.
    std::string answer();

private:
    void start();
    void stop();

    const std::string executable_;
    int process_ = -1;
    std::FILE* to_ = nullptr;
    std::FILE* from_ = nullptr;
};

} // namespace oracle::fuzz
