#include "parser/evaluation/block_reader.h"

#include <algorithm>
#include <cmath>

#include "parser/evaluation/expressions.h"
#include "parser/evaluation/names.h"
#include "parser/evaluation/unknown_words.h"
#include "parser/habits.h"
#include "parser/suggest.h"

namespace lancer {
namespace {

using Kind = ast::Statement::Kind;

/// Whether the property takes values beside its words: a single word would leave no choice. A name
/// of the script then hides the word.
bool takes_values(const Field& field) {
    return field.words.size() == 1;
}

/// "'base', 'top' and 'radius'".
std::string enumeration(const std::vector<std::string_view>& words) {
    std::string all;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) all += i + 1 < words.size() ? ", " : " and ";
        all.append("'").append(words[i]).append("'");
    }
    return all;
}

/// Suggests what to write instead of a value that the property does not take.
std::string hint_for_value(const Field& field, const Value& value) {
    if (value.is(Value::Kind::text) && !field.words.empty() && !takes_values(field)) {
        Suggestion suggestion(value.text());
        for (const std::string_view word : field.words) suggestion.consider(word);
        return suggestion.hint();
    }
    const bool color = field.takes.starts_with("a colour");
    if (color && value.is(Value::Kind::text)) return habits::color_called(value.text());
    if (color && value.is_number()) {
        const std::string part = to_text(std::abs(value.number()));
        return "write a grey as [" + part + ", " + part + ", " + part + "]";
    }
    if (field.name == "rotate" && value.is_vector(3)) {
        // Other programs rotate in this order.
        std::string turns;
        for (unsigned i = 0; i < 3; ++i)
            if (value.component(i) != 0)
                turns += std::string(" rotate_") + "xyz"[i] + " " + to_text(value.component(i));
        return "for angles about the axes, one after the other, write" +
               (turns.empty() ? " rotate_x 0" : turns);
    }
    if (field.name == "rotate" && value.is_number())
        return "for an angle about one axis write rotate_y " + to_text(value.number());
    return {};
}

std::string_view word_of(Kind kind) {
    switch (kind) {
        case Kind::let:
            return "let";
        case Kind::param:
            return "param";
        case Kind::def:
            return "def";
        case Kind::func:
            return "func";
        case Kind::loop:
            return "for";
        case Kind::choice:
            return "if";
        case Kind::include:
            return "include";
        case Kind::assertion:
            return "assert";
        case Kind::print:
            return "print";
        default:
            return "";
    }
}

}  // namespace

BlockReader::BlockReader(const BlockContext& context, const ast::File& file,
                         const ast::Statement& block, const BlockWord& word)
    : context_(context),
      file_(file),
      block_(block),
      word_(word),
      given_(word.properties.fields().size()) {}

std::string_view BlockReader::name() const {
    const Symbol name = file_.name_of(block_);
    return name == no_symbol ? std::string_view{} : context_.text(name);
}

const ast::Statement* BlockReader::find(std::string_view property) const {
    const auto& fields = word_.properties.fields();
    for (std::size_t i = 0; i < fields.size(); ++i)
        if (fields[i]->name == property) return given_[i].statement;
    return nullptr;
}

SourceSpan BlockReader::place(std::string_view property) const {
    const ast::Statement* statement = find(property);
    if (statement == nullptr) return place();
    return statement->kind == Kind::property ? file_.span(statement->value)
                                             : file_.span(*statement);
}

bool read_property(const BlockContext& context, const ast::File& file,
                   const ast::Statement& property, const Field& field, void* owner) {
    const ast::Expression& expression = property.value;
    const SourceSpan place = file.span(expression);
    Value value;
    const ast::Step& first = file.steps[expression.begin];
    const bool lone_name = expression.end - expression.begin == 1 && first.op == ast::Op::name;
    const auto& words = field.words;
    if (!words.empty() && lone_name) {
        const std::string_view word = context.text(first.low());
        const bool known = std::find(words.begin(), words.end(), word) != words.end();
        const bool is_value = context.names.has_value(first.low());
        if (takes_values(field) ? known && !is_value : known || !is_value)
            value = Value(std::string(word));
    }
    if (value.is_broken()) value = context.expressions.evaluate(file, expression);
    if (value.is_broken()) return false;
    std::string instead;
    if (value.is_list()) context.meter.elements(value.size(), place);
    if (field.read(value, owner, instead)) return true;
    if (instead.empty()) instead = describe(value);
    Diagnostic* error =
        context.report.error(Message::property_takes, place, field.name, field.takes, instead);
    if (error != nullptr) error->hint = hint_for_value(field, value);
    return false;
}

void BlockReader::report_unknown(const ast::Statement& statement) {
    good_ = false;
    const std::string_view meant =
        report_unknown_property(file_, statement, word_.properties, word_.info->title(), context_);
    if (!meant.empty()) misspelt_.push_back(meant);
}

void BlockReader::read_statement(const ast::Statement& statement, void* own, void* shared) {
    Report& report = context_.report;
    const bool inline_material =
        statement.kind == Kind::block && statement.word == context_.vocabulary().material;
    const bool block = statement.kind == Kind::block;
    if (statement.kind != Kind::property && !(block && word_.properties.knows(statement.word))) {
        good_ = false;
        if (block) {
            if (context_.vocabulary().is_block(statement.word)) {
                report.error(Message::block_misplaced, file_.span(statement),
                             context_.text(statement.word), with_article(word_.info->title()));
            } else {
                report_unknown_property(file_, statement, word_.properties, word_.info->title(),
                                        context_);
            }
        } else if (statement.kind == Kind::call) {
            report_unknown(statement);
        } else if (statement.kind != Kind::broken) {
            report.error(Message::statement_misplaced, file_.span(statement),
                         word_of(statement.kind), with_article(word_.info->title()));
        }
        return;
    }
    const std::uint8_t index = word_.properties.index(statement.word);
    if (index == PropertySet::unknown) {
        report_unknown(statement);
        return;
    }
    const Field& field = word_.properties.field(index);
    if (given_[index].statement != nullptr && !field.repeats) {
        good_ = false;
        Diagnostic* error = report.error(Message::given_twice, file_.span(statement), field.name);
        if (error != nullptr)
            error->notes.insert(
                error->notes.begin(),
                Report::note(Message::first_here, file_.span(*given_[index].statement)));
        return;
    }
    given_[index].statement = &statement;
    void* owner = index < word_.own_fields ? own : shared;
    if (!evaluates_ && (!block || inline_material)) return;
    if (!block) {
        if (!read_property(context_, file_, statement, field, owner)) good_ = false;
        return;
    }
    if (!inline_material) {
        good_ = false;
        report.error(Message::block_is_property, file_.span(statement), field.name);
        return;
    }
    const std::uint32_t material = make_inline_material(context_, file_, statement);
    static_cast<Attributes*>(owner)->material = material;
    if (material == none) good_ = false;
}

void BlockReader::check() {
    evaluates_ = false;
    read(nullptr, nullptr);
}

bool BlockReader::read(void* own, void* shared) {
    const ast::Range body = file_.parts_of(block_).body;
    for (std::uint32_t i = body.begin; i < body.end; ++i) {
        context_.meter.statement(file_.span(file_.statements[i]));
        read_statement(file_.statements[i], own, shared);
    }
    if (block_.damaged) good_ = false;
    const auto& fields = word_.properties.fields();
    std::vector<std::string_view> missing;
    for (std::size_t i = 0; i < fields.size() && !block_.damaged; ++i) {
        if (fields[i]->standard != required || given_[i].statement != nullptr) continue;
        if (std::find(misspelt_.begin(), misspelt_.end(), fields[i]->name) == misspelt_.end())
            missing.push_back(fields[i]->name);
    }
    if (!missing.empty()) {
        good_ = false;
        context_.report.error(Message::property_missing, place(), with_article(word_.info->title()),
                              enumeration(missing));
    }
    return good_;
}

std::uint32_t make_inline_material(const BlockContext& context, const ast::File& file,
                                   const ast::Statement& statement) {
    const Vocabulary& vocabulary = context.vocabulary();
    const BlockWord& word = *vocabulary.block(vocabulary.material, no_symbol);
    if (file.name_of(statement) != no_symbol)
        context.report.error(Message::block_takes_no_name, file.name_span(statement),
                             "a material inside a shape");
    BlockReader reader(context, file, statement, word);
    std::uint32_t result = none;
    maker_of (*word.info)(reader, result);
    return result;
}

}  // namespace lancer
