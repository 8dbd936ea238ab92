#include "parser/syntax.h"

#include "model/utf8.h"
#include "parser/actions.h"
#include "parser/builder.h"
#include "parser/grammar.h"
#include "parser/scan.h"
#include "parser/syntax_messages.h"

namespace lancer {
namespace {

using Input = tao::pegtl::memory_input<tao::pegtl::tracking_mode::lazy, tao::pegtl::eol::lf_crlf,
                                       const char*>;

/// Reports the first byte of each line that is not valid UTF-8.
void check_bytes(std::string_view text, std::uint32_t source, Report& report) {
    for (std::size_t at = 0; (at = find_invalid_utf8(text, at)) != std::string_view::npos;) {
        const SourceSpan where{source, static_cast<std::uint32_t>(at), 1};
        const auto byte = static_cast<unsigned char>(text[at]);
        if (byte == 0) {
            report.error(Message::nul_byte, where);
        } else {
            report.error(Message::invalid_utf8, where, fmt::format("{:02x}", byte));
        }
        at = scan::line_end(text, at);
    }
}

}  // namespace

ast::File read_syntax(std::uint32_t source, const SourceMap& sources, Symbols& symbols,
                      const Vocabulary& vocabulary, std::uint64_t nesting_limit, Report& report) {
    ast::File file;
    file.source = source;
    const std::string_view text = sources.text(source);
    check_bytes(text, source, report);
    grammar::Builder builder(file, text, symbols, vocabulary, nesting_limit, report);
    Input input(text.data(), text.data() + text.size(), "");
    tao::pegtl::parse<grammar::file, grammar::action, grammar::control>(input, builder);
    builder.end_file();
    return file;
}

ast::Expression read_expression(ast::File& file, const SourceMap& sources, Symbols& symbols,
                                const Vocabulary& vocabulary, std::uint64_t nesting_limit,
                                Report& report) {
    const std::string_view text = sources.text(file.source);
    check_bytes(text, file.source, report);
    grammar::Builder builder(file, text, symbols, vocabulary, nesting_limit, report);
    Input input(text.data(), text.data() + text.size(), "");
    bool complete = true;
    const grammar::Builder::Mark mark = builder.mark(text.data());
    try {
        tao::pegtl::parse<grammar::lone_expression, grammar::action, grammar::control>(input,
                                                                                       builder);
    } catch (const grammar::SyntaxError& error) {
        builder.recover(mark, error);
        complete = false;
    }
    return complete ? builder.last_value() : ast::Expression{};
}

}  // namespace lancer
