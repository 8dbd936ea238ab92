#include "accuracy/error_sums.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace lancer::accuracy {
namespace {

constexpr std::size_t most_pixels = 3;           // listed pixels
constexpr std::uint64_t most_draws = 1'000'000;  // of a part's audit; far more than any has
constexpr std::uint64_t most_pixels_of_kind = std::uint64_t(1) << 40;

/// Writer and Reader visit all numbers of the sums in the same order.
class Writer {
  public:
    template <class Number>
    void operator()(const Number& number) {
        text += fmt::format("{}{}", text.empty() ? "" : " ", number);
    }
    void operator()(bool flag) { (*this)(int{flag}); }
    std::size_t listed(const std::vector<PixelShare>& list) {
        (*this)(list.size());
        return list.size();
    }
    bool held(const std::optional<OffSums>& off) {
        (*this)(off.has_value());
        return off.has_value();
    }
    std::string text;
};

class Reader {
  public:
    explicit Reader(std::string_view text) : rest_(text) {}

    template <class Number>
    void operator()(Number& number) {
        const auto [end, error] =
            std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
        is_sound = is_sound && error == std::errc();
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        if (rest_.starts_with(' ')) rest_.remove_prefix(1);
    }
    void operator()(bool& flag) {
        int number = 0;
        (*this)(number);
        flag = number != 0;
    }
    std::size_t listed(std::vector<PixelShare>& list) {
        std::size_t size = 0;
        (*this)(size);
        is_sound = is_sound && size <= most_pixels;
        list.resize(is_sound ? size : 0);
        return list.size();
    }
    bool held(std::optional<OffSums>& off) {
        bool is_there = false;
        (*this)(is_there);
        if (is_there) off.emplace();
        return is_there;
    }
    bool is_at_end() const { return rest_.empty(); }
    bool is_sound = true;

  private:
    std::string_view rest_;
};

template <class Visit, class Sums>
void each_sum(Visit& visit, Sums& sums) {
    visit(sums.count);
    visit(sums.sum);
    visit(sums.squares);
}

template <class Visit, class List>
void each_pixel(Visit& visit, List& list) {
    const std::size_t size = visit.listed(list);
    for (std::size_t i = 0; i < size; ++i) {
        visit(list[i].x);
        visit(list[i].y);
        visit(list[i].share);
    }
}

template <class Visit, class Rays>
void each_kind(Visit& visit, Rays& rays) {
    visit(rays.primary);
    visit(rays.shadow);
    visit(rays.reflected);
    visit(rays.transmitted);
}

template <class Visit, class Sums>
void each_number(Visit& visit, Sums& s) {
    visit(s.pixels);
    visit(s.asked);
    visit(s.audited);
    visit(s.rare_light);
    each_sum(visit, s.deciding);
    each_sum(visit, s.printed);
    visit(s.predicted);
    visit(s.scores);
    visit(s.specks.error);
    visit(s.specks.squares);
    each_pixel(visit, s.specks.pixels);
    each_pixel(visit, s.dominant);
    each_kind(visit, s.picture);
    each_kind(visit, s.deciding_rays);
    each_kind(visit, s.printed_rays);
    if (!visit.held(s.off)) return;
    visit(s.off->asked);
    visit(s.off->steps);
    visit(s.off->predicted);
    for (auto* kind : {&s.off->printed.calm, &s.off->printed.risky}) {
        visit(kind->pixels);
        visit(kind->draws);
        visit(kind->off);
        visit(kind->undecided);
    }
    visit(s.off->printed.step);
}

bool is_sound(const KindCount& count) {
    return count.pixels <= most_pixels_of_kind && (count.draws > 0) == (count.pixels > 0) &&
           count.draws <= most_draws && count.off <= count.draws &&
           count.undecided <= count.draws - count.off;
}

/// Whether a report can be made of them.
bool is_sound(const ErrorSums& s) {
    for (const double number :
         {s.pixels, s.asked, s.deciding.count, s.deciding.sum, s.deciding.squares, s.printed.count,
          s.printed.sum, s.printed.squares, s.predicted, s.scores, s.specks.error,
          s.specks.squares})
        if (!std::isfinite(number)) return false;
    for (const std::vector<PixelShare>* list : {&s.specks.pixels, &s.dominant})
        for (const PixelShare& p : *list)
            if (!std::isfinite(p.share)) return false;
    if (s.pixels < 1) return false;
    if (s.off) {
        const OffCount& count = s.off->printed;
        return !s.audited || (is_sound(count.calm) && is_sound(count.risky) && count.step > 0 &&
                              count.step <= most_draws && count.pixels() == s.pixels);
    }
    return !s.audited || s.rare_light || (s.deciding.count >= 2 && s.printed.count >= 2);
}

}  // namespace

std::string to_text(const ErrorSums& sums) {
    Writer writer;
    each_number(writer, sums);
    return writer.text;
}

std::optional<ErrorSums> error_sums_of(std::string_view text) {
    Reader reader(text);
    ErrorSums sums;
    each_number(reader, sums);
    if (!reader.is_sound || !reader.is_at_end() || !is_sound(sums)) return std::nullopt;
    return sums;
}

}  // namespace lancer::accuracy
