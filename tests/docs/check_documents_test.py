"""Every check of tests/docs finds the fault that it is for, and leaves a sound page alone."""

import pathlib
import tempfile
import unittest

import code_blocks
import commands
import options
import pages
import schemas
import words


class Checks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "docs").mkdir()
        (self.root / "examples").mkdir()
        # Prints its arguments, and fails when they ask for it.
        self.tool = self.root / "tool"
        self.tool.write_text('#!/bin/sh\necho "ran $*"\n[ "$1" != fail ]\n')
        self.tool.chmod(0o755)

    def page(self, text: str):
        path = self.root / "docs/page.md"
        path.write_text(text)
        return pages.read_page(path)

    def test_links_lead_to_files_and_headings(self):
        page = self.page("# A page\n[a](#a-page) [b](page.md#a-page) [c](https://no.where)\n"
                         "[d](missing.md)\n[e](#missing)\n```text\n[f](missing.md)\n```\n")
        errors = pages.check_links(self.root, [page])
        self.assertEqual([error.split(":")[1] for error in errors], ["3", "4"])

    def test_anchors_are_those_of_github(self):
        self.assertEqual(pages.slug("The `stop`: a proof, (S1)"), "the-stop-a-proof-s1")

    def test_tables_have_as_many_cells_in_every_row(self):
        page = self.page("| a | b |\n|---|---|\n| `x|y` | 2 |\n| 1 |\n\n| 1 | 2 | 3 |\n")
        errors = pages.check_tables(self.root, [page])
        self.assertEqual([error.split(":")[1] for error in errors], ["4"])

    def run_page(self, text: str) -> list:
        return commands.check_page(self.root, self.tool, self.page(text))[0]

    def test_commands_must_succeed(self):
        self.assertEqual(self.run_page("```sh\nfairway work\n```\n"), [])
        self.assertEqual(len(self.run_page("```sh\nfairway fail\n```\n")), 1)
        self.assertEqual(self.run_page("<!-- exit code: 1 -->\n```sh\nfairway fail\n```\n"), [])
        self.assertEqual(len(self.run_page("<!-- exit code: 1 -->\n```sh\nfairway work\n```\n")), 1)

    def test_commands_that_are_left_out_need_a_reason(self):
        self.assertEqual(self.run_page("<!-- not run: long -->\n```sh\nfairway fail\n```\n"), [])
        self.assertEqual(len(self.run_page("<!-- not run -->\n```sh\nfairway fail\n```\n")), 1)

    def test_directives_may_have_several_lines(self):
        page = self.page("<!-- with: int a;\nint b; -->\n```cpp\na = b;\n```\n<!-- a remark\n-->\n")
        self.assertEqual(page.blocks[0].directives["with"], "int a;\nint b;")
        self.assertEqual(code_blocks.wrapped(page.blocks[0], 1, self.root)[0], [])

    def test_output_is_compared(self):
        shown = "```sh\nfairway work\n```\n<!-- output -->\n```text\n{}\n```\n"
        self.assertEqual(self.run_page(shown.format("ran ...")), [])
        self.assertEqual(len(self.run_page(shown.format("walked"))), 1)

    def test_files_of_a_page_are_there(self):
        text = "<!-- file: a/b.txt -->\n```text\nhello\n```\n```sh\nfairway work && grep hello {}\n```\n"
        self.assertEqual(self.run_page(text.format("a/b.txt")), [])
        self.assertEqual(len(self.run_page(text.format("b.txt"))), 1)

    def test_a_comment_calls_no_tool(self):
        page = self.page("```sh\nrm x      # fairway work\n```\n```sh\nbuild/release/bin/fairway work\n```\n")
        self.assertEqual([commands.calls_tool(block) for block in page.blocks], [False, True])

    def test_an_excerpt_of_an_example_is_recognised(self):
        (self.root / "examples/01.cpp").write_text("int main() {\n  int a = 1;\n  return a;\n}\n")
        examples = [code_blocks.normalised((self.root / "examples/01.cpp").read_text())]
        page = self.page("```cpp\nint a = 1;\nreturn a;\n```\n```cpp\nint a = 1;\nreturn 0;\n```\n")
        self.assertEqual([code_blocks.is_excerpt(b, examples) for b in page.blocks], [True, False])

    def test_words_are_found_in_comments_and_messages_only(self):
        text = ('int somebody = 1;  // not for\n// ever\nprint("nobody");\nchar c = \'"\';\n'
                '// what moves the robots\n')
        found = words.check_text("a.cpp", words.readable(text, words.CPP_TOKENS))
        self.assertEqual([error.split("'")[1] for error in found], ["for ever", "nobody"])
        joined = words.check_text("a.md", "It waits for\never.")
        self.assertEqual(len(joined), 1)

    def test_words_are_found_in_names_of_tests(self):
        names = words.test_names("int a;\nTEST(Robot, GetsOnWithNobody) {\nTEST_F(Robot, Drives) {\n")
        found = [error.split(":")[1:] for error in words.check_text("a.cpp", names)]
        self.assertEqual([number for number, *_ in found], ["2", "2"])

    def test_every_command_and_option_is_described(self):
        self.tool.write_text("#!/bin/sh\n[ $# = 1 ] && printf 'Subcommands:\\n  go    Goes\\n' ||"
                             " printf 'Options:\\n  -h,--help\\n  --far TEXT\\n'\n")
        page = self.root / "docs/command_line.md"
        for text, errors in (("## go\n`--far X`\n", 0), ("## come, go\n--far\n", 0),
                             ("## go\n--farther\n", 1), ("## come\n--far\n", 1),
                             ("## For all commands\n--far\n## go\n", 0)):
            page.write_text(text)
            self.assertEqual(len(options.check_options(self.root, self.tool)), errors, text)

    def test_results_are_compared_with_schemas(self):
        schema = {"type": "object", "required": ["a"], "additionalProperties": False,
                  "properties": {"a": {"type": "number"}, "b": {"type": "string", "enum": ["x"]}}}
        self.assertEqual(schemas.violations({"a": 1, "b": "x"}, schema, ""), [])
        for wrong in ({}, {"a": True}, {"a": 1, "b": "y"}, {"a": 1, "c": 2}, []):
            self.assertEqual(len(schemas.violations(wrong, schema, "")), 1, wrong)


if __name__ == "__main__":
    unittest.main()
