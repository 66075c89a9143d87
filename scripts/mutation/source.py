"""Tokenises C++ and GLSL, and finds the code that computes something.

It has no grammar of C++: the tree is formatted by clang-format, so binary operators have white space on both sides,
and template brackets, pointer stars and unary operators do not.
"""

import re
from dataclasses import dataclass

TOKEN = re.compile(
    r"""
    (?P<space>\s+)
  | (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<directive>\#(?:\\\n|[^\n])*)
  | (?P<raw>(?:u8|[uUL])?R"(?P<delimiter>[^()\\\s]*)\(.*?\)(?P=delimiter)")
  | (?P<string>(?:u8|[uUL])?"(?:\\.|[^"\\\n])*")
  | (?P<character>'(?:\\.|[^'\\\n])+')
  | (?P<number>\.?\d(?:[eEpP][+-]|'?[\w.])*)
  | (?P<name>[A-Za-z_]\w*)
  | (?P<operator><<=|>>=|<=>|\.\.\.|->|::|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|.)
    """,
    re.VERBOSE | re.DOTALL,
)

PAIRS = {"(": ")", "[": "]", "{": "}"}
# A bracket after these is not a call.
KEYWORDS = {"if", "for", "while", "switch", "catch", "return", "sizeof", "alignof", "decltype", "noexcept", "new",
            "delete", "throw", "constexpr", "operator", "requires", "case", "do", "else"}
# A brace after these begins a block of statements.
BEFORE_CODE = {")", "]", "else", "do", "try", "const", "noexcept", "override", "final", "mutable"}


@dataclass(frozen=True)
class Token:
    kind: str  # name, number, string, character or operator
    text: str
    start: int
    end: int
    space_before: bool
    space_after: bool

    @property
    def is_spaced(self):
        return self.space_before and self.space_after


class Source:
    """The tokens of a file, its matching brackets, and the tokens that may not be changed."""

    def __init__(self, text):
        self.text = text
        self.tokens = tokens_of(text)
        self.matching = matching_brackets(self.tokens)
        self.templates = self._template_brackets()
        self.template_ends = set(self.templates.values())
        self.code_braces = set()
        self.enclosing = self._enclosing_brackets()
        self.masked = self._masked_tokens()

    def is_text(self, index, *texts):
        return 0 <= index < len(self.tokens) and self.tokens[index].text in texts

    def is_operand_end(self, index):
        """Returns whether an operand can end here, so that a binary operator follows."""
        if not 0 <= index < len(self.tokens):
            return False
        token = self.tokens[index]
        if token.kind == "name":
            return token.text not in KEYWORDS
        return token.kind != "operator" or token.text in (")", "]", "}") or index in self.template_ends

    def is_in_code(self, index):
        """Returns whether a token is in the body of a function."""
        while (index := self.enclosing[index]) is not None:
            if index in self.code_braces:
                return True
        return False

    def end_of_primary(self, index):
        """Returns the index after an operand with its calls, subscripts and members, or None."""
        while self.is_text(index, "-", "+", "!", "~", "*", "&") and not self.tokens[index].space_after:
            index += 1
        if index >= len(self.tokens):
            return None
        token = self.tokens[index]
        if token.kind == "number":
            return index + 1
        if token.text == "(":
            index = self.matching.get(index, -1) + 1
        elif token.kind == "name" and token.text not in KEYWORDS:
            index += 1
        else:
            return None
        return self._end_of_postfixes(index) if index > 0 else None

    def _end_of_postfixes(self, index):
        while index < len(self.tokens):
            if self.is_text(index, ".", "->", "::") and self.tokens[index + 1].kind == "name":
                index += 2
            elif index in self.templates:
                index = self.templates[index] + 1
            elif self.is_text(index, "(", "[") or (self.is_text(index, "{") and not self.tokens[index].space_before):
                index = self.matching.get(index, len(self.tokens)) + 1
            else:
                break
        return index

    def end_of_term(self, index):
        """Returns the index after a product of operands, or None."""
        end = self.end_of_primary(index)
        while end is not None and self.is_text(end, "*", "/", "%") and self.tokens[end].is_spaced:
            end = self.end_of_primary(end + 1)
        return end

    def parts(self, opening):
        """Returns the ranges of tokens between the commas of a pair of brackets."""
        closing = self.matching[opening]
        found, start, index = [], opening + 1, opening + 1
        while index < closing:
            if index in self.templates:
                index = self.templates[index]
            elif index in self.matching and self.matching[index] > index:
                index = self.matching[index]
            elif self.tokens[index].text == ",":
                found.append((start, index))
                start = index + 1
            index += 1
        if start < closing:
            found.append((start, closing))
        return found

    def text_of(self, start, end):
        return self.text[self.tokens[start].start : self.tokens[end - 1].end] if end > start else ""

    def _template_brackets(self):
        """Matches the `<` and `>` of template arguments."""
        found, open_brackets = {}, []
        for index, token in enumerate(self.tokens):
            if token.text == "<" and not token.is_spaced and not self.is_text(index - 1, "operator"):
                open_brackets.append(index)
            elif token.text in (">", ">>") and not token.is_spaced and not self.is_text(index - 1, "operator"):
                for _ in token.text:
                    if open_brackets:
                        found[open_brackets.pop()] = index
            elif token.text in (";", "}"):
                open_brackets.clear()
        return found

    def _enclosing_brackets(self):
        """Returns the index of the bracket around each token, and finds the braces of blocks."""
        enclosing, stack = [], []
        for index, token in enumerate(self.tokens):
            if token.text in PAIRS.values() and stack:
                stack.pop()
            enclosing.append(stack[-1] if stack else None)
            if token.text in PAIRS:
                if token.text == "{" and self._begins_code(index, stack):
                    self.code_braces.add(index)
                stack.append(index)
        return enclosing

    def _begins_code(self, index, stack):
        head = index - 1
        while head >= 0 and not self.is_text(head, ";", "{") and not (stack and head == stack[-1]):
            if self.is_text(head, "}") and not self.is_text(head + 1, ",", "{"):
                break
            head = self.matching[head] if self.is_text(head, ")", "]", "}") and head in self.matching else head
            head -= 1
        texts = [token.text for token in self.tokens[head + 1 : index]]
        if not texts:
            return bool(stack) and stack[-1] in self.code_braces
        if {"namespace", "struct", "class", "union", "enum"} & set(texts) and "(" not in texts:
            return False
        if texts[-1] in BEFORE_CODE:
            return True
        # A return type, a list of initialisers, or the label of a case.
        return texts[-1] == ":" or (")" in texts and ("->" in texts or (":" in texts and texts[-1] == "}")))

    def _masked_tokens(self):
        masked = set()
        for opening, closing in self.templates.items():
            masked.update(range(opening, closing + 1))
        for index, token in enumerate(self.tokens):
            masked.update(range(index, self._end_of_mask(index, token)))
        return masked

    def _end_of_mask(self, index, token):
        if token.text in ("static_assert", "assert", "alignas", "decltype", "noexcept", "__attribute__"):
            return self.matching.get(index + 1, index) + 1
        if token.text == "[" and self.is_text(index + 1, "["):
            return self.matching.get(index, index) + 1
        if token.text in ("using", "typedef", "friend", "concept"):
            return self._index_of(index, ";") + 1
        if token.text == "case":
            return self._index_of(index, ":") + 1
        if token.text == "operator":
            return index + 2
        if token.text == "enum":
            brace = self._index_of(index, "{", ";")
            return self.matching.get(brace, brace) + 1
        if token.text == "=" and self.is_text(index + 1, "0", "default", "delete") and self.is_text(index + 2, ";"):
            return index + 3 if self.is_text(index - 1, ")", "const", "override", "noexcept") else index
        return index

    def _index_of(self, index, *texts):
        while index < len(self.tokens) - 1 and self.tokens[index].text not in texts:
            index += 1
        return index


def tokens_of(text):
    tokens = []
    for match in TOKEN.finditer(text):
        kind = match.lastgroup if match.lastgroup != "delimiter" else "raw"
        if kind in ("space", "comment", "directive"):
            continue
        start, end = match.span()
        tokens.append(
            Token("string" if kind == "raw" else kind, match.group(), start, end,
                  text[start - 1 : start].isspace() or start == 0, text[end : end + 1].isspace()))
    return tokens


def matching_brackets(tokens):
    """Maps each bracket to the index of its partner, both ways."""
    found, stack = {}, []
    for index, token in enumerate(tokens):
        if token.text in PAIRS:
            stack.append(index)
        elif token.text in PAIRS.values() and stack and PAIRS[tokens[stack[-1]].text] == token.text:
            opening = stack.pop()
            found[opening], found[index] = index, opening
    return found
