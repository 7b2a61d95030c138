// The article's functions for its page: one article, whose memory the page reads.
#include <emscripten.h>

#include <exception>
#include <memory>

#include "tools/article/article.h"

using oblong::Article;

namespace {

/// What the page holds on to, made by article_open(). A page has no other place for it.
struct OpenArticle {
    std::unique_ptr<Article> article;
    std::string text;  // what the last function said
};

OpenArticle& the_article() {
    static OpenArticle open;
    return open;
}

const char* said(std::string text) {
    the_article().text = std::move(text);
    return the_article().text.c_str();
}

}  // namespace

extern "C" {

/// What is wrong; empty if nothing is.
EMSCRIPTEN_KEEPALIVE const char* article_open(const std::uint8_t* level, std::size_t level_size,
                                              const std::uint8_t* palette, std::size_t palette_size) {
    try {
        the_article().article =
            std::make_unique<Article>(std::span(level, level_size), std::span(palette, palette_size));
        return said("");
    } catch (const std::exception& error) {
        return said(error.what());
    }
}
EMSCRIPTEN_KEEPALIVE const char* article_choices() {
    return said(Article::choices());
}
EMSCRIPTEN_KEEPALIVE void article_dial(std::size_t dial, std::int32_t value) {
    the_article().article->set_dial(dial, value);
}
EMSCRIPTEN_KEEPALIVE void article_aspect(bool corrects) {
    the_article().article->correct_aspect(corrects);
}
EMSCRIPTEN_KEEPALIVE bool article_look(double x, double y, double z, double yaw, double pitch, double roll,
                                       double field) {
    return the_article().article->look_from({x, y, z, yaw, pitch, roll, field});
}
EMSCRIPTEN_KEEPALIVE const std::uint32_t* article_draw() {
    return the_article().article->draw().data();
}
EMSCRIPTEN_KEEPALIVE const std::uint32_t* article_reference() {
    return the_article().article->draw_reference().data();
}
EMSCRIPTEN_KEEPALIVE const std::uint32_t* article_errors(int measure) {
    return the_article().article->draw_errors(static_cast<oblong::Measure>(measure)).data();
}
EMSCRIPTEN_KEEPALIVE const char* article_figures() {
    return said(the_article().article->figures());
}
}
