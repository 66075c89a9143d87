"""Formulas of the models, plain text such as `f = kd/pi (cu cv)^(k-1)`, are set in mathematics, as TeX.

A line has pieces, separated by `;` or several spaces. A piece is an equation, words, or an equation and words. A space
or nothing between factors multiplies them; `name(` without a space is a function's value.
"""

import re

GREEK = {"alpha", "beta", "delta", "lambda", "omega", "phi", "pi", "sigma", "tau", "theta"}
FUNCTIONS = {"sin", "cos", "tan", "cot", "exp", "ln", "max", "min"}
RELATIONS = {"=": "=", "<=": r"\le", ">=": r"\ge", "<": "<", ">": ">"}
ANGLES = {"cu": r"\theta_u", "cv": r"\theta_v"}  # their cosines
SHORT_WORDS = {"As", "is", "of", "at", "as", "in", "it", "or", "by", "to", "an", "be", "if", "no", "on", "so", "nm"}
NAMES = GREEK | FUNCTIONS | {"sqrt", "erfc", "sum", "base", "top", "eon", "ggx", "inside", "Fresnel", "dip"}
NUMBER = r"\d+(?:\.\d+)?(?:e-?\d+)?"
NAME = r"[A-Za-z][A-Za-z0-9]*(?:_[a-z]+)?(?:'[xyz]?(?![A-Za-z]))?"
TOKEN = re.compile(rf"\s*(?:({NUMBER})|({NAME})|(<=|>=|.))")

INTEGRAL = re.compile(r"\s*the integral over the (\w+) of ")


class NoMathematics(Exception):
    """The text is no expression."""


def symbol(name):
    """Returns a name in TeX: the letters after the first are an index if they look like one."""
    if name in ANGLES:
        return rf"\cos {ANGLES[name]}"
    base, prime, component = re.fullmatch(r"([A-Za-z0-9_]+)('?)([xyz]?)", name).groups()
    if component and not prime:
        base, component = base + component, ""
    if len(base) > 3 and "_" in base and base.split("_")[0] not in GREEK:
        return rf"\operatorname{{{base.replace('_', ' ')}}}"
    greek = re.fullmatch(rf"({'|'.join(sorted(GREEK))})(?:_?([a-z]))?", base)
    if greek:
        tex, index = "\\" + greek[1], greek[2] or ""
    else:
        short = re.fullmatch(r"([A-Za-z])_?([a-z]|\d{1,2})?", base)
        tex, index = (short[1], short[2] or "") if short else (rf"\mathrm{{{base}}}", "")
    index += component
    return tex + prime + (f"_{{{index}}}" if index else "")


def product(factors):
    """Names of several letters keep a distance from each other."""
    parts = [tex for tex, _ in factors]
    return (r" \, " if any(tex.startswith(r"\mathrm") for tex in parts) else " ").join(parts)


class Reader:
    """Reads an expression as far as it goes."""

    def __init__(self, text, names):
        self.text = text
        self.names = names
        self.place = 0
        self.bars = 0

    def peek(self):
        match = TOKEN.match(self.text, self.place)
        return match if match and match.group(0).strip() else None

    def next_is(self, *signs):
        match = self.peek()
        return match is not None and match.group(3) in signs

    def take(self, sign=None):
        match = self.peek()
        if match is None or (sign is not None and match.group(3) != sign):
            raise NoMathematics
        self.place = match.end()
        return match

    def equation(self):
        tex = self.sum()
        while self.next_is(*RELATIONS):
            start = self.place
            sign = RELATIONS[self.take().group(3)]
            try:
                # Alignment is about the first sign.
                tex += f" {'' if '&' in tex or self.bars else '&'}{sign} " + self.sum()
            except NoMathematics:
                self.place = start
                break
        return tex

    def sum(self):
        tex = "-" + self._sign_and_term() if self.next_is("-") else self.term()
        while self.next_is("+", "-"):
            start = self.place
            sign = self.take().group(3)
            try:
                tex += f" {sign} {self.term()}"
            except NoMathematics:
                self.place = start
                break
        return tex

    def _sign_and_term(self):
        self.take("-")
        return self.term()

    def term(self):
        done, factors = "", [self.factor()]
        while True:
            if self.next_is("/"):
                self.take()
                top = factors[0][1] if len(factors) == 1 else product(factors)
                done += rf" \frac{{{top}}}{{{self.factor()[1]}}}"
                factors = []
            elif self.starts_factor():
                factors.append(self.factor())
            else:
                return (done + " " + product(factors)).strip()

    def starts_factor(self):
        match = self.peek()
        if INTEGRAL.match(self.text, self.place):
            return True
        if match is None:
            return False
        if match.group(2):
            return self.is_name(match.group(2))
        return bool(match.group(1)) or match.group(3) in ("(", "[") or (match.group(3) == "|" and not self.bars)

    def is_name(self, word):
        if word in self.names or word in NAMES or not word.isalpha():
            return True
        return word not in SHORT_WORDS if len(word) < 3 else not re.fullmatch("[A-Za-z][a-z]+", word)

    def factor(self):
        """Returns a factor twice: as it stands, and without the parentheses around it, for fractions and roots."""
        tex, bare, power = self.atom()
        if self.next_is("!"):
            self.take()
            tex, bare = tex + "!", bare + "!"
        if self.next_is("^"):
            self.take()
            sign = "-" if self.next_is("-") and self.take() else ""
            exponent = self.atom()[1]
            tex = bare = power(sign + exponent)
        return tex, bare

    def atom(self):
        integral = INTEGRAL.match(self.text, self.place)
        if integral:
            self.place = integral.end()
            tex = rf"\int_{{\text{{{integral[1]}}}}} {self.term()}"
            return tex, tex, None
        match = self.take()
        number, name, sign = match.groups()
        if number:
            tex = re.sub(r"(?:1)?e(-?)0*(\d+)", r"10^{\1\2}", number)
            return tex, tex, lambda e: f"{tex}^{{{e}}}"
        if name:
            return self._named(name)
        if sign == "(":
            return self._parentheses()
        if sign == "[":
            inner = self.sum()
            self.take("]")
            self.take("+")
            tex = rf"\left[{inner}\right]_+"
            return tex, tex, lambda e: f"{tex}^{{{e}}}"
        if sign == "|":
            self.bars += 1
            inner = self.sum()
            self.take("|")
            self.bars -= 1
            tex = rf"\left|{inner}\right|"
            return tex, tex, lambda e: f"{tex}^{{{e}}}"
        raise NoMathematics

    def _parentheses(self):
        self.bars += 1
        inner = self.equation()
        if self.next_is("?"):
            self.take()
            yes = self.sum()
            self.take(":")
            no = self.sum()
            self.take(")")
            self.bars -= 1
            tex = rf"\begin{{cases}} {yes} & {inner} \\ {no} & \text{{otherwise}} \end{{cases}}"
            return tex, tex, None
        self.take(")")
        self.bars -= 1
        return rf"\left({inner}\right)", inner, lambda e: rf"\left({inner}\right)^{{{e}}}"

    def arguments(self):
        self.take("(")
        self.bars += 1
        inner = [self.sum()]
        while self.next_is(","):
            self.take()
            inner.append(self.sum())
        self.take(")")
        self.bars -= 1
        return ", ".join(inner)

    def _named(self, name):
        if not self.is_name(name):
            raise NoMathematics
        if name == "sum":
            over = re.compile(r"\s*over (.*?) of ").match(self.text, self.place)
            if not over:
                raise NoMathematics
            self.place = over.end()
            domain = over[1].replace(" and ", ",")
            is_formula = re.fullmatch(r"\w(,\w)*|\w >= \d", domain)
            domain = domain.replace(">=", r"\ge") if is_formula else rf"\text{{{domain}}}"
            tex = rf"\sum_{{{domain}}} " + self.term()
            return tex, tex, None
        is_call = self.text[self.place:self.place + 1] == "("
        if name in FUNCTIONS or name in ANGLES:
            head = "\\" + (name if name in FUNCTIONS else "cos")
            inner = self.arguments() if is_call and name in FUNCTIONS else ANGLES.get(name, "")
            is_long = not re.fullmatch(r"\\?[A-Za-z]*(_\w)?(_\{\w\})?", inner)
            body = rf"\!\left({inner}\right)" if is_long else f" {inner}" if inner else ""
            is_angle = name in ANGLES or name in ("sin", "cos", "tan", "cot")
            return head + body, head + body, lambda e: f"{head}^{{{e}}}{body}" if is_angle else f"{head}{body}^{{{e}}}"
        if name == "sqrt":
            tex = rf"\sqrt{{{self.arguments()}}}"
            return tex, tex, lambda e: f"{tex}^{{{e}}}"
        if is_call:
            head = r"\operatorname{erfc}" if name == "erfc" else symbol(name)
            body = rf"\!\left({self.arguments()}\right)"
            return head + body, head + body, lambda e: f"{head}{body}^{{{e}}}"
        tex = symbol(name)
        dot = re.compile(r"\.([a-z]'?)(?!\w)").match(self.text, self.place)
        if dot:
            self.place = dot.end()
            tex = rf"\mathbf{{{name}}} \cdot \mathbf{{{dot[1]}}}"
            return tex, tex, lambda e: rf"\left({tex}\right)^{{{e}}}"
        raised = (lambda e: f"{{{tex}}}^{{{e}}}") if "'" in tex else (lambda e: f"{tex}^{{{e}}}")
        return tex, tex, raised


def words_with_mathematics(text, names):
    """Sets what is no word in mathematics, in words."""
    out, place = "", 0
    while place < len(text):
        code = re.compile(r"`[^`]*`").match(text, place)
        tex, end = (None, code.end()) if code else longest_expression(text, place, names)
        if tex is None and not code:
            end = re.compile(r"[A-Za-z0-9_']+|.").match(text, place).end()
        out += text[place:end] if tex is None else f"${tex}$"
        place = end
    return out


def longest_expression(text, place, names):
    """Returns the expression that begins at a place, and its end; no expression if a word does."""
    if not re.compile(r"[\w([|]").match(text, place):
        return None, place
    reader = Reader(text, names)
    reader.place = place
    try:
        tex = reader.equation().replace("&", "")
    except NoMathematics:
        return None, place
    words = text[place:reader.place]
    is_article = re.fullmatch(r"a|A|I|[a-z]{3,}", words.strip()) and words not in GREEK
    is_whole = not re.compile(r"[\w(']").match(text, reader.place)
    return (tex, reader.place) if is_whole and not is_article else (None, place)


def pieces_of(text, names):
    """Returns the parts of a piece: whether each is an equation, and its text as TeX, or as Markdown with TeX in it."""
    listed = re.match(r"([A-Za-z]\w*'?(?:, [A-Za-z]\w*'?)*)(?:\(\w\))?: ", text)
    if listed and all(Reader("", names).is_name(name) for name in listed[1].split(", ")):
        heads = ", ".join(f"${symbol(name)}$" for name in listed[1].split(", "))
        return [(False, f"{heads}: {words_with_mathematics(text[listed.end():], names)}")]
    reader = Reader(text, names)
    try:
        tex = reader.equation()
    except NoMathematics:
        return [(False, words_with_mathematics(text, names))]
    rest = text[reader.place:]
    if not rest.strip():
        return [(True, tex)]
    if "&" in tex and re.match(r", \w+'?(: | = |, )", rest):
        return [(True, tex)] + pieces_of(rest[2:], names)
    return [(False, words_with_mathematics(text, names))]


def to_markdown(formula, parameters):
    """Returns a formula as Markdown: its equations, aligned, and a list of what else it says."""
    text = re.sub(r"\n\s+(?=[+-])", " ", formula.strip())
    names = set(parameters) | set(re.findall(r"(?:^|[;\n,] *|: )([A-Za-z]\w*)(?:\([\w,]+\))? =", text))
    equations, notes = [], []
    for line in text.split("\n"):
        for piece in re.split(r";\s+|\s{3,}|,\s{2,}", line.strip()):
            for is_equation, made in pieces_of(piece, names):
                (equations if is_equation else notes).append(made)
    out = ""
    if equations:
        body = " \\\\\n".join(equations)
        out += f"$$\n\\begin{{aligned}}\n{body}\n\\end{{aligned}}\n$$\n\n"
    return out + "".join(f"- {note}\n" for note in notes) + ("\n" if notes else "")
