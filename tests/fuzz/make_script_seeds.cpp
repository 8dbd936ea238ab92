// Makes seeds for the parser's fuzzer: the scenes of the project, cut between their statements into
// pieces of a few lines, each with the definitions of the names in it. Called with the folder of
// the scenes, the folder to fill, and the most bytes of a piece.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "parser/scan.h"

namespace {

namespace fs = std::filesystem;
using namespace lancer;
using Kind = scan::Token::Kind;

/// Cut where a line begins that stands within no brackets.
std::vector<std::string_view> statements_of(std::string_view text) {
    std::vector<std::string_view> pieces;
    std::size_t begin = 0;
    int depth = 0;
    for (auto token = scan::next_token(text, 0); token.kind != Kind::end;
         token = scan::next_token(text, token.end)) {
        const bool closes = token.kind == Kind::close || token.kind == Kind::close_brace;
        if (depth <= 0 && !closes && token.begin > begin &&
            scan::is_first_on_line(text, token.begin)) {
            pieces.push_back(text.substr(begin, token.begin - begin));
            begin = token.begin;
        }
        if (token.kind == Kind::open || token.kind == Kind::open_brace) ++depth;
        if (closes) --depth;
    }
    pieces.push_back(text.substr(begin));
    return pieces;
}

/// Without comments, and with the least of blanks.
std::string without_comments(std::string_view text) {
    std::string all;
    for (auto token = scan::next_token(text, 0); token.kind != Kind::end;
         token = scan::next_token(text, token.end)) {
        if (!all.empty()) {
            const bool blank = token.begin > 0 && scan::is_blank(text[token.begin - 1]);
            if (scan::is_first_on_line(text, token.begin))
                all += '\n';
            else if (blank)
                all += ' ';
        }
        all += text.substr(token.begin, token.end - token.begin);
    }
    return all;
}

/// The words of a statement.
std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    for (auto token = scan::next_token(text, 0); token.kind != Kind::end;
         token = scan::next_token(text, token.end))
        if (token.kind == Kind::name)
            words.push_back(text.substr(token.begin, token.end - token.begin));
    return words;
}

bool defines(std::string_view word) {
    for (const char* known : {"let", "param", "def", "func", "material", "texture"})
        if (word == known) return true;
    return false;
}

/// What stands between the outermost braces.
std::string_view inside(std::string_view text) {
    const std::size_t open = text.find('{');
    const std::size_t close = text.rfind('}');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open)
        return {};
    return text.substr(open + 1, close - open - 1);
}

class Seeds {
  public:
    Seeds(fs::path folder, std::size_t longest) : folder_(std::move(folder)), longest_(longest) {}

    /// Those of one script mean nothing in the next.
    void forget_names() { definitions_.clear(); }

    /// Each statement, what is in it where it is too long, and as many after each other as fit.
    void add_pieces(std::string_view text) {
        std::string several;
        for (const std::string_view written : statements_of(text)) {
            const std::string piece = without_comments(written) + "\n";
            if (const auto words = words_of(piece); words.size() > 1 && defines(words[0]))
                definitions_[std::string(words[1])] = piece;
            if (piece.size() > longest_) {
                if (const std::string_view rest = inside(piece); !rest.empty())
                    add_pieces(std::string(rest));
                continue;
            }
            add(piece);
            std::set<std::string> met;
            add(needed_by(piece, met) + piece);
            if (several.size() + piece.size() > longest_) {
                add(several);
                several.clear();
            }
            several += piece;
        }
        add(several);
    }

  private:
    /// The definitions of names in the piece, and of those in them.
    std::string needed_by(const std::string& piece, std::set<std::string>& met) const {
        std::string all;
        const auto words = words_of(piece);
        if (words.size() > 1 && defines(words[0])) met.insert(std::string(words[1]));
        for (const std::string_view word : words) {
            const auto known = definitions_.find(std::string(word));
            if (known != definitions_.end() && met.insert(known->first).second)
                all += needed_by(known->second, met) + known->second;
        }
        return all;
    }

    void add(std::string_view piece) {
        if (piece.size() > longest_) return;
        if (piece.empty() || !written_.emplace(piece).second) return;
        std::ofstream file(folder_ / std::to_string(written_.size()), std::ios::binary);
        file << piece;
        if (!file.flush()) std::exit(1);
    }

    fs::path folder_;
    std::size_t longest_;
    std::set<std::string, std::less<>> written_;
    std::map<std::string, std::string> definitions_;  ///< by name
};

}  // namespace

int main(int count, char** arguments) {
    if (count != 4) {
        std::fputs("make_script_seeds SCENES FOLDER LONGEST\n", stderr);
        return 2;
    }
    fs::remove_all(arguments[2]);
    fs::create_directories(arguments[2]);
    std::set<fs::path> scripts;  // in the same order everywhere
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(arguments[1]))
        if (entry.path().extension() == ".lancer" || entry.path().extension() == ".inc")
            scripts.insert(entry.path());
    Seeds seeds(arguments[2], std::strtoul(arguments[3], nullptr, 10));
    for (const fs::path& script : scripts) {
        std::ifstream file(script, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        seeds.forget_names();
        seeds.add_pieces(text);
    }
    return 0;
}
