#include "fuzz/drawer.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace oracle::fuzz {

void Drawer::start()
{
    std::signal(SIGPIPE, SIG_IGN);
    int wishes[2], answers[2];
    if (pipe(wishes) != 0 || pipe(answers) != 0)
        std::abort();
    process_ = fork();
    if (process_ == 0) {
        dup2(wishes[0], STDIN_FILENO);
        dup2(answers[1], STDOUT_FILENO);
        for (const int file : {wishes[0], wishes[1], answers[0], answers[1]})
            close(file);
        execl(executable_.c_str(), executable_.c_str(), static_cast<char*>(nullptr));
        _exit(127);
    }
    close(wishes[0]);
    close(answers[1]);
    to_ = fdopen(wishes[1], "w");
    from_ = fdopen(answers[0], "r");
}

void Drawer::stop()
{
    if (process_ < 0)
        return;
    std::fclose(to_);
    std::fclose(from_);
    waitpid(process_, nullptr, 0);
    process_ = -1;
}

void Drawer::ask(unsigned seed, const std::vector<std::size_t>& kept)
{
    if (process_ < 0)
        start();
    std::fprintf(to_, "%u", seed);
    for (const std::size_t i : kept)
        std::fprintf(to_, " %zu", i);
    std::fprintf(to_, "\n");
    std::fflush(to_);
}

std::string Drawer::answer()
{
    std::size_t size = 0;
    if (std::fscanf(from_, "%zu", &size) != 1 || std::fgetc(from_) != '\n') {
        stop(); // It has ended; the next one starts anew.
        return "";
    }
    std::string bytes(size, '\0');
    bytes.resize(std::fread(bytes.data(), 1, size, from_));
    return bytes;
}

} // namespace oracle::fuzz
