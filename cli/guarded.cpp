#include "cli/guarded.h"

#include <new>
#include <system_error>

#include "model/diagnostic.h"
#include "model/io/system_error.h"

namespace lancer::cli {
namespace {

/// An exception that nothing in the program expects.
ExitCode bug(const Session& session, const std::string& what) {
    session.terminal.error("this is a bug in lancer: " + what);
    session.terminal.line("    please report it, with the scene and the command line");
    return ExitCode::bug;
}

ExitCode caught(Session& session, const std::function<ExitCode()>& run) {
    const auto failed = [&session](ExitCode code, const std::string& message) {
        session.terminal.error(message);
        return code;
    };
    try {
        return run();
    } catch (const UsageError& error) {
        failed(ExitCode::usage, error.what());
        session.terminal.line("    hint: lancer --help, or lancer COMMAND --help");
        return ExitCode::usage;
    } catch (const SceneRejected& rejected) {
        return rejected.code;
    } catch (const SceneError& error) {
        session.terminal.show({{Severity::error, error.where, error.what(), "", {}}},
                              session.sources);
        return ExitCode::scene;
    } catch (const io::SystemError& error) {
        return failed(error.may_pass() ? ExitCode::try_again : ExitCode::files, error.what());
    } catch (const FileError& error) {
        return failed(ExitCode::files, error.what());
    } catch (const std::bad_alloc&) {
        return failed(ExitCode::files, "not enough memory");
    } catch (const std::system_error& error) {
        return failed(ExitCode::files, error.what());
    } catch (const std::exception& error) {
        return bug(session, error.what());
    } catch (...) {
        return bug(session, "something was thrown that is not an exception");
    }
}

}  // namespace

ExitCode guarded(Session& session, const std::function<ExitCode()>& run) {
    const ExitCode code = caught(session, run);
    const ExitCode end = caught(session, [&] {
        session.output.finish();
        return ExitCode::done;
    });
    return end == ExitCode::done ? code : end;
}

}  // namespace lancer::cli
