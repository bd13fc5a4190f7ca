#pragma once
/// What a stretch of the program that is only looked at is complained about, kept until its caller says it. Private to
/// interp.

#include <set>
#include <tuple>
#include <vector>

#include "base/diagnostic.hpp"
#include "interp/say.hpp"

namespace obrys::interp {

struct Complaint {
    base::Diagnostic what;
    bool ends_run = false;       ///< an alarm
    bool once_by_text = false;   ///< wherever it comes up
    bool once_by_place = false;  ///< of the same code
};

class Complaints {
public:
    /// The same again is passed over: loops are run while looking ahead, too.
    void add(Complaint c);
    [[nodiscard]] const std::vector<Complaint>& all() const { return all_; }

private:
    std::vector<Complaint> all_;
    std::set<std::string> texts_;
    std::set<std::tuple<std::string_view, std::uint32_t, std::uint32_t>> places_;
};

/// Makes them as if the blocks were run now; an alarm is that of `of` (a cycle), where it has a name.
void say(Saying&, const Complaints&, const std::string& of = {});

/// A finding of the run itself: it is said as it is, and the run goes on.
void raise(Saying&, base::Diagnostic);

}  // namespace obrys::interp
