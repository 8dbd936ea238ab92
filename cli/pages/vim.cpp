#include <fmt/format.h>

#include "cli/pages/editors.h"

namespace lancer::cli {
namespace {

/// Uses `syntax match`: as keywords, some words (`contains`, `display`, …) would be arguments of
/// Vim.
std::string word_rule(const char* group, const std::set<std::string>& words) {
    return fmt::format("syntax match {} \"\\<\\%({}\\)\\>\"\n", group, fmt::join(words, "\\|"));
}

}  // namespace

std::string vim_syntax(const LanguageWords& words) {
    std::string text =
        R"(" Vim syntax file for Lancer's scenes; made from the language's own tables.
if exists('b:current_syntax')
  finish
endif
syntax case match
)";
    text += word_rule("lancerFunction", words.functions);
    text += word_rule("lancerValue", words.values);
    text += word_rule("lancerProperty", words.properties);
    text += word_rule("lancerBlock", words.blocks);
    text += word_rule("lancerConstant", words.constants);
    text += word_rule("lancerStatement", words.statements);
    return text + R"(syntax match lancerNumber "\<\d\+\%(\.\d\+\)\?\%([eE][-+]\?\d\+\)\?\>"
syntax match lancerNumber "\%(^\|[^0-9A-Za-z_.]\)\@1<=\.\d\+\%([eE][-+]\?\d\+\)\?\>"
syntax match lancerColor "#\x\{3,8}\>"
syntax region lancerString start=+"+ skip=+\\.+ end=+"+ oneline
syntax match lancerComment "//.*$" contains=@Spell
syntax region lancerComment start="/\*" end="\*/" contains=@Spell
syntax sync ccomment lancerComment

highlight default link lancerStatement Statement
highlight default link lancerBlock Type
highlight default link lancerProperty Identifier
highlight default link lancerValue Constant
highlight default link lancerConstant Constant
highlight default link lancerFunction Function
highlight default link lancerNumber Number
highlight default link lancerColor Number
highlight default link lancerString String
highlight default link lancerComment Comment
let b:current_syntax = 'lancer'
)";
}

std::string vim_detection() {
    return "autocmd BufRead,BufNewFile *.lancer setfiletype lancer\n";
}

std::string vim_settings() {
    return R"(" Vim settings for Lancer's scenes.
if exists('b:did_ftplugin')
  finish
endif
let b:did_ftplugin = 1
setlocal commentstring=//\ %s comments=s1:/*,mb:*,ex:*/,://
setlocal makeprg=lancer\ check\ %:S
setlocal errorformat=%f:%l:%c:\ %trror:\ %m,%f:%l:%c:\ %tarning:\ %m,%-G%.%#
let b:undo_ftplugin = 'setlocal commentstring< comments< makeprg< errorformat<'
)";
}

}  // namespace lancer::cli
