"""Make GLSL small for pages to fetch: comments, lines, C++ branches, house macros and long names go; the program stays the same.

Names that the outside knows are kept: uniforms, inputs, outputs, main, whatever begins with gl_, and macros that are set from outside.
"""
import re

TOKEN = re.compile(r"0[xX][0-9a-fA-F]+u?|[A-Za-z_]\w*|(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?[fuFU]?|==|!=|<=|>=|&&|\|\||\+\+|--|<<|>>|[-+*/%&|^]=|\S")
HEX = re.compile(r"0[xX][0-9a-fA-F]+u?")
TYPES = "void|bool|int|uint|float|[biu]?vec[234]|mat[234]|[iu]?sampler\\w+"
SWIZZLE = re.compile(r"[xyzw]{1,4}|[rgba]{1,4}|[stpq]{1,4}")
# Built-in functions whose names are also given to variables.
BUILT_IN = set("""abs acos all any asin atan ceil clamp cos cosh cross dFdx dFdy degrees determinant distance dot equal exp exp2 faceforward
    floatBitsToInt floatBitsToUint floor fract fwidth greaterThan greaterThanEqual intBitsToFloat inverse inversesqrt isinf isnan length lessThan
    lessThanEqual log log2 main max min mix mod modf normalize not notEqual outerProduct pow radians reflect refract round roundEven sign sin sinh
    smoothstep sqrt step tan tanh texelFetch texture textureGrad textureLod textureSize transpose trunc uintBitsToFloat""".split())


def without_comments(text):
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.DOTALL)
    text = re.sub(r"//.*", "", text)
    return text.replace("\\\n", " ")


def without_branches(lines, never):
    """Lines without those of conditions on one name alone that is never defined; other conditions stay."""
    kept, stack = [], []  # of (decided here, taken)
    for line in lines:
        directive = re.match(r"\s*#\s*(ifdef|ifndef|if|else|elif|endif)\b\s*(.*)", line)
        taken = all(now for _, now in stack)
        if directive:
            word, rest = directive[1], directive[2].strip()
            if word in ("ifdef", "ifndef", "if"):
                ours = word != "if" and rest in never
                stack.append((ours, word == "ifndef" if ours else True))
                if ours or not taken:
                    continue
            elif word == "endif":
                ours, _ = stack.pop()
                if ours or not all(now for _, now in stack):
                    continue
            else:
                ours, now = stack[-1]
                if ours:
                    stack[-1] = (ours, not now)
                    continue
                if not taken:
                    continue
        elif not taken:
            continue
        kept.append(line)
    return kept


def without_house_macros(lines):
    """TUKOR_... macros of one argument or none, written out."""
    macros, kept = {}, []
    for line in lines:
        define = re.match(r"\s*#\s*define\s+(TUKOR_\w+)(?:\((\w*)\))?[ \t]*(.*)", line)
        if define:
            macros[define[1]] = (define[2], define[3].strip())
            continue
        for _ in range(4):  # macros may use each other
            for name, (argument, body) in macros.items():
                if argument is None:
                    line = re.sub(rf"\b{name}\b", lambda _: body, line)
                else:
                    line = re.sub(rf"\b{name}\(([^()]*)\)",
                                  lambda use: re.sub(rf"\b{argument}\b", use[1], body) if argument else body, line)
        kept.append(line)
    return kept


def names():
    letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
    yield from letters
    for first in letters:
        for second in letters + "0123456789":
            yield first + second


def shortened(tokens_of_lines):
    """The same tokens with short names for what the text itself declares."""
    code = [token for tokens in tokens_of_lines for token in tokens if not (tokens and tokens[0] == "#")]
    outside = {token for tokens in tokens_of_lines if tokens and tokens[0] == "#" for token in tokens}
    structs = {code[i + 1] for i, token in enumerate(code) if token == "struct"}
    types = re.compile("(?:" + "|".join([TYPES, *map(re.escape, structs)]) + r")\Z")
    declared, depth = set(structs), 0
    for i, token in enumerate(code):
        depth += {"{": 1, "}": -1}.get(token, 0)
        if not types.match(token) or i + 1 >= len(code) or not re.match(r"[A-Za-z_]", code[i + 1]):
            continue
        before = code[i - 1] if i else ""
        if before in ("uniform", "in", "out") and depth == 0 and code[i - 2] not in ("(", ","):
            outside.add(code[i + 1])
        else:
            declared.add(code[i + 1])
    declared -= outside | BUILT_IN
    declared = {name for name in declared if len(name) > 1 and not SWIZZLE.fullmatch(name) and not name.startswith("gl_")}
    used = set(code) | outside | BUILT_IN
    fresh = (name for name in names() if name not in used and name not in ("do", "if", "in"))
    order = sorted(declared, key=lambda name: (-code.count(name), name))
    return dict(zip(order, fresh))


def number(token):
    if HEX.fullmatch(token) or not re.match(r"[\d.]", token):
        return token
    token = re.sub(r"(?<=[\d.])[fF]$", "", token) if "." in token or "e" in token.lower() else token
    if "." in token:
        token = re.sub(r"(\.\d*?)0+(?=$|[eE])", r"\1", token)
        token = re.sub(r"^0+(?=\.\d)", "", token)
    return token


def joined(tokens):
    text, before = "", ""
    for token in tokens:
        words = re.match(r"\w|\.\d", token) and re.match(r"\w|\.\d", before)
        signs = before and token[0] in "+-" and before[-1] == token[0]
        text += (" " if words or signs else "") + token
        before = token
    return text


def lines_and_tokens(text, never):
    """Its lines, without the branches of what is `never` defined, and their tokens."""
    lines = without_house_macros(without_branches(without_comments(text).splitlines(), {"__cplusplus", *never}))
    # Everything is highp by the statements at the top, which stay.
    lines = [line if line.startswith("precision") else re.sub(r"\bhighp\s+", "", line) for line in lines]
    lines = [line.strip() for line in lines if line.strip() and not re.match(r"\s*#\s*line\b", line)]
    return lines, [TOKEN.findall(line) for line in lines]


def compacted(text, never=(), beside=()):
    """`beside` are the shaders that it is stored with, itself too: what they share comes out alike, and is compressed to nothing."""
    lines, tokens_of_lines = lines_and_tokens(text, never)
    short = shortened(sum((lines_and_tokens(other, ())[1] for other in beside), []) if beside else tokens_of_lines)
    out, code = [], []
    for line, tokens in zip(lines, tokens_of_lines):
        if tokens[0] == "#":
            if code:
                out.append(joined(code))
            code = []
            out.append(re.sub(r"\s+", " ", line))
        else:
            code += [number(short.get(token, token)) for token in tokens]
    if code:
        out.append(joined(code))
    return "\n".join(out) + "\n"
