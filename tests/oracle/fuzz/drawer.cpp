#include "fuzz/drawer.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace oracle::fuzz {

void Drawer::start()
{
    std::signal(SIGPIPE, SIG_IGN);
    int wishes[2], answers[2];
    // Closed in the programs started, or another one would keep this one's input open.
    if (pipe2(wishes, O_CLOEXEC) != 0 || pipe2(answers, O_CLOEXEC) != 0) {
        std::abort();
    }
    process_ = fork();
    if (process_ == 0) {
        dup2(wishes[0], STDIN_FILENO);
        dup2(answers[1], STDOUT_FILENO);
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
    if (process_ < 0) {
        return;
    }
    std::fclose(to_);
    std::fclose(from_);
    waitpid(process_, nullptr, 0);
    process_ = -1;
}

void Drawer::ask(unsigned seed, const std::vector<std::size_t>& kept)
{
    if (process_ < 0) {
        start();
    }
    std::fprintf(to_, "%u", seed);
    for (const std::size_t i : kept) {
        std::fprintf(to_, " %zu", i);
    }
    std::fprintf(to_, "\n");
    std::fflush(to_);
}

void Drawer::ask_version()
{
    if (process_ < 0) {
        start();
    }
    std::fprintf(to_, "version\n");
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
