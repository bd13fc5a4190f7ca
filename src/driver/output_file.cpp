#include "driver/output_file.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <random>

#ifndef _WIN32
#include <unistd.h>
#endif

#include "base/text.hpp"

namespace obrys::driver {

namespace {

/// Neighbours that are not finished, for the signal handler: it may touch nothing that allocates or locks.
struct Slot {
    volatile std::sig_atomic_t used = 0;
    std::array<char, 4096> path{};
};
std::array<Slot, 32> slots;

#ifndef _WIN32
volatile pid_t owner = 0;

extern "C" void clean_up(int signal) {
    // A process that was forked off has nothing to take away.
    if (getpid() == owner)
        for (Slot& s : slots)
            if (s.used != 0) unlink(s.path.data());
    std::signal(signal, SIG_DFL);
    raise(signal);
}
#endif

int take_slot(const std::string& path) {
    for (std::size_t i = 0; i < slots.size(); ++i) {
        if (slots[i].used != 0 || path.size() >= slots[i].path.size()) continue;
        std::memcpy(slots[i].path.data(), path.c_str(), path.size() + 1);
        slots[i].used = 1;
        return static_cast<int>(i);
    }
    return -1;
}

/// What a chain of links leads to, there or not.
fs::path without_links(fs::path path) {
    constexpr int most = 40;
    std::error_code error;
    for (int i = 0; i < most && fs::is_symlink(fs::symlink_status(path, error)); ++i) {
        const fs::path to = fs::read_symlink(path, error);
        if (error) break;
        path = to.is_absolute() ? to : path.parent_path() / to;
    }
    return path;
}

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// A name beside the target that nobody has.
fs::path neighbour(const fs::path& target) {
    std::random_device random;
    return folder_of(target) / ("." + target.filename().string() + "." + std::to_string(random()) + ".part");
}

bool is_special(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

std::string words_of(int error) { return std::generic_category().message(error); }

/// Why this file may not be written; empty where it may.
std::string refusal(const Wanted& w, const std::vector<fs::path>& inputs, bool force) {
    const fs::path path(w.path);
    if (is_special(path)) return {};
    for (const fs::path& input : inputs)
        if (is_same_file(path, input))
            return w.path + " is an input of this job (" + input.generic_string() + "): it is not overwritten";
    std::error_code error;
    const fs::path target = without_links(path);
    const fs::file_status there = fs::status(target, error);
    if (fs::is_directory(there)) return w.path + " is a folder";
    if (fs::is_symlink(fs::symlink_status(target, error))) return w.path + " cannot be written: " + words_of(ELOOP);
    if (fs::exists(there) && !force) return w.path + " exists; --force replaces it";
    const fs::file_status folder = fs::status(folder_of(target), error);
    if (!fs::exists(folder)) return w.path + " cannot be written: " + words_of(error ? error.value() : ENOENT);
    if (!fs::is_directory(folder)) return w.path + " cannot be written: " + words_of(ENOTDIR);
#ifndef _WIN32
    if (fs::exists(there) && access(target.c_str(), W_OK) != 0)
        return w.path + " cannot be written: " + words_of(errno);
#endif
    return {};
}

}  // namespace

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code error;
    if (fs::equivalent(a, b, error)) return true;
    const fs::path x = without_links(a), y = without_links(b);
    return x.filename() == y.filename() && fs::equivalent(folder_of(x), folder_of(y), error);
}

bool is_standard_output(std::string_view path) { return path.empty() || path == "-" || path == "/dev/stdout"; }

namespace {

/// Puts the finished neighbour in the place of the target; a file that has other names keeps them, and its content goes
/// through to them all.
void put_in_place(const fs::path& part, const fs::path& target, std::error_code& error) {
    const fs::file_status before = fs::status(target, error);  // its rights stay
    if (fs::exists(before)) fs::permissions(part, before.permissions(), error);
    if (fs::exists(before) && fs::hard_link_count(target, error) > 1) {
        fs::copy_file(part, target, fs::copy_options::overwrite_existing, error);
        std::error_code ignored;
        if (!error) fs::remove(part, ignored);
        return;
    }
    fs::rename(part, target, error);
}

}  // namespace

OutputFile::OutputFile(const fs::path& path) {
    errno = 0;
    if (is_standard_output(path.string())) {
        file_ = stdout;
        return;
    }
    if (is_special(path)) {
        file_ = std::fopen(path.string().c_str(), "wb");
        if (file_ == nullptr) fail();
        return;
    }
    target_ = without_links(path);
#ifndef _WIN32
    std::error_code ignored;
    if (fs::exists(target_, ignored) && access(target_.c_str(), W_OK) != 0) {  // locked on purpose
        fail();
        return;
    }
#endif
    part_ = neighbour(target_);
    slot_ = take_slot(part_.string());
    file_ = std::fopen(part_.string().c_str(), "wbx");
    if (file_ != nullptr) return;
    fail();
    part_.clear();
}

OutputFile::~OutputFile() { discard(); }

void OutputFile::fail() {
    if (error_ == 0) error_ = errno != 0 ? errno : EIO;
}

void OutputFile::discard() {
    if (file_ != nullptr && file_ != stdout) std::fclose(file_);
    file_ = nullptr;
    std::error_code ignored;
    if (!part_.empty()) fs::remove(part_, ignored);
    part_.clear();
    if (slot_ >= 0) slots[static_cast<std::size_t>(slot_)].used = 0;
    slot_ = -1;
}

void OutputFile::write(std::string_view text) {
    if (error_ != 0 || file_ == nullptr) return;
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail();
}

bool OutputFile::flush() {
    if (file_ == nullptr || error_ != 0) return false;
    errno = 0;
    if (std::fflush(file_) != 0 || std::ferror(file_) != 0) fail();
    return error_ == 0;
}

bool OutputFile::finish() {
    if (file_ == nullptr || error_ != 0) return false;
    static_cast<void>(flush());
    if (file_ == stdout) return error_ == 0;
    std::FILE* const file = file_;
    file_ = nullptr;
    if (std::fclose(file) != 0) fail();
    if (error_ == 0 && !part_.empty()) {
        std::error_code error;
        put_in_place(part_, target_, error);
        if (error)
            error_ = error.value();
        else
            part_.clear();
    }
    discard();
    return error_ == 0;
}

std::string OutputFile::error() const { return words_of(error_); }

void clean_up_on_signals() {
#ifndef _WIN32
    owner = getpid();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction old {};
        if (sigaction(signal, nullptr, &old) == 0 && old.sa_handler == SIG_IGN) continue;  // nohup
        std::signal(signal, clean_up);
    }
#endif
}

std::vector<fs::path> inputs_of(const Session& s) {
    std::vector<fs::path> all{s.input};
    for (std::uint32_t i = 0; i < s.sources.size(); ++i) all.emplace_back(s.sources[i].name);
    const auto add = [&](const shop::Solid& solid) {
        if (const auto* file = std::get_if<shop::SolidFile>(&solid)) all.push_back(beside(s.input, file->path));
    };
    if (s.job.solid_stock) add(s.job.solid_stock->solid);
    if (s.job.solid_part) all.push_back(beside(s.input, s.job.solid_part->file.path));
    for (const shop::Clamp& c : s.job.clamps) add(c.solid);
    // Where the job cannot be used, these were not loaded.
    for (const auto* files : {&s.job.datum_tables, &s.job.preset_tables, &s.job.tool_files, &s.job.variables_files})
        for (const shop::NamedFile& f : *files) all.push_back(beside(s.input, f.path));
    if (!s.job.program.empty()) all.push_back(beside(s.input, s.job.program));
    if (s.job.machine_is_file) all.push_back(beside(s.input, s.job.machine_name));
    if (s.job.part_program) all.push_back(beside(s.input, s.job.part_program->program));
    if (s.job.allowance && s.job.allowance->program) all.push_back(beside(s.input, s.job.allowance->program->program));
    return all;
}

std::vector<std::string> refusals(const std::vector<Wanted>& wanted, const std::vector<fs::path>& inputs, bool force) {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const Wanted& w = wanted[i];
        if (is_standard_output(w.path)) {
            for (std::size_t k = 0; k < i; ++k)
                if (is_standard_output(wanted[k].path))
                    out.push_back(wanted[k].option + " and " + w.option + " both go to standard output");
            continue;
        }
        if (const std::string why = refusal(w, inputs, force); !why.empty()) out.push_back(w.option + ": " + why);
        for (std::size_t k = 0; k < i; ++k)
            if (!is_standard_output(wanted[k].path) && !is_special(w.path) && is_same_file(w.path, wanted[k].path))
                out.push_back(wanted[k].option + " and " + w.option + " name the same file: " + w.path);
    }
    return out;
}

}  // namespace obrys::driver
