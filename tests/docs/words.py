"""Words that the language rules of the project rule out, in pages, comments and messages."""

import pathlib
import re

# What to write instead: again, indefinitely, also, without success, back and forth, slightly, makes
# progress, static obstacle, moving obstacle, obstacle, no robot, a robot; publish, receive,
# estimate, consider; each client, every user; more costly; around; is at standstill.
BANNED = ("anew", "for ever", "forever", "likewise", "in vain", "to and fro", "a hair", "gets on",
          "get on", "what stands", "what moves", "what is in the way of", "nobody", "somebody",
          "anybody", "everybody", "whoever", "whence", "tells", "hears", "heard", "believes",
          "dearer", "way back", "stands still", "stand still", "the one who", "ought to")
# A model or an engine may be what moves the robots.
PATTERN = re.compile(r"\b(" + "|".join(word.replace(" ", r"\s+") for word in BANNED) +
                     r")\b(?! (?:the )?robots?\b)", re.IGNORECASE)
FOLDERS = ("src", "apps", "ros", "tests", "experiments", "benchmarks", "examples", "python", "vda5050",
           "viewer/src", "tools", "cmake", "scenarios", "packaging")
CPP_LIKE = (".cpp", ".hpp", ".ts", ".js", ".mjs", ".css")
# A comment or a text, to be read; characters are skipped so that '"' opens nothing.
CPP_TOKENS = re.compile(r"//(?P<line>[^\n]*)|/\*(?P<block>.*?)\*/|R\"(?P<d>\w*)\((?P<raw>.*?)\)(?P=d)\""
                        r"|\"(?P<text>(?:\\.|[^\"\\\n])*)\"|'(?:\\.|[^'\\\n])'", re.DOTALL)
SCRIPT_TOKENS = re.compile(r"#(?P<line>[^\n]*)|\"\"\"(?P<block>.*?)\"\"\"|\"(?P<text>(?:\\.|[^\"\\\n])*)\"",
                           re.DOTALL)


def readable(text: str, tokens: re.Pattern) -> str:
    """The text with all but comments and messages blanked; lines stay where they are."""
    parts, end = [], 0
    for token in tokens.finditer(text):
        parts.append(re.sub(r"[^\n]", " ", text[end:token.start()]))
        read = next((v for k, v in token.groupdict().items() if v is not None and k != "d"), "")
        parts.append(" " + read)
        end = token.end()
    return "".join(parts)


def check_text(where: str, text: str) -> list:
    return [f"{where}:{text.count(chr(10), 0, found.start()) + 1}: expected plain words, "
            f"found '{' '.join(found.group().split())}'" for found in PATTERN.finditer(text)]


def check_words(root: pathlib.Path, pages: list) -> list:
    errors = []
    for page in pages:
        errors += check_text(str(page.path.relative_to(root)), page.path.read_text(encoding="utf-8"))
    here = pathlib.Path(__file__).resolve().parent  # which has the words, and tests that find them
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            cpp = path.suffix in CPP_LIKE
            if not cpp and path.suffix not in (".py", ".sh", ".cmake", ".yaml") or here in path.resolve().parents:
                continue
            if "node_modules" in path.parts:
                continue
            text = readable(path.read_text(encoding="utf-8", errors="replace"),
                            CPP_TOKENS if cpp else SCRIPT_TOKENS)
            errors += check_text(str(path.relative_to(root)), text)
    return errors
