#include "write/note.hpp"

namespace obrys::write {

std::string sentence_of(const Note& note) {
    const std::string fate = note.fate == Fate::lost ? "is not written" : std::string(note.instead);
    const std::size_t reason = note.what.find(": ");
    if (reason == std::string::npos) return note.what + " " + fate;
    return note.what.substr(0, reason) + " " + fate + note.what.substr(reason);
}

}  // namespace obrys::write
