"""Trees of `expressions` as text in the notations that publications accept."""
from fractions import Fraction

GREEK = "alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi rho sigma tau phi chi psi omega".split()


class Notation:
    """A notation with names for the symbols of a model; `symbols` are the lines of the section `[symbols]`."""
    def __init__(self, kind, random, names):
        self.kind, self.random, self.symbols, self.names = kind, random, {}, {}
        self.dot = random.choice(["{}_dot", "{}dot", "d{}"])
        for name in sorted(names):
            if random.random() < 0.2:
                self.rename(name)

    def rename(self, name):
        k = len(self.symbols)
        if self.kind == "latex":
            new = f"\\{GREEK[k % len(GREEK)]}_{{{'abcdefgh'[k // len(GREEK)]}}}"
        elif self.kind == "matlab" and self.random.random() < 0.5:
            new = f"p.{'abcdefghijklmnop'[k % 16]}{k}"
        elif self.kind == "python" and self.random.random() < 0.5:
            new = f"par[{k}]"
        elif self.kind == "tripos":
            return
        else:
            new = f"sym_{k}"
        self.names[name] = new
        self.symbols[new] = name

    def name(self, full):
        """A name with its dots."""
        bare = full.rstrip("'")
        dots = len(full) - len(bare)
        if self.kind == "tripos":
            return full
        base = self.names.get(bare)
        if self.kind == "latex":
            dot = {0: "", 1: "\\dot", 2: "\\ddot"}[dots]
            if base:
                letter, index = base.split("_")
                return f"{dot}{{{letter}}}_{index}" if dot else base
            letter, index = split(bare)
            letter = f"\\{letter}" if letter in GREEK else letter
            letter = f"\\mathrm{{{letter}}}" if len(letter) > 1 and letter[0] != "\\" else letter
            head = f"{dot}{{{letter}}}" if dot else letter
            return f"{head}_{{{index}}}" if index else head
        if not dots:
            return base or bare
        # Rates keep the name of the model: a renamed rate would need a line of its own. Those of speeds need one.
        if bare[0] == "u":
            self.symbols[f"acc_{bare}"] = full
            return f"acc_{bare}"
        if dots == 1:
            return self.dot.format(bare)
        return {"{}_dot": "{}_ddot", "{}dot": "{}ddot", "d{}": "dd{}"}[self.dot].format(bare)

    def text(self, tree):
        return self.sum(tree)

    def sum(self, tree):
        if tree[0] != "+":
            return self.product(tree)
        parts = []
        for term in tree[1]:
            text = self.product(term) if term[0] != "+" else f"({self.sum(term)})"
            if self.kind == "latex" and term[0] == "+":
                text = self.group(self.sum(term))
            parts.append(text if text.startswith("-") or not parts else f"+ {text}")
        return " ".join(f"- {p[1:].lstrip()}" if k and p.startswith("-") else p for k, p in enumerate(parts))

    def group(self, text):
        return f"\\left({text}\\right)" if self.kind == "latex" else f"({text})"

    def product(self, tree):
        factors = flat(tree)
        sign, number = "", Fraction(1)
        over, under = [], []
        for f in factors:
            if f[0] == "n" and f[1] < 0:
                sign = "" if sign else "-"
                f = ("n", -f[1])
            if f[0] == "n":
                number *= f[1]
            elif f[0] == "^" and f[2] < 0:
                under.append(f[1] if f[2] == -1 else ("^", f[1], -f[2]))
            else:
                over.append(f)
        if number.numerator != 1:
            over.insert(0, ("n", Fraction(number.numerator)))
        if number.denominator != 1:
            under.insert(0, ("n", Fraction(number.denominator)))
        if self.kind == "latex":
            if not under and len(over) == 1 and sign:
                return sign + self.factor(over[0])
            top = self.row(over) or "1"
            return sign + (f"\\frac{{{top}}}{{{self.row(under)}}}" if under else top)
        text = "*".join(self.factor(f) for f in over) or "1"
        for f in under:
            text += "/" + self.factor(f, True)
        return sign + text

    def row(self, factors):
        """Factors side by side in LaTeX: functions last, since their argument has no end of its own."""
        if len(factors) == 1 and factors[0][0] == "+":
            return self.sum(factors[0])
        texts = [self.factor(f) for f in sorted(factors, key=rank)]
        return "".join((" \\cdot " if k and t[0].isdigit() else " \\, " if k else "") + t for k, t in enumerate(texts))

    def factor(self, tree, divisor=False):
        kind = tree[0]
        if kind == "n":
            n = tree[1]
            text = str(n.numerator if hasattr(n, "numerator") else n)
            if hasattr(n, "denominator") and n.denominator != 1:
                return self.group(f"{n.numerator}/{n.denominator}") if self.kind != "latex" else \
                    self.group(f"\\frac{{{n.numerator}}}{{{n.denominator}}}")
            return self.group(text) if text.startswith("-") else text
        if kind == "s":
            if tree[1] == "pi":
                return {"latex": "\\pi", "python": "np.pi"}.get(self.kind, "pi")
            return self.name(tree[1])
        if kind == "^":
            return self.powered(tree)
        if kind == "f":
            return self.function(tree)
        return self.group(self.sum(tree))

    def powered(self, tree):
        base, e = tree[1], tree[2]
        if e == 1:
            return self.factor(base)
        if e.denominator == 2:
            root = ("f", "sqrt", base)
            return self.factor(root) if e.numerator == 1 else self.powered(("^", root, e * 2))
        if e < 0:
            return self.group(self.product(tree))
        if self.kind == "latex":
            if base[0] == "f" and base[1] in ("sin", "cos", "tan", "sec", "csc", "cot"):
                return f"\\{base[1]}^{{{e}}}{self.group(self.sum(base[2]))}"
            text = self.factor(base)
            return f"{text if base[0] == 's' else self.wrap(text)}^{{{e}}}"
        text = self.factor(base)
        text = text if base[0] in "sf" else self.wrap(text)
        return text + {"python": "**", "matlab": "^"}.get(self.kind, "^") + str(e)

    def wrap(self, text):
        return text if text.startswith("\\left(") and text.count("\\left(") == 1 or \
            self.kind != "latex" and text.startswith("(") and matched(text) else self.group(text)

    def function(self, tree):
        name, argument = tree[1], self.sum(tree[2])
        if self.kind == "latex":
            if name == "sqrt":
                return f"\\sqrt{{{argument}}}"
            if name == "abs":
                return f"\\left|{argument}\\right|"
            if tree[2][0] == "s" and self.random.random() < 0.4 and "'" not in tree[2][1]:
                return f"\\{name} {argument}"
            return f"\\{name}{self.group(argument)}"
        if self.kind == "python":
            if name in ("sec", "csc", "cot"):
                of = {"sec": "cos", "csc": "sin", "cot": "tan"}[name]
                return f"(1/np.{of}({argument}))"
            return f"np.{name}({argument})"
        return f"{name}({argument})"


def rank(factor):
    """Numbers, then other factors, then functions."""
    return 0 if factor[0] == "n" else 2 if factor[0] == "f" else 1


def matched(text):
    depth = 0
    for k, c in enumerate(text):
        depth += (c == "(") - (c == ")")
        if depth == 0:
            return k == len(text) - 1
    return False


def split(name):
    """Letters and index of a name: `q12` is q with the index 12."""
    head = name.rstrip("0123456789")
    if "_" in head:
        head, _, tail = name.partition("_")
        return head, tail
    return head, name[len(head):]


def flat(tree):
    """Factors of products within products."""
    if tree[0] != "*":
        return [tree]
    return [f for t in tree[1] for f in flat(t)]
