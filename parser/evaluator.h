// Runs an AST: statements on a stack of frames, expressions on stacks of runs and values, so that
// the depth of a script never becomes depth of the program's own stack.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "parser/functions.h"
#include "parser/meter.h"
#include "parser/parse.h"
#include "parser/program.h"
#include "parser/scene_builder.h"
#include "parser/scopes.h"

namespace lancer {

class BlockReader;

class Evaluator {
  public:
    Evaluator(Program& program, const Definitions& definitions, const Limits& limits,
              SourceMap& sources, Report& report, const Loader& loader);

    /// Runs the main file. Throws StopReading when a limit was passed.
    void run();
    /// After run(): finds what is wrong in code that was not executed, as far as it shows without.
    void check_unreached();

    Scene take_scene() { return std::move(builder_.scene); }
    std::vector<std::string> take_printed() { return std::move(printed_); }
    /// Reports what -D said wrong: names that no param has. After run().
    void check_definitions(Report& usage);
    /// Values of what -D says; for an evaluator of its own, whose report is about the command line.
    std::vector<std::pair<Symbol, Value>> evaluate_definitions();
    /// Gives params these values, before run().
    void define(const std::vector<std::pair<Symbol, Value>>& values);

    // --- For BlockReader

    Value evaluate(const ast::File& file, const ast::Expression& expression);
    Report& report() { return report_; }
    Meter& meter() { return meter_; }
    SceneBuilder& builder() { return builder_; }
    Program& program() { return program_; }
    const Loader& loader() { return loader_; }
    std::string_view text(Symbol symbol) const { return program_.symbols.text(symbol); }
    /// A path as the script in `file` means it.
    std::string resolve_path(const ast::File& file, std::string_view path) const;
    /// Whether a lone name has a value here.
    bool has_value(Symbol name) const;
    /// The mesh, image of a path, loaded once; nullptr after an error at `place`.
    std::shared_ptr<const io::LoadedMesh> load_mesh(const std::string& path,
                                                    const SourceSpan& place);
    std::shared_ptr<const Image> load_image(const std::string& path, io::ColorSpace space,
                                            const SourceSpan& place);
    /// The same for an image that a mesh file names: a warning instead of an error.
    std::shared_ptr<const Image> find_image(const std::string& path, io::ColorSpace space,
                                            const SourceSpan& place);
    /// Reports a file that could not be read.
    void report_unreadable(const std::string& path, const SourceSpan& place,
                           const std::string& problem);
    /// The material of a shape or group that holds it itself; `none` after an error.
    std::uint32_t make_inline_material(const ast::File& file, const ast::Statement& statement);
    /// A material or texture that stands where a value does.
    Value block_in_place(const ast::File& file, std::uint32_t statement);
    /// Reports a second camera of a name.
    bool is_new_camera(const std::string& name, const SourceSpan& place);
    /// Reports a second statement of a kind that may stand once; `first` remembers the first.
    bool is_repeated(std::string_view word, SourceSpan& first, const SourceSpan& place);
    /// Reports a background beside a sky, which takes its place.
    void check_one_background(const SourceSpan& place);
    SourceSpan image_place, render_place, background_place, ambient_place, sky_place;

  private:
    /// An argument of a call, by its parameter.
    struct Given {
        Value value;
        bool is_given = false;
    };

    struct Group {
        Symbol keyword = no_symbol;  ///< group, union, intersection, difference
        Attributes attributes;
        std::vector<SourceSpan> given;  ///< by index of the property
        bool damaged = false;
    };

    /// A run of statements that is being executed, and what to do at its end.
    struct Frame {
        enum class Kind : std::uint8_t { body, loop, call, group, include };
        Kind kind = Kind::body;
        bool file_level = false;  ///< params may stand here
        const ast::File* file = nullptr;
        std::uint32_t first = 0, next = 0, end = 0;
        const ast::Statement* statement = nullptr;
        Value list;                  ///< of a loop
        std::uint64_t position = 0;  ///< in the list, or above the start of the range
        std::uint64_t count = 0;
        double start = 0;
        bool is_range = false;
        Scopes::Caller caller;             ///< of a call
        std::uint32_t outer_group = none;  ///< of a call
    };

    /// An expression that is being evaluated. One of a function of the script is a default of it or
    /// what it stands for; what called it waits in `runs_`.
    struct Run {
        const ast::File* file = nullptr;
        std::uint32_t at = 0, end = 0;             ///< the steps that are left
        std::size_t bottom = 0;                    ///< of its values on the stack
        const ast::Statement* function = nullptr;  ///< its parameters' places are below `bottom`
        std::uint32_t parameter = 0;               ///< the next to be bound
        Scopes::Caller caller;
        std::size_t iterations = 0, gathers = 0;  ///< below those that it opened
    };

    /// A `for` of a list that is computed. Its variable is in a scope of its own.
    struct Iteration {
        Value list;
        double start = 0;  ///< of a range
        std::uint64_t position = 0, count = 0;
        bool is_range = false;
    };

    /// The name of an argument on the stack.
    struct Label {
        std::size_t argument = 0;
        const ast::Step* step = nullptr;
    };

    const Loaded<Image>& image_at(const std::string& path, io::ColorSpace space);

    // unreached.cpp
    void mark_executed(const ast::File& file, std::uint32_t statement);
    void check_unreached(const ast::File& file);
    void check_names(const ast::File& file, const ast::Expression& expression, bool lone_word);
    void collect_names(const ast::File& file);

    // statements.cpp
    void step();
    void execute(const ast::File& file, const ast::Statement& statement);
    void end_frame();
    Frame& push(Frame::Kind kind, const ast::File& file, const ast::Range& body);
    void execute_let(const ast::File& file, const ast::Statement& statement);
    void execute_param(const ast::File& file, const ast::Statement& statement);
    void execute_loop(const ast::File& file, const ast::Statement& statement);
    bool is_bound(const Value& value, const SourceSpan& place);
    bool next_iteration(Frame& frame);
    void execute_choice(const ast::File& file, const ast::Statement& statement);
    void execute_assertion(const ast::File& file, const ast::Statement& statement);
    void execute_print(const ast::File& file, const ast::Statement& statement);
    void execute_property(const ast::File& file, const ast::Statement& statement);
    void report_unknown_block(const ast::File& file, const ast::Statement& statement);
    void execute_block(const ast::File& file, const ast::Statement& statement);
    bool declare(Binding binding);
    bool condition(const ast::File& file, const ast::Expression& expression, std::string_view what,
                   bool& result);

    // calls.cpp
    void define_callable(const ast::File& file, const ast::Statement& statement);
    void execute_call(const ast::File& file, const ast::Statement& statement);
    bool match_arguments(const ast::File& file, const ast::Statement& call, const ast::File& home,
                         const ast::Statement& definition, std::vector<Given>& given);
    bool are_complete(const ast::File& home, const ast::Statement& definition,
                      const SourceSpan& call, const std::vector<Given>& given);
    void bind_given(const ast::File& home, const ast::Statement& definition,
                    std::vector<Given>& given);
    void execute_include(const ast::File& file, const ast::Statement& statement);
    ast::File* load_script(const std::string& path, const SourceSpan& place,
                           const SourceSpan& statement);
    void enter_call(const SourceSpan& place, std::string_view name);
    /// What tells whether two paths name the same file: absolute, with links followed.
    static std::string identity(const std::string& path);

    // names.cpp
    void push_name(const ast::File& file, const ast::Step& step);
    SourceSpan place_of_definition(const SourceSpan& use, Symbol name) const;
    void report_undefined(Message message, const SourceSpan& place, Symbol name, bool functions);

    // computed_lists.cpp
    void take_list_step(Run& run, const ast::Step& step);
    void begin_iteration(Run& run, const ast::Step& step, Iteration iteration);
    void go_on(Run& run, const ast::Step& step);
    void only_if(Run& run, const ast::Step& step);
    void end_iterations(std::size_t most);
    void push_list(std::size_t first, const SourceSpan& place);
    void check_held(const SourceSpan& place);

    // expressions.cpp
    Run begin_run(const ast::File& file, const ast::Expression& expression) const;
    const Value& literal(Symbol symbol);
    void take(Run& run, const ast::Step& step);
    void give_up(Run& run);
    Value pop();

    // function_calls.cpp
    void call(Run& run, const ast::Step& step);
    Value apply_function(const Function& function, const ast::File& file, const ast::Step& step);
    void warn_of_degrees(const ast::File& file, const ast::Step& call, std::string_view function);
    void begin_call(Run& run, const ast::Step& call, const Binding& callee);
    std::span<const Label> labels_of_call(std::size_t count) const;
    void drop_labels(std::size_t first);
    bool arrange_arguments(const Run& run, const ast::Step& call, const Binding& callee);
    bool arrange_named(const Run& run, const Binding& callee, std::span<const Label> labels,
                       std::size_t unnamed);
    void report_unknown_argument(const SourceSpan& place, const ast::File& home,
                                 const ast::Statement& definition, Symbol name);
    void bind_parameters(Run& run);
    void bind_parameter(const ast::File& home, const ast::Argument& parameter, Value value);
    void end_run(Run& run, Value result);

    Program& program_;
    const Definitions& definitions_;
    SourceMap& sources_;
    Report& report_;
    const Loader& loader_;
    Meter meter_;
    SceneBuilder builder_;
    Scopes scopes_;
    std::vector<Value> stack_;
    std::vector<Run> runs_;      ///< that wait for a function they called
    std::vector<Label> labels_;  ///< of arguments on the stack
    std::vector<Iteration> iterations_;
    std::vector<std::size_t> gathers_;  ///< where on the stack the elements of each list begin
    std::uint64_t in_place_ = 0;        ///< blocks in place that are being read, within each other
    std::vector<Value> literals_;       ///< strings by symbol, so that each is made once
    std::vector<Frame> frames_;
    std::vector<Group> groups_;
    std::uint32_t group_ = none;  ///< the one whose properties may stand here
    std::vector<std::string> printed_;

    std::vector<const Function*> functions_;  ///< by symbol
    std::unordered_map<Symbol, double> constants_;
    std::unordered_map<Symbol, std::pair<Value, bool>>
        defined_;  ///< by -D; whether a param took it
    std::vector<Symbol> params_;
    std::unordered_set<std::string> included_;
    std::vector<std::string> including_;  ///< chain of paths, the main script first
    std::unordered_map<std::string, SourceSpan> camera_places_;
    std::unordered_map<const ast::File*, std::vector<bool>> executed_;  ///< by statement
    const ast::File* marked_file_ = nullptr;
    std::vector<bool>* marks_ = nullptr;   ///< of marked_file_
    std::unordered_set<Symbol> declared_;  ///< names that stand anywhere, for check_unreached()
    bool incomplete_ = false;              ///< an include could not be read

    friend class BlockReader;
};

}  // namespace lancer
