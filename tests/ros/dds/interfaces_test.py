# SPDX-License-Identifier: Apache-2.0
"""Checks the IDL files of the DDS nodes against ROS 2's interfaces: interfaces_test.py IDL...

The expected structs are derived from interfaces.txt by the rules of rosidl and, for services, with
the header of rmw_cyclonedds_cpp. Topic types that are Fairway's own are not checked.
"""

import pathlib
import re
import sys
import unittest

IDL_FILES = [pathlib.Path(argument) for argument in sys.argv[1:]]
INTERFACES = pathlib.Path(__file__).with_name("interfaces.txt")
PLAIN = {"bool": "boolean", "int8": "int8", "uint8": "octet", "int16": "short",
         "uint16": "unsigned short", "int32": "long", "uint32": "unsigned long",
         "int64": "long long", "uint64": "unsigned long long", "float32": "float",
         "float64": "double", "string": "string"}
OWN = ("fairway_msgs::", "rmw_cyclonedds::")
HEADER = ("rmw_cyclonedds::dds_::ServiceHeader_", "header")
UUID = "unique_identifier_msgs/UUID goal_id"


def dds_name(full):
    """The name on the wire, for instance of nav2_msgs/action/FollowPath_Goal."""
    package, kind, name = full.split("/")
    return f"{package}::{kind}::dds_::{name}_"


def field(text):
    """One field, for instance "uint8[16] uuid", as (IDL type, name with array size)."""
    kind, name = text.split()
    kind, bracket, size = kind.partition("[")
    size = size.rstrip("]")
    if "/" in kind:
        package, message = kind.rsplit("/", 1)
        kind = dds_name(f"{package}/msg/{message}" if "/" not in package else kind)
    else:
        kind = PLAIN[kind]
    if bracket and not size:
        return (f"sequence<{kind}>", name)
    return (kind, f"{name}[{size}]" if size else name)


def fields(text):
    return [field(part.strip()) for part in text.split(",") if part.strip()]


def expected_structs():
    structs = {}

    def add(full, text, header=False):
        found = fields(text) or [("octet", "structure_needs_at_least_one_member")]
        structs[dds_name(full)] = ([HEADER] if header else []) + found

    for line in INTERFACES.read_text(encoding="utf-8").splitlines():
        if line.startswith("#"):
            continue
        full, _, text = line.partition(":")
        parts = text.split("---")
        if "/srv/" in full:
            add(f"{full}_Request", parts[0], header=True)
            add(f"{full}_Response", parts[1], header=True)
        elif "/action/" in full:
            for name, part in zip(("Goal", "Result", "Feedback"), parts, strict=True):
                add(f"{full}_{name}", part)
            add(f"{full}_SendGoal_Request", f"{UUID}, {full}_Goal goal", header=True)
            add(f"{full}_SendGoal_Response", "bool accepted, builtin_interfaces/Time stamp",
                header=True)
            add(f"{full}_GetResult_Request", UUID, header=True)
            add(f"{full}_GetResult_Response", f"int8 status, {full}_Result result", header=True)
            add(f"{full}_FeedbackMessage", f"{UUID}, {full}_Feedback feedback")
        else:
            add(full, text)
    return structs


def idl_structs(text):
    """The structs of an IDL file by their full names, with full names of their fields' types."""
    text = re.sub(r"//[^\n]*|^#[^\n]*", "", text, flags=re.MULTILINE)
    modules, structs = [], {}
    tokens = re.compile(r"module\s+(\w+)\s*\{|(?:@topic\s+)?struct\s+(\w+)\s*\{([^}]*)\}\s*;|\}\s*;")
    for token in tokens.finditer(text):
        if token.group(1):
            modules.append(token.group(1))
        elif token.group(2):
            prefix = "::".join(modules) + "::"
            found = []
            for declaration in filter(None, (d.strip() for d in token.group(3).split(";"))):
                kind, name = declaration.rsplit(None, 1)
                kind = re.sub(r"(?<![\w:])([A-Z]\w*_)(?![\w:])", lambda m: prefix + m.group(1), kind)
                found.append((kind, name))
            structs[prefix + token.group(2)] = found
        else:
            modules.pop()
    return structs


class InterfacesTest(unittest.TestCase):
    def test_every_struct_has_the_fields_of_its_interface(self):
        expected = expected_structs()
        found = {}
        for file in IDL_FILES:
            found.update(idl_structs(file.read_text(encoding="utf-8")))
        found = {name: value for name, value in found.items() if not name.startswith(OWN)}
        self.assertEqual(sorted(found), sorted(expected))
        for name, value in expected.items():
            self.assertEqual(found[name], value, name)

    def test_a_difference_is_found(self):
        text = "module a { module b { @topic struct C_ { long d; sequence<E_> e[2]; }; }; };"
        self.assertEqual(idl_structs(text),
                         {"a::b::C_": [("long", "d"), ("sequence<a::b::E_>", "e[2]")]})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
