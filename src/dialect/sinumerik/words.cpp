#include <algorithm>
#include <iterator>

#include "dialect/sinumerik/holes.hpp"
#include "dialect/sinumerik/tables.hpp"

namespace obrys::dialect::sinumerik {

namespace {

using program::Code;
using program::ControlCycle;
using program::FrameOp;
using program::Modal;
using program::NamedKind;
using program::Procedure;

constexpr Entry run(std::string_view n, Modal m) { return {n, Use::modal, static_cast<std::uint16_t>(m), 0, {}}; }
constexpr Entry value(std::string_view n, Code c) { return {n, Use::address, static_cast<std::uint16_t>(c), 0, {}}; }
constexpr Entry named(std::string_view n, NamedKind k) {
    return {n, Use::named_value, static_cast<std::uint16_t>(k), 0, {}};
}
constexpr Entry off(std::string_view n) { return {n, Use::ignored, 0, 0, {}}; }
constexpr Entry no(std::string_view n, std::string_view reason) { return {n, Use::unsupported, 0, 0, reason}; }
constexpr Entry block(std::string_view n, std::string_view reason) { return {n, Use::unsupported_block, 0, 0, reason}; }
constexpr Entry proc(std::string_view n, Procedure p) {
    return {n, Use::procedure, static_cast<std::uint16_t>(p), 0, {}};
}
constexpr Entry st(std::string_view n, Keyword k) { return {n, Use::statement, static_cast<std::uint16_t>(k), 0, {}}; }
constexpr Entry frame(std::string_view n, FrameOp op, std::uint16_t additive) {
    return {n, Use::frame, static_cast<std::uint16_t>(op), additive, {}};
}

// Why a known word is not run.
constexpr std::string_view iso_dialect_program = "ISO dialect program";
constexpr std::string_view approach = "approach of the compensation";
constexpr std::string_view axis_coupling = "axis coupling";
constexpr std::string_view axis_spindle_exchange = "axis or spindle exchange";
constexpr std::string_view channel_coordination = "channel coordination";
constexpr std::string_view contour_preparation = "contour preparation";
constexpr std::string_view diameter_programming_by_axis = "diameter programming by axis";
constexpr std::string_view display_dialog = "display or dialog";
constexpr std::string_view feed_override_by_the_program = "feed override by the program";
constexpr std::string_view file_data_access = "file or data access";
constexpr std::string_view interrupt_routine = "interrupt routine";
constexpr std::string_view kinematic_transformation = "kinematic transformation";
constexpr std::string_view machine_function = "machine function";
constexpr std::string_view machining_cycle = "machining cycle of the control";
constexpr std::string_view measuring = "measuring";
constexpr std::string_view oscillation_grinding_function = "oscillation or grinding function";
constexpr std::string_view polynomial_function = "polynomial function";
constexpr std::string_view positioning_indexing_axis = "positioning or indexing axis";
constexpr std::string_view protection_zone = "protection zone";
constexpr std::string_view punching_nibbling = "punching and nibbling";
constexpr std::string_view retract_stop_reaction = "retract or stop reaction";
constexpr std::string_view spline_polynomial_interpolation = "spline or polynomial interpolation";
constexpr std::string_view synchronized_action = "synchronized action";
constexpr std::string_view tool_management = "tool management";
constexpr std::string_view tool_offset_changed_by_the_program = "tool offset changed by the program";
constexpr std::string_view tool_orientation = "tool orientation";
constexpr std::string_view tool_oriented_frame = "tool-oriented frame";

constexpr Entry cycle(std::string_view n, ControlCycle c = ControlCycle::not_run, std::uint16_t form = 0) {
    return {n, Use::control_cycle, static_cast<std::uint16_t>(c), form, machining_cycle};
}
constexpr Entry hole(std::string_view n) { return cycle(n, ControlCycle::hole, form_of(n)); }

// clang-format off
constexpr Entry words[]{
    no("A2", tool_orientation), no("A3", tool_orientation), no("A4", tool_orientation), no("A5", tool_orientation),
    off("ACC"), off("ACCLIM"), off("ACCLIMA"), off("ACTBLOCNO"), named("ADIS", NamedKind::rounding_distance), named("ADISPOS", NamedKind::rounding_distance_rapid), off("ADISPOSA"),
    off("ALF"), frame("AMIRROR", FrameOp::mirror, 1), value("ANG", Code::line_angle), value("AP", Code::polar_angle),
    value("AR", Code::opening_angle), frame("AROT", FrameOp::rotate, 1), no("AROTS", tool_oriented_frame),
    frame("ASCALE", FrameOp::scale, 1), no("ASPLINE", spline_polynomial_interpolation), off("ATOL"),
    frame("ATRANS", FrameOp::shift, 1), off("AUXFUDEL"), value("AX", Code::named_axis),
    no("AXCTSWE", axis_spindle_exchange), no("AXCTSWEC", axis_spindle_exchange),
    no("AXCTSWED", axis_spindle_exchange), no("AXTOCHAN", axis_spindle_exchange), no("B2", tool_orientation),
    no("B3", tool_orientation), no("B4", tool_orientation), no("B5", tool_orientation), off("BAUTO"),
    no("BLSYNC", machine_function), off("BNAT"), off("BRISK"), off("BRISKA"),
    no("BSPLINE", spline_polynomial_interpolation), off("BTAN"), no("C2", tool_orientation),
    no("C3", tool_orientation), no("C4", tool_orientation), no("C5", tool_orientation),
    no("CAC", positioning_indexing_axis), no("CACN", positioning_indexing_axis),
    no("CACP", positioning_indexing_axis), no("CALCFIR", machine_function), no("CALCPOSI", contour_preparation),
    st("CALL", Keyword::call), block("CANCEL", synchronized_action), st("CASE", Keyword::case_),
    no("CDC", positioning_indexing_axis), off("CDOF"), off("CDOF2"), off("CDON"), run("CFC", Modal::feed_at_contour),
    no("CFG", file_data_access), run("CFIN", Modal::feed_at_inside), run("CFTCP", Modal::feed_at_tool),
    no("CHECKSUM", file_data_access), value("CHF", Code::chamfer_length), no("CHKDM", tool_management),
    no("CHKDN", tool_management), no("CHKDNO", tool_management), value("CHR", Code::chamfer_leg),
    no("CIC", positioning_indexing_axis), run("CIP", Modal::arc_via), no("CLEARM", channel_coordination),
    no("CLEARMC", channel_coordination), off("CLGOF"), no("CLGON", oscillation_grinding_function), off("CLRINT"),
    off("COARSEA"), no("COLLPAIR", machine_function), run("COMPCAD", Modal::compressor_on), run("COMPCURV", Modal::compressor_on), run("COMPOF", Modal::compressor_off), run("COMPON", Modal::compressor_on),
    no("COMPSPL", spline_polynomial_interpolation), run("COMPSURF", Modal::compressor_on), no("CONTDCON", contour_preparation),
    no("CONTPRON", contour_preparation), no("CORRTC", tool_offset_changed_by_the_program),
    no("COUPDEF", axis_coupling), no("COUPDEL", axis_coupling), no("COUPOF", axis_coupling),
    no("COUPOFS", axis_coupling), no("COUPON", axis_coupling), no("COUPONC", axis_coupling),
    no("COUPRES", axis_coupling), off("CP"), no("CPDEF", axis_coupling), no("CPDEL", axis_coupling),
    no("CPLA", axis_coupling), no("CPLDEF", axis_coupling), no("CPLDEN", axis_coupling), no("CPLNUM", axis_coupling),
    no("CPLOF", axis_coupling), no("CPLON", axis_coupling), no("CPOF", axis_coupling), no("CPON", axis_coupling),
    off("CPRECOF"), off("CPRECON"), block("CPROT", protection_zone), block("CPROTDEF", protection_zone),
    value("CR", Code::radius), no("CROTS", tool_oriented_frame), no("CSPLINE", spline_polynomial_interpolation),
    run("CT", Modal::arc_tangent), no("CTABDEF", axis_coupling), no("CTABDEL", axis_coupling),
    no("CTABEND", axis_coupling), named("CTOL", NamedKind::contour_tolerance), run("CUT2D", Modal::compensation_in_plane), no("CUT2DD", kinematic_transformation),
    run("CUT2DF", Modal::compensation_in_frame), no("CUT2DFD", kinematic_transformation),
    no("CUT3DC", kinematic_transformation), no("CUT3DCC", kinematic_transformation),
    no("CUT3DCCD", kinematic_transformation), no("CUT3DCD", kinematic_transformation),
    no("CUT3DF", kinematic_transformation), no("CUT3DFF", kinematic_transformation),
    no("CUT3DFS", kinematic_transformation), no("CUTCONOF", tool_orientation), no("CUTCONON", tool_orientation),
    no("CUTMOD", tool_orientation), no("CUTMODK", tool_offset_changed_by_the_program),
    cycle("CYCLE435"), cycle("CYCLE495"), cycle("CYCLE60"),
    cycle("CYCLE61"), cycle("CYCLE62"), cycle("CYCLE63"),
    cycle("CYCLE64"), cycle("CYCLE70"), cycle("CYCLE71"),
    cycle("CYCLE72"), cycle("CYCLE73"), cycle("CYCLE74"),
    cycle("CYCLE75"), cycle("CYCLE751"), cycle("CYCLE752"),
    cycle("CYCLE753"), cycle("CYCLE754"), cycle("CYCLE755"),
    cycle("CYCLE756"), cycle("CYCLE757"), cycle("CYCLE758"),
    cycle("CYCLE759"), cycle("CYCLE76"), cycle("CYCLE77"),
    cycle("CYCLE78"), cycle("CYCLE782"), cycle("CYCLE79"),
    cycle("CYCLE800", ControlCycle::swivel), cycle("CYCLE801"), cycle("CYCLE802"),
    cycle("CYCLE805"), cycle("CYCLE806"), hole("CYCLE81"),
    hole("CYCLE82"), hole("CYCLE83"), cycle("CYCLE830"),
    cycle("CYCLE832", ControlCycle::path_tolerance), hole("CYCLE84"), hole("CYCLE840"),
    hole("CYCLE85"), hole("CYCLE86"), hole("CYCLE87"),
    hole("CYCLE88"), hole("CYCLE89"), cycle("CYCLE899"),
    cycle("CYCLE90"), cycle("CYCLE92"), cycle("CYCLE93"),
    cycle("CYCLE930"), cycle("CYCLE94"), cycle("CYCLE940"),
    cycle("CYCLE95"), cycle("CYCLE950"), cycle("CYCLE951"),
    cycle("CYCLE952"), cycle("CYCLE96"), cycle("CYCLE961"),
    cycle("CYCLE97"), cycle("CYCLE971"), cycle("CYCLE973"),
    cycle("CYCLE974"), cycle("CYCLE976"), cycle("CYCLE977"),
    cycle("CYCLE978"), cycle("CYCLE979"), cycle("CYCLE98"),
    cycle("CYCLE982"), cycle("CYCLE99"), cycle("CYCLE994"),
    cycle("CYCLE995"), cycle("CYCLE996"), cycle("CYCLE9960"),
    cycle("CYCLE997"), cycle("CYCLE998"), no("DAC", diameter_programming_by_axis),
    st("DEF", Keyword::def), st("DEFINE", Keyword::define), off("DELAYFSTOF"), off("DELAYFSTON"),
    no("DELDL", tool_management), no("DELDTG", retract_stop_reaction), no("DELETE", file_data_access),
    no("DELT", tool_management), no("DELTOOLENV", tool_management), no("DIACYCOFA", diameter_programming_by_axis),
    run("DIAM90", Modal::diameter_absolute_only), no("DIAM90A", diameter_programming_by_axis),
    no("DIAMCHAN", diameter_programming_by_axis), no("DIAMCHANA", diameter_programming_by_axis),
    no("DIAMCYCOF", diameter_programming_by_axis), run("DIAMOF", Modal::diameter_off),
    no("DIAMOFA", diameter_programming_by_axis), run("DIAMON", Modal::diameter_on),
    no("DIAMONA", diameter_programming_by_axis), no("DIC", diameter_programming_by_axis), off("DISABLE"),
    named("DISC", NamedKind::corner_overshoot), no("DISCL", approach), off("DISPLOF"), off("DISPLON"), no("DISPR", machine_function),
    no("DISR", approach), no("DISRP", approach), off("DITE"), off("DITS"),
    named("DL", NamedKind::sum_offset), block("DO", synchronized_action), off("DRFOF"), off("DRIVE"),
    off("DRIVEA"), off("DYNFINISH"), off("DYNNORM"), off("DYNPOS"), off("DYNPREC"), off("DYNROUGH"),
    off("DYNSEMIFIN"), no("DZERO", tool_management), off("EAUTO"), no("EGDEF", axis_coupling),
    no("EGDEL", axis_coupling), no("EGOFC", axis_coupling), no("EGOFS", axis_coupling), no("EGON", axis_coupling),
    no("EGONSYN", axis_coupling), no("EGONSYNE", axis_coupling), st("ELSE", Keyword::else_), off("ENABLE"),
    off("ENAT"), st("ENDFOR", Keyword::endfor), st("ENDIF", Keyword::endif), st("ENDLOOP", Keyword::endloop),
    st("ENDWHILE", Keyword::endwhile), no("ESRR", retract_stop_reaction), no("ESRS", retract_stop_reaction),
    off("ETAN"), block("EVERY", synchronized_action), value("EX", Code::named_axis),
    proc("EXECSTRING", Procedure::run_text), no("EXECTAB", contour_preparation), no("EXECUTE", contour_preparation),
    st("EXTCALL", Keyword::extcall), no("EXTCLOSE", file_data_access), st("EXTERN", Keyword::extern_),
    no("EXTOPEN", file_data_access), named("FA", NamedKind::axis_feed), no("FAD", approach), named("FB", NamedKind::block_feed),
    block("FCTDEF", polynomial_function), off("FCUB"), no("FD", feed_override_by_the_program),
    no("FDA", feed_override_by_the_program), off("FENDNORM"), off("FFWOF"), off("FFWON"), off("FGREF"), off("FGROUP"),
    off("FIFOCTRL"), no("FILEDATE", file_data_access), no("FILEINFO", file_data_access),
    no("FILESIZE", file_data_access), no("FILESTAT", file_data_access), no("FILETIME", file_data_access),
    off("FINEA"), no("FLIM", machine_function), off("FLIN"), no("FMA", machine_function), off("FNORM"),
    no("FOC", feed_override_by_the_program), no("FOCOF", feed_override_by_the_program),
    no("FOCON", feed_override_by_the_program), st("FOR", Keyword::for_), off("FPO"),
    no("FPR", feed_override_by_the_program), off("FPRAOF"), no("FPRAON", feed_override_by_the_program),
    value("FRC", Code::corner_feed), value("FRCM", Code::corner_feed_modal), no("FRCX", machine_function),
    block("FROM", synchronized_action), no("FTOCOF", file_data_access), no("FTOCON", file_data_access),
    no("FXS", feed_override_by_the_program), no("FXST", feed_override_by_the_program),
    no("FXSW", feed_override_by_the_program), value("FZ", Code::feed_per_tooth),
    no("GEOAX", positioning_indexing_axis), no("GET", axis_spindle_exchange), no("GETACTT", tool_management),
    no("GETACTTD", tool_management), no("GETD", axis_spindle_exchange), no("GETDNO", tool_management),
    no("GETEXET", tool_management), no("GETFREELOC", tool_management), no("GETSELT", tool_management), off("GETT"),
    no("GETTCOR", tool_management), no("GETTENV", tool_management), st("GOTO", Keyword::goto_),
    st("GOTOB", Keyword::gotob), st("GOTOC", Keyword::gotoc), st("GOTOF", Keyword::gotof),
    st("GOTOS", Keyword::gotos), no("GP", machine_function), off("GROUP_ADDEND"),
    off("GROUP_BEGIN"), off("GROUP_END"), no("GWPS", machine_function), off("GWPSOF"),
    no("GWPSON", oscillation_grinding_function), cycle("HOLES1", ControlCycle::hole_row), cycle("HOLES2", ControlCycle::hole_circle),
    block("ICYCOF", synchronized_action), block("ICYCON", synchronized_action), block("ID", synchronized_action),
    block("IDS", synchronized_action), st("IF", Keyword::if_), no("INIT", channel_coordination),
    no("INTERSEC", contour_preparation), no("INVCCW", spline_polynomial_interpolation),
    no("INVCW", spline_polynomial_interpolation), off("IPOBRKA"), off("IPOENDA"), off("IPTRLOCK"), off("IPTRUNLOCK"),
    no("IRPM", machine_function), no("ISD", tool_orientation), no("ISFILE", file_data_access),
    block("ISOCALL", iso_dialect_program), no("ISPOINTS", contour_preparation), off("JERKA"), off("JERKLIM"),
    off("JERKLIMA"), run("KONT", Modal::approach_contour), no("KONTC", approach), no("KONTT", approach),
    no("LEAD", tool_orientation), no("LEADOF", axis_coupling), no("LEADON", axis_coupling),
    no("LENTOAX", tool_management), off("LFOF"), off("LFON"), off("LFPOS"), off("LFTXT"), off("LFWP"),
    off("LIFTFAST"), value("LIMS", Code::speed_limit), block("LOCK", synchronized_action),
    cycle("LONGHOLE"), st("LOOP", Keyword::loop), no("MASLDEF", axis_coupling),
    no("MASLDEL", axis_coupling), no("MASLOF", axis_coupling), no("MASLOFS", axis_coupling),
    no("MASLON", axis_coupling), no("MATCH", machine_function), st("MCALL", Keyword::mcall), no("MEAC", measuring),
    no("MEAFRAME", measuring), no("MEAS", measuring), no("MEASA", measuring), no("MEASURE", measuring),
    no("MEAW", measuring), no("MEAWA", measuring), frame("MIRROR", FrameOp::mirror, 0), no("MMC", display_dialog),
    proc("MSG", Procedure::message), no("MU", machine_function), no("MVTOOL", tool_management),
    no("MZ", machine_function), off("NEWCONF"), run("NORM", Modal::approach_normal), block("NPROT", protection_zone),
    block("NPROTDEF", protection_zone), no("NUT", tool_orientation), no("OEMIPO1", spline_polynomial_interpolation),
    no("OEMIPO2", spline_polynomial_interpolation), named("OFFN", NamedKind::contour_allowance),
    no("ORIAXES", tool_orientation), no("ORIC", tool_orientation), no("ORICONCCW", tool_orientation),
    no("ORICONCW", tool_orientation), no("ORICONIO", tool_orientation), no("ORICONTO", tool_orientation),
    no("ORICURVE", tool_orientation), no("ORID", tool_orientation), no("ORIEULER", tool_orientation), off("ORIMKS"),
    no("ORIPATH", tool_orientation), no("ORIPATHS", tool_orientation), no("ORIPLANE", tool_orientation),
    no("ORIRESET", tool_orientation), no("ORIROTA", tool_orientation), no("ORIROTC", tool_orientation),
    no("ORIROTR", tool_orientation), no("ORIROTT", tool_orientation), no("ORIRPY", tool_orientation),
    no("ORIRPY2", tool_orientation), no("ORIS", tool_orientation), no("ORISOF", tool_orientation),
    no("ORISON", tool_orientation), no("ORIVECT", tool_orientation), no("ORIVIRT1", tool_orientation),
    no("ORIVIRT2", tool_orientation), off("ORIWKS"), no("OS", oscillation_grinding_function),
    no("OSB", oscillation_grinding_function), no("OSC", tool_orientation),
    no("OSCILL", oscillation_grinding_function), no("OSCTRL", oscillation_grinding_function),
    no("OSD", tool_orientation), no("OSE", oscillation_grinding_function), no("OSNSC", oscillation_grinding_function),
    no("OSOF", tool_orientation), no("OSP1", oscillation_grinding_function),
    no("OSP2", oscillation_grinding_function), no("OSS", tool_orientation), no("OSSE", tool_orientation),
    no("OST", tool_orientation), no("OST1", oscillation_grinding_function), no("OST2", oscillation_grinding_function),
    off("OTOL"), no("OTOLX", tool_orientation), no("OVR", feed_override_by_the_program),
    no("OVRA", positioning_indexing_axis), no("OVRRAP", feed_override_by_the_program),
    no("PAROT", tool_oriented_frame), off("PAROTOF"), st("PCALL", Keyword::pcall), off("PDELAYOF"), off("PDELAYON"),
    no("PL", spline_polynomial_interpolation), no("PO", spline_polynomial_interpolation),
    cycle("POCKET1"), cycle("POCKET2"), cycle("POCKET3"),
    cycle("POCKET4"), off("POLF"), no("POLFA", retract_stop_reaction), off("POLFMASK"), off("POLFMLIN"),
    no("POLY", spline_polynomial_interpolation), no("POLYPATH", spline_polynomial_interpolation), off("PON"),
    off("PONS"), named("POS", NamedKind::position), named("POSA", NamedKind::position_meanwhile),
    no("POSM", machine_function), no("POSP", positioning_indexing_axis), off("PREPRO"), off("PRESETOF"),
    no("PRESETON", oscillation_grinding_function), no("PRESETONS", oscillation_grinding_function),
    no("PRIO", machine_function), off("PRLOC"), st("PROC", Keyword::proc), no("PROTA", file_data_access),
    no("PROTD", file_data_access), no("PROTS", file_data_access), no("PTP", kinematic_transformation),
    no("PTPG0", kinematic_transformation), off("PTPOF"), no("PTPWOC", kinematic_transformation), off("PUNCHACC"),
    no("PUTFTOC", file_data_access), no("PUTFTOCF", file_data_access), no("PW", spline_polynomial_interpolation),
    no("RAC", diameter_programming_by_axis), no("READ", file_data_access), st("REDEF", Keyword::redef),
    no("RELEASE", axis_spindle_exchange), st("REPEAT", Keyword::repeat), st("REPEATB", Keyword::repeatb),
    no("REPOSA", machine_function), no("REPOSH", machine_function), no("REPOSHA", machine_function),
    no("REPOSL", machine_function), no("REPOSQ", machine_function), no("REPOSQA", machine_function),
    no("RESETMON", tool_management), st("RET", Keyword::ret), no("RIC", diameter_programming_by_axis),
    no("RMB", machine_function), no("RMBBL", machine_function), no("RME", machine_function),
    no("RMEBL", machine_function), no("RMI", machine_function), no("RMIBL", machine_function),
    no("RMN", machine_function), no("RMNBL", machine_function), value("RND", Code::round),
    value("RNDM", Code::round_modal), frame("ROT", FrameOp::rotate, 0), no("ROTS", tool_oriented_frame),
    no("ROTSET", machine_function), value("RP", Code::polar_radius), value("RPL", Code::plane_rotation),
    no("RTLIOF", retract_stop_reaction), off("RTLION"), off("SAVE"), off("SBLOF"), off("SBLON"),
    frame("SCALE", FrameOp::scale, 0), no("SCC", feed_override_by_the_program),
    no("SD", spline_polynomial_interpolation), proc("SETAL", Procedure::alarm), no("SETDNO", tool_management),
    block("SETINT", interrupt_routine), no("SETM", channel_coordination), proc("SETMS", Procedure::master_spindle),
    no("SETPIECE", tool_management), no("SETTA", tool_management), no("SETTCOR", tool_management),
    no("SETTIA", tool_management), named("SF", NamedKind::thread_start), cycle("SLOT1"), cycle("SLOT2"), off("SOFT"),
    off("SOFTA"), no("SON", punching_nibbling), no("SONS", punching_nibbling), off("SPATH"), off("SPCOF"),
    off("SPCON"), off("SPIF1"), off("SPIF2"), no("SPLINEPATH", spline_polynomial_interpolation),
    no("SPN", punching_nibbling), off("SPOF"), no("SPON", punching_nibbling), value("SPOS", Code::spindle_position),
    value("SPOSA", Code::spindle_position), no("SPP", punching_nibbling), no("START", channel_coordination),
    off("STARTFIFO"), no("STAT", kinematic_transformation), off("STOLF"), no("STOPA", retract_stop_reaction),
    off("STOPFIFO"), off("STOPRE"), off("STOPREOF"), run("SUPA", Modal::suppress_all), no("SVC", machine_function),
    block("SYNFCT", polynomial_function), no("TANG", axis_coupling), no("TANGDEL", axis_coupling),
    no("TANGOF", axis_coupling), no("TANGON", axis_coupling), no("TCA", tool_management),
    no("TCARR", kinematic_transformation), no("TCI", tool_management), off("TCOABS"), off("TCOFR"),
    no("TCOFRX", kinematic_transformation), no("TCOFRY", kinematic_transformation),
    no("TCOFRZ", kinematic_transformation), no("THETA", tool_orientation), no("TILT", tool_orientation),
    no("TLIFT", axis_coupling), no("TML", tool_management), no("TMOF", oscillation_grinding_function),
    no("TMON", oscillation_grinding_function), no("TOFF", tool_oriented_frame),
    no("TOFFL", tool_offset_changed_by_the_program), no("TOFFLR", tool_offset_changed_by_the_program), off("TOFFOF"),
    no("TOFFON", tool_oriented_frame), no("TOFFR", tool_offset_changed_by_the_program),
    no("TOFRAME", tool_oriented_frame), no("TOFRAMEX", tool_oriented_frame), no("TOFRAMEY", tool_oriented_frame),
    no("TOFRAMEZ", tool_oriented_frame), no("TOLX", machine_function), no("TOOLENV", tool_management),
    no("TOROT", tool_oriented_frame), off("TOROTOF"), no("TOROTX", tool_oriented_frame),
    no("TOROTY", tool_oriented_frame), no("TOROTZ", tool_oriented_frame), no("TOWBCS", tool_oriented_frame),
    no("TOWKCS", tool_oriented_frame), no("TOWMCS", tool_oriented_frame), no("TOWSTD", tool_oriented_frame),
    no("TOWTCS", tool_oriented_frame), no("TOWWCS", tool_oriented_frame), no("TRAANG", kinematic_transformation),
    no("TRACON", kinematic_transformation), no("TRACYL", kinematic_transformation), off("TRAFOOF"),
    no("TRAFOON", kinematic_transformation), no("TRAILOF", axis_coupling), no("TRAILON", axis_coupling),
    frame("TRANS", FrameOp::shift, 0), no("TRANSMIT", kinematic_transformation),
    no("TRAORI", kinematic_transformation), no("TU", kinematic_transformation), value("TURN", Code::turns),
    block("UNLOCK", synchronized_action), st("UNTIL", Keyword::until), off("UPATH"), off("VELOLIM"), off("VELOLIMA"),
    no("WAITE", channel_coordination), no("WAITENC", oscillation_grinding_function),
    no("WAITM", channel_coordination), no("WAITMC", positioning_indexing_axis), proc("WAITP", Procedure::wait_axes), off("WAITS"),
    off("WALCS0"), off("WALCS1"), off("WALCS10"), off("WALCS2"), off("WALCS3"), off("WALCS4"), off("WALCS5"),
    off("WALCS6"), off("WALCS7"), off("WALCS8"), off("WALCS9"), off("WALIMOF"), off("WALIMON"),
    block("WHEN", synchronized_action), block("WHENEVER", synchronized_action), st("WHILE", Keyword::while_),
    off("WORKPIECE"), no("WRITE", file_data_access),
};
// clang-format on
static_assert(std::is_sorted(std::begin(words), std::end(words),
                             [](const Entry& a, const Entry& b) { return a.name < b.name; }));

}  // namespace

const Entry* find_word(std::string_view upper) {
    const auto found = std::lower_bound(std::begin(words), std::end(words), upper,
                                        [](const Entry& e, std::string_view s) { return e.name < s; });
    return found != std::end(words) && found->name == upper ? &*found : nullptr;
}

}  // namespace obrys::dialect::sinumerik
