#pragma once
/// What became of every cycle, special function and call of a translation: one entry for each place of the program and
/// what came of it there, however often it was run.

#include <functional>
#include <unordered_map>
#include <vector>

#include "driver/session.hpp"
#include "report/ledger/ledger.hpp"
#include "write/note.hpp"

namespace obrys::driver {

class Ledger {
public:
    struct Entry {
        write::Note note;
        std::uint64_t times = 1;
    };
    /// False where the same stands there already.
    bool add(const write::Note& note, std::uint64_t times = 1);
    [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
    [[nodiscard]] bool has_lost() const { return lost_; }

private:
    std::vector<Entry> entries_;
    std::unordered_multimap<std::size_t, std::size_t> index_;  ///< by a hash of place, fate and words
    bool lost_ = false;
};

/// What was not understood or not run of the program cannot be in what is written. To be called once, behind the run.
void add_not_understood(Ledger& ledger, const Session& session, interp::Ending ending);

struct WrittenFile {
    std::string name, text;
};
/// As documents show it, without the texts themselves; `output`: the program's name.
[[nodiscard]] report::Ledger shown(const Ledger& ledger, const Session& session, const std::string& output);
/// With the texts that it points into, for pages.
void add_texts(report::Ledger& ledger, const Ledger& of, const Session& session, std::vector<WrittenFile> outputs);

}  // namespace obrys::driver
