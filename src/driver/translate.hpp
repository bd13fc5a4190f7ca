#pragma once
/// A program as a program of another control, or of the same one: run, written by a post, and run again as that control
/// reads it.

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "compare/compare.hpp"
#include "driver/session.hpp"
#include "write/post.hpp"
#include "write/writer.hpp"

namespace obrys::driver {

/// The post that a call names: a shipped one, a file (.toml), or the name of a control, which stands for that of its
/// mills or lathes; "same" is the program's own. Nothing, with what is wrong in the session's diagnostics, where there
/// is none.
[[nodiscard]] std::optional<write::Post> find_post(const std::string& name, Session& session);

/// What was written, and what it was written from.
struct Translated {
    std::string text;
    compare::Path path{0};  ///< what the program does
};

/// Runs the main program and writes it; `name` is what its head calls it. `note` gets what is expanded or lost. Moves
/// no longer than `same_place` (mm) do not count in the path.
[[nodiscard]] Translated translate(Session& session, const write::Post& post, const std::string& name,
                                   double same_place, const std::function<void(write::Note)>& note);

/// The text run on its control, with the machine, the tools and the zeros of the program that it comes from.
struct Proof {
    Session session;
    std::optional<compare::Result> result;  ///< nothing: it could not be run
};
/// `request` and `of` are those of the program. Null: no control that can be read is named by the post.
[[nodiscard]] std::unique_ptr<Proof> prove(const Translated& translated, const write::Post& post, Request request,
                                           const Session& of, const compare::Tolerance& tolerance);

}  // namespace obrys::driver
