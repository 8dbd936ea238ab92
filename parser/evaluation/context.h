// The context that all parts of an evaluation share.
#pragma once

#include <string_view>

#include "model/source.h"
#include "parser/meter.h"
#include "parser/program.h"
#include "parser/report.h"

namespace lancer {

/// The script, the limits on its cost, and the report of its errors.
struct Context {
    Program& program;
    SourceMap& sources;
    Report& report;
    Meter& meter;

    std::string_view text(Symbol symbol) const { return program.symbols.text(symbol); }
    const Vocabulary& vocabulary() const { return program.vocabulary; }

    /// A call or an include begins. Until leave_call() it is among the notes of all diagnostics.
    /// Throws StopReading when calls are nested too deeply.
    void enter_call(const SourceSpan& place, std::string_view name) const {
        if (report.calls.size() >= meter.limits().calls) {
            report.error(Message::call_limit, place, meter.limits().calls);
            throw StopReading{};
        }
        report.calls.push_back({place, name});
    }
    void leave_call() const { report.calls.pop_back(); }
};

}  // namespace lancer
