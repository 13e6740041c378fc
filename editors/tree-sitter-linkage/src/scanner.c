// Block comments of the text language: they may contain each other, as in Rust.

#include "tree_sitter/parser.h"

enum Token { BLOCK_COMMENT };

void *tree_sitter_linkage_external_scanner_create(void) { return NULL; }

void tree_sitter_linkage_external_scanner_destroy(void *payload) { (void)payload; }

// A scan depends on its text alone: no state is kept between two of them.
unsigned tree_sitter_linkage_external_scanner_serialize(void *payload, char *buffer) {
    (void)payload;
    (void)buffer;
    return 0;
}

void tree_sitter_linkage_external_scanner_deserialize(void *payload, const char *buffer, unsigned length) {
    (void)payload;
    (void)buffer;
    (void)length;
}

// Reads two characters if they are these, one if the second is another.
static bool eat_pair(TSLexer *lexer, int32_t first, int32_t second) {
    if (lexer->lookahead != first) return false;
    lexer->advance(lexer, false);
    if (lexer->lookahead != second) return false;
    lexer->advance(lexer, false);
    return true;
}

// Reads to the end of the comment that has begun. Returns false if the text ends before.
static bool scan_comment(TSLexer *lexer) {
    unsigned depth = 1;
    while (depth > 0) {
        if (lexer->eof(lexer)) return false;
        switch (lexer->lookahead) {
            case '/':
                if (eat_pair(lexer, '/', '*')) depth++;
                break;
            case '*':
                if (eat_pair(lexer, '*', '/')) depth--;
                break;
            default:
                lexer->advance(lexer, false);
        }
    }
    return true;
}

bool tree_sitter_linkage_external_scanner_scan(void *payload, TSLexer *lexer, const bool *valid_symbols) {
    (void)payload;
    if (!valid_symbols[BLOCK_COMMENT]) return false;
    while (lexer->lookahead == ' ' || (lexer->lookahead >= '\t' && lexer->lookahead <= '\r')) lexer->advance(lexer, true);
    if (!eat_pair(lexer, '/', '*') || !scan_comment(lexer)) return false;
    lexer->result_symbol = BLOCK_COMMENT;
    return true;
}
