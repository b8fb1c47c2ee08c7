"""What a module has in Python: the classes of systems, equations as LaTeX, samples, type stubs."""

import collections
import functools
import inspect
import keyword
import re

Samples = collections.namedtuple("Samples", ["t", "q", "p", "energy", "invariants"])
Samples.__doc__ = "States at several times, as NumPy arrays whose first axis is the time."

GREEK = "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi rho sigma tau upsilon phi chi psi omega"
COMMANDS = set(f"sin cos tan sinh cosh tanh exp ln min max {GREEK}".split())
OPERATORS = {"+=": r"\mathrel{+}=", "<=": r"\le", ">=": r"\ge", "==": "=", "%": r"\bmod", "": r"\,"}
# Brackets, and what ends them.
OPENING = {
    "Σ_{": (r"\sum_{", "}"),
    "sqrt(": (r"\sqrt{", "}"),
    "^(": ("^{", "}"),
    "[": ("_{", "}"),
    "(": (r"\left(", r"\right)"),
    "{": (r"\left\{", r"\right\}"),
}
TOKENS = re.compile(r"Σ_\{|sqrt\(|\^\(|\^-?[\w.]+|\]\[|[\d.]+\w*|[^\W\d](?:\w|::)*| *(?:\+=|[<>=]=|[-+/%=<>]) +| +|, *|.")


class Equations:
    """The energies and the equations of motion of a system. `print` shows text; a notebook shows formulas."""

    def __init__(self, lines):
        self.lines = lines

    def __str__(self):
        return "\n".join(self.lines) or "The equations of this system are too long to be shown."

    __repr__ = __str__

    def _repr_latex_(self):
        lines = [aligned(line) for line in self.lines]
        return "$$\\begin{aligned}\n" + " \\\\\n".join(lines) + "\n\\end{aligned}$$" if lines else None


def aligned(line):
    """Translates a formula such as `dp[0]/dt = -gm q[0] / r^3`, aligned at its first relation."""
    rate = re.match(r"d([pq][^/]*)/dt", line)
    line = rf"\dot {latex(rate[1])}{latex(line[rate.end():])}" if rate else latex(line)
    return re.sub(r"(\\mathrel\{\+\}|)= ", r"&\g<0>", line, count=1)


def latex(formula):
    text, closing = "", []
    for token in TOKENS.findall(formula):
        if token in OPENING:
            text += OPENING[token][0]
            closing.append(OPENING[token][1])
        elif token in ("]", ")", "}"):
            text += closing.pop() if closing else ""
        elif token[0] == "^":
            text += f"^{{{latex(token[1:])}}}"
        elif token == "][":
            text += ","
        elif token[0] in " ," or token.strip() in OPERATORS:
            operator = token.strip()
            text += ",\\;" if operator == "," else f" {OPERATORS.get(operator, operator)} "
        else:
            text += word(token)
    return text


def word(token):
    head = token.rstrip("0123456789")
    digits = token[len(head) :]
    if not head[:1].isalpha():
        return token.replace("..", r" \ldots ")
    if head in ("if", "else", "for", "in", "where"):
        return rf"\text{{ {head} }}"
    head = r"\pi " if head == "PI" else rf"\{head} " if head in COMMANDS else head
    if len(head) > 1 and head[0] != "\\":
        head = r"\mathrm{" + head.replace("_", r"\_") + "}"
    return f"{head}_{{{digits}}}" if digits else head


def system_class(base, module, kind, doc, shape, fields, compositions, functions):
    """The class of a kind of system, and its text in the type stubs. Functions are written in Rust."""
    for name in filter(keyword.iskeyword, fields or []):
        help = f'help: write `#[serde(rename = "{name}_")]` above this field'
        raise ImportError(f"the field `{name}` of {kind.name} is a keyword of Python\n{help}")
    parameters = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY) for name in fields or []]
    contents = {"_kind": kind, "__module__": module, "__slots__": (), "__signature__": inspect.Signature(parameters)}
    contents["__doc__"] = (
        f"{doc.strip()}\n\nParameters: {', '.join(fields or [])}\nShape of q and of p: {shape}\n"
        f"Compositions: {', '.join(compositions)}\n\n"
        "Times, q, p and energies have the units of the Hamiltonian, which `equations()` shows."
    )
    for name, function, _, _ in functions:
        contents[name] = bound(function)
    arguments = "".join(f", {name}: Any" for name in fields) if fields is not None else ", **parameters: Any"
    arguments = ", *" + arguments if fields else arguments
    stubs = f"\nclass {kind.name}(System):\n    def __init__(self{arguments}) -> None: ...\n"
    for name in fields or []:
        stubs += f"    @property\n    def {name}(self) -> Any: ...\n"
    for name, _, arguments, result in functions:
        arguments = "".join(f", {argument}: {python_type(rust)}" for argument, rust in arguments)
        stubs += f"    def {name}(self{arguments}) -> {python_type(result)}: ...\n"
    return type(base)(kind.name, (base,), contents), stubs


def bound(function):
    """A function that binds to instances, which those that are not written in Python do not."""
    return functools.wraps(function)(lambda system, *arguments, **keywords: function(system, *arguments, **keywords))


def python_type(rust):
    """The Python type for a Rust type of a signature."""
    inner = re.fullmatch(r"Vec<(.*)>", rust)
    if inner:
        return f"list[{python_type(inner[1].strip())}]"
    if re.fullmatch(r"[ui](\d+|size)", rust):
        return "int"
    return {"f64": "float", "f32": "float", "bool": "bool", "String": "str", "()": "None"}.get(rust, "Any")
