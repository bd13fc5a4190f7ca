"""The tables of docs/round-trips.md: what became of programs that were written anew for their own control."""
import collections
import re

HEAD = """# Round trips

Programs written anew for their own control, and the stream of what was written held to that of the program by `obrys compare`; by `tests/translate/round_trip.py`.

| word | means |
|---|---|
| equal | every record is there again: moves, feeds, spindle, coolant, tools, events, and also cycles, calls, prepared tools, frames and compensation |
| done the same | the machine does the same; something is said otherwise: a cycle by its moves, a call by its blocks, a frame by workpiece coordinates |
| lost | something has no word in the post: the translation says what and by name, and writes nothing without `--accept-loss` |
| not known | it depends on a value that nobody knows (a parameter that is not set, a place no block has given), so that there is no word to write |
| stops | the program itself stops with an alarm or is passed by in part |
| differs | none of these |

A program *runs* where `obrys run` says exit code 0: understood as a whole, nothing unknown. Of files that move nothing (libraries of subprograms that nobody calls there, tests of messages) the
equality says little: they are counted, and not in the shares.

What is written for LinuxCNC also runs in LinuxCNC's own rs274 (`tests/translate/rs274_referee.py`): the moves of all but four of the programs that rs274 takes end at the same places as those of the program that they come
from; the four are named in that script, with why.

"""
SAME = ("equal", "done the same")
RUNS, COMPLAINS, NOTHING = "runs", "runs with complaints", "moves nothing"
NOT_READ = "not read"


def class_of(o):
    return NOTHING if o.moves == 0 else RUNS if o.code == 0 else COMPLAINS


def row(name, cells):
    return f"| {name} | " + " | ".join(str(c) if c else "" for c in cells) + " |"


def percent(part, outcomes):
    return f"{100 * part / len(outcomes):.1f} %" if outcomes else ""


def counts(outcomes):
    kinds = collections.Counter("lost" if o.kind == "lost, said" else o.kind for o in outcomes)
    same = sum(kinds[k] for k in SAME)
    other = len(outcomes) - sum(kinds[k] for k in (*SAME, "lost", "not known", "stops"))
    return [len(outcomes), kinds["equal"], kinds["done the same"], kinds["lost"], kinds["not known"], kinds["stops"], other,
            percent(kinds["equal"], outcomes), percent(same, outcomes)]


def cause_of(o):
    """The first thing that is lost, else what differs first; numbers and names as one."""
    what = o.what.split(" | ")[-1]
    found = re.search(r"error: (?:line [0-9]+: )?(.*?) is not written", what)
    if found:
        return re.sub(r"(axis|tool|zero|output|function) [A-Z0-9]+", r"\1 N", found[1])
    return f"{o.aspect} differs"


def page(groups, reasons):
    out = [HEAD]
    head = ["programs", "equal", "done the same", "lost", "not known", "stops", "differ", "every record", "the same"]
    for title, outcomes in groups.items():
        unread = [o for o in outcomes if o.kind == NOT_READ]
        outcomes = [o for o in outcomes if o.kind != NOT_READ]
        if not outcomes:
            continue
        out.append(f"## {title}\n\n" + row("control, and how it runs", head) + "\n" + "|---" * (len(head) + 1) + "|")
        for control in sorted({o.control for o in outcomes}):
            for kind in (RUNS, COMPLAINS, NOTHING):
                part = [o for o in outcomes if o.control == control and class_of(o) == kind]
                if part:
                    out.append(row(f"{control or 'not known'}, {kind}", counts(part)))
        for kind in (RUNS, COMPLAINS, NOTHING):
            part = [o for o in outcomes if class_of(o) == kind]
            out.append(row(f"**all, {kind}**", counts(part)))
        part = [o for o in outcomes if class_of(o) == RUNS]
        if part:
            equal, same = sum(o.kind == "equal" for o in part), sum(o.kind in SAME for o in part)
            out.append(f"\nOf {len(part)} programs that run and move, {equal} are equal in every record ({percent(equal, part)}) "
                       f"and {same} do the same ({percent(same, part)}).")
        if unread:
            out.append(f"\nBesides, {len(unread)} files are not there: of formats that no post writes (APT, Fusion's), or what cannot be read at all.")
        left = [o for o in outcomes if o.kind not in SAME]
        named = [o for o in left if class_of(o) == RUNS or o.kind not in ("not known", "stops", "lost, said")]
        if named:
            out.append("\nWhat is not the same, by name:\n\n| program | what | why |\n|---|---|---|")
            out += [row(o.name.replace("|", " "), [o.kind.split(",")[0].lower(), reasons.get(o.name) or cause_of(o)]) for o in named]
        rest = collections.Counter((o.kind.split(",")[0], cause_of(o)) for o in left if o not in named)
        if rest:
            out.append("\nThe others, by their first cause:\n\n| what | first cause | programs |\n|---|---|---|")
            out += [f"| {kind} | {cause} | {n} |" for (kind, cause), n in rest.most_common()]
        out.append("")
    return "\n".join(out)
