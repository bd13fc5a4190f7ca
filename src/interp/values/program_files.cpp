/// Programs by the names that calls give them.

#include "base/codes.hpp"
#include "base/text.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

using program::Call;
namespace codes = base::codes;

std::string program_name(std::string_view written) {
    std::string s = base::to_upper(base::trim(written));
    if (const auto slash = s.find_last_of("/\\:"); slash != std::string::npos) s.erase(0, slash + 1);
    if (s.starts_with("_N_")) s.erase(0, 3);
    for (const std::string_view suffix : {"_SPF", "_MPF", ".SPF", ".MPF", ".H"})
        if (s.ends_with(suffix)) s.resize(s.size() - suffix.size());
    return s;
}

const Unit* find_program(Saying& run, const std::string& name, const base::Span& where, const Call* call) {
    if (const Unit* unit = run.env.find_program(name)) return unit;
    if (run.traits->missing_program_stops) {
        refuse_call(run, name, call);
        return nullptr;
    }
    unchecked(run, codes::missing_subprogram, where, "the program " + name + " was not found; the call is left out",
              "put its file beside the calling program or name the folder with --search");
    return nullptr;
}

bool find_file(Saying& run, const std::string& written) {
    return run.env.find_program(program_name(written)) != nullptr;
}

const Unit* find_named_program(Saying& run, const std::string& written, const base::Span& where) {
    return find_program(run, program_name(written), where);
}

void refuse_call(Saying& run, const std::string& name, const program::Call* call) {
    const base::Span where = call != nullptr ? call->where : run.here();
    const bool by_m98 = call != nullptr && call->shares_parameters;
    const std::string shown = by_m98 || !name.starts_with("O") ? name : "o" + name.substr(1);
    alarm(run, codes::missing_subprogram, where,
          "there is no subprogram " + shown + ": not in this text" +
              (run.env.searched.empty() ? "" : ", and no file of it in " + std::string(run.env.searched)),
          "put its file beside the calling program or name the folder with --search");
}

}  // namespace obrys::interp
