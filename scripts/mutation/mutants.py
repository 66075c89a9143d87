"""Lists the mutants of a source file: each has a position, a kind and a replacement text."""

import difflib
from dataclasses import dataclass

from mutation.source import KEYWORDS, Source

OPPOSITE = {"+": "-", "-": "+", "*": "/", "/": "*", "%": "/"}
OPPOSITE_ASSIGNMENT = {"+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="}
NEGATED = {"<": ">=", ">": "<=", "<=": ">", ">=": "<", "==": "!=", "!=": "=="}
OTHER_BOUND = {"<": "<=", ">": ">=", "<=": "<", ">=": ">"}
ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "%=", "|=", "&=", "^=", "<<=", ">>="}

# These functions are symmetric in their arguments.
SYMMETRIC = {"min", "max", "fmin", "fmax", "hypot", "dot", "swap", "midpoint", "iter_swap", "EqualComponents", "equal"}
# Without these the result is the same, only slower or with more memory.
WITHOUT_EFFECT = {"reserve", "shrink_to_fit", "free_spare_memory", "static_assert", "assert"}


@dataclass(frozen=True)
class Mutant:
    path: str
    kind: str
    line: int
    column: int
    start: int
    end: int
    replacement: str

    @property
    def id(self):
        return f"{self.path}:{self.line}:{self.column}:{self.kind}"

    def applied(self, text):
        return text[: self.start] + self.replacement + text[self.end :]

    def diff(self, text):
        lines = difflib.unified_diff(
            text.splitlines(), self.applied(text).splitlines(), "a/" + self.path, "b/" + self.path, n=1, lineterm="")
        return "\n".join(lines)


def mutants_of(path, text):
    """Lists all mutants of a file, in the order of their positions."""
    source = Source(text)
    found = {}
    for index in range(len(source.tokens)):
        if index in source.masked:
            continue
        for kind, start, end, replacement in mutations_at(source, index):
            line = text.count("\n", 0, start) + 1
            column = start - text.rfind("\n", 0, start)
            mutant = Mutant(path, kind, line, column, start, end, replacement)
            found.setdefault(mutant.id, mutant)
    return list(found.values())


def mutations_at(source, index):
    token = source.tokens[index]
    if token.kind == "number":
        yield from changed_numbers(source, index)
    elif token.kind == "name":
        yield from changed_conditions(source, index)
        yield from changed_returns(source, index)
    elif token.kind == "operator":
        yield from changed_operators(source, index)
        yield from left_out_operands(source, index)
        yield from swapped_arguments(source, index)
    if begins_statement(source, index):
        yield from left_out_statements(source, index)


def changed_numbers(source, index):
    token = source.tokens[index]
    number = token.text.replace("'", "")
    if number[:2].lower() in ("0x", "0b"):
        return  # masks, and the limits of floats
    digits = number.rstrip("uUlLfFzZ")
    suffix = number[len(digits) :]
    if digits.isdigit():
        yield "number", token.start, token.end, str(int(digits) + 1) + suffix
        return
    try:
        value = float(digits)
    except ValueError:
        return
    # Very small and large numbers are tolerances and bounds.
    if value == 0 or 1e-3 <= value <= 1e6:
        yield "number", token.start, token.end, repr(value * 1.25 if value else 1.0) + suffix


def changed_operators(source, index):
    token = source.tokens[index]
    if token.text in ("-", "!") and not token.space_after and not source.is_operand_end(index - 1):
        yield ("sign" if token.text == "-" else "negation"), token.start, token.end, ""
    if token.text in OPPOSITE_ASSIGNMENT:
        yield "operator", token.start, token.end, OPPOSITE_ASSIGNMENT[token.text]
    if not token.is_spaced or not source.is_operand_end(index - 1) or is_of_text(source, index):
        return
    if token.text in OPPOSITE:
        yield "operator", token.start, token.end, OPPOSITE[token.text]
    elif token.text in ("&&", "||"):
        yield "logic", token.start, token.end, "||" if token.text == "&&" else "&&"
    elif token.text in NEGATED:
        yield "comparison", token.start, token.end, NEGATED[token.text]
        if token.text in OTHER_BOUND:
            yield "bound", token.start, token.end, OTHER_BOUND[token.text]


def is_of_text(source, index):
    return any(source.tokens[i].kind == "string" for i in (index - 1, index + 1) if 0 <= i < len(source.tokens))


def left_out_operands(source, index):
    token = source.tokens[index]
    if not token.is_spaced or not source.is_operand_end(index - 1) or is_of_text(source, index):
        return
    if token.text in ("*", "/"):
        end, kind = source.end_of_primary(index + 1), "factor"
    elif token.text in ("+", "-"):
        end, kind = source.end_of_term(index + 1), "term"
    else:
        return
    if end is not None:
        start, stop = source.tokens[index - 1].end, source.tokens[end - 1].end
        yield kind, start, stop, newlines(source.text[start:stop])


def newlines(text):
    """Returns line breaks that keep the numbers of the lines below."""
    return "\n" * text.count("\n")


def swapped_arguments(source, index):
    if not source.is_text(index, "(", "{") or index not in source.matching or not source.is_in_code(index):
        return
    if index in source.code_braces or not is_called(source, index):
        return
    parts = source.parts(index)
    for (first, middle), (second, last) in zip(parts, parts[1:]):
        texts = source.text_of(first, middle), source.text_of(second, last)
        if texts[0] == texts[1] or not texts[0] or "{" in texts[0] or texts[0].startswith("."):
            continue
        # Arguments that look alike often have the same type, others seldom.
        if shape(source, first, middle) != shape(source, second, last):
            continue
        start, end = source.tokens[first].start, source.tokens[last - 1].end
        between = source.text[source.tokens[middle - 1].end : source.tokens[second].start]
        yield "swap", start, end, texts[1] + between + texts[0]


def shape(source, start, end):
    return [token.text if token.kind == "operator" else token.kind for token in source.tokens[start:end]]


def is_called(source, index):
    before = source.tokens[index - 1] if index > 0 else None
    if before is None:
        return False
    if source.is_text(index, "{"):
        return before.kind == "name" or before.text in ("=", "(", ",", "{") or index - 1 in source.template_ends
    if index - 1 in source.template_ends:
        return True
    return before.kind == "name" and before.text not in KEYWORDS and before.text not in SYMMETRIC


def changed_conditions(source, index):
    if not source.is_text(index, "if") or not source.is_text(index + 1, "(") or index + 1 not in source.matching:
        return
    opening, closing = index + 1, source.matching[index + 1]
    inside = source.tokens[opening + 1 : closing]
    texts = [token.text for token in inside]
    if ";" in texts or "=" in texts or not texts:
        return
    start, end = source.tokens[opening].end, source.tokens[closing].start
    condition = source.text[start:end]
    # A single comparison is negated by its operator.
    if not any(token.text in NEGATED and token.is_spaced for token in inside) and texts[0] != "!":
        yield "condition", start, end, f"!({condition})"
    if source.is_text(closing + 1, "return", "continue", "break", "throw"):
        yield "guard", start, end, f"false && ({condition})"


def changed_returns(source, index):
    if not source.is_text(index, "return") or not source.is_in_code(index):
        return
    end = end_of_statement(source, index)
    inside = source.tokens[index + 1 : end]
    texts = {token.text for token in inside}
    if not inside or inside[0].text in ("{", "[", "-") or any(token.kind == "string" for token in inside):
        return
    if texts & {"&&", "||", "!", "==", "!=", "?", "="} or any(t.text in "<>" and t.is_spaced for t in inside):
        return
    if any(token.text in OPPOSITE and token.is_spaced for token in inside):
        start, stop = source.tokens[index + 1].start, source.tokens[end].start
        yield "sign", start, stop, f"-({source.text[start:stop]})"


def begins_statement(source, index):
    if index == 0 or not source.is_in_code(index):
        return False
    if source.enclosing[index] not in source.code_braces:
        return False
    before = source.tokens[index - 1].text
    if before in (";", "{", "else"):
        return True
    if before == ":":
        return index - 1 in source.masked or source.is_text(index - 2, "default")
    if before == "}":
        opening = source.matching.get(index - 1)
        return opening in source.code_braces
    if before == ")" and (opening := source.matching.get(index - 1)):
        return source.is_text(opening - 1, "if", "for", "while", "constexpr")
    return False


def end_of_statement(source, index):
    while index < len(source.tokens) - 1 and not source.is_text(index, ";"):
        index = source.matching[index] if source.matching.get(index, 0) > index else index
        index += 1
    return index


def left_out_statements(source, index):
    """Removes assignments, calls and jumps; without a declaration or a return the code would not compile."""
    end = end_of_statement(source, index)
    if not is_expression(source, index, end) and not (
        source.is_text(index, "continue", "break") and end == index + 1
    ):
        return
    start, stop = source.tokens[index].start, source.tokens[end].end
    yield "statement", start, stop, "{}" + newlines(source.text[start:stop])


def is_expression(source, index, end):
    last = source.end_of_primary(index)
    if last is None or last > end or end - index < 2:
        return False
    if any(token.text in WITHOUT_EFFECT for token in source.tokens[index:last]):
        return False
    if last == end:
        return source.is_text(end - 1, ")")
    return source.tokens[last].text in ASSIGNMENTS
