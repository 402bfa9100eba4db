"""Results of the tool against the schemas in docs/schemas."""

import json
import pathlib
import subprocess
import tempfile

KINDS = {"object": dict, "array": list, "string": str, "boolean": bool, "integer": int,
         "number": (int, float), "null": type(None)}
DYNABARN = {"start": [-3, 0, 0], "goal": [3, 0], "goal_radius": 1.0, "timeout_s": 20.0,
            "worlds": [{"world": 0, "obstacles": [
                {"name": "cart", "radius": 0.5, "keys": [[0, 0, 3], [9, 0, -3]]}]}]}
# A car beside a bay between two boxes, in the form of the TPCAP competition.
PARKING = "0,4,0,5,0,0,2,4,4,-8,-1,-1,-1,-1,1,-8,1,11,-1,18,-1,18,1,11,1\n"
PROBLEM = "0 free 0  0 0 0  1 0.2 0  2 0.4 0  0 0 0  -1 -1.5 4 1.5\n"


def is_a(value, kind: str) -> bool:
    return isinstance(value, KINDS[kind]) and (kind == "boolean" or not isinstance(value, bool))


def violations(value, schema: dict, where: str) -> list:
    """What of the JSON schema does not hold: of its keywords those that our schemas use."""
    kinds = schema.get("type", list(KINDS))
    kinds = [kinds] if isinstance(kinds, str) else kinds
    if not any(is_a(value, kind) for kind in kinds):
        return [f"{where}: expected {' or '.join(kinds)}, found {type(value).__name__}"]
    errors = []
    if "const" in schema and value != schema["const"]:
        errors.append(f"{where}: expected {schema['const']}, found {value}")
    if "enum" in schema and value not in schema["enum"]:
        errors.append(f"{where}: expected one of {schema['enum']}, found {value}")
    if isinstance(value, list):
        if not schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", len(value)):
            errors.append(f"{where}: expected another number of items, found {len(value)}")
        for index, item in enumerate(value):
            errors += violations(item, schema.get("items", {}), f"{where}[{index}]")
    if isinstance(value, dict):
        known = schema.get("properties", {})
        errors += [f"{where}: expected {key}, found none" for key in schema.get("required", [])
                   if key not in value]
        for key, item in value.items():
            inner = known.get(key, schema.get("additionalProperties", True))
            if inner is False:
                errors.append(f"{where}: expected no key that the schema lacks, found {key}")
            elif isinstance(inner, dict):
                errors += violations(item, inner, f"{where}.{key}")
    return errors


def check_schemas(root: pathlib.Path, tool: pathlib.Path) -> list:
    """Runs each command that has a schema, where it is quick."""
    schemas = {path.name.split(".schema")[0]: json.loads(path.read_text())
               for path in sorted((root / "docs/schemas").glob("*.schema.json"))}
    workshop = root / "scenarios/maps/workshop.yaml"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "problem.txt").write_text(PROBLEM)
        (folder / "moving.json").write_text(json.dumps(DYNABARN))
        (folder / "parking").mkdir()
        (folder / "parking/Case1.csv").write_text(PARKING)
        worlds = root / "benchmarks/cases/make_narrow_worlds.py"
        subprocess.run([worlds, folder / "worlds", "--count", "1"], check=True, capture_output=True)
        subprocess.run([root / "benchmarks/cases/make_body_tasks.py", folder / "bodies"], check=True)
        subprocess.run([root / "benchmarks/cases/make_people_cases.py", folder / "people"], check=True)
        recorded = [tool, "simulate", root / "scenarios/doorways.yaml", "--log", folder / "run.mcap"]
        subprocess.run(recorded, check=True, capture_output=True)
        plan = ["plan", workshop, "--start", "2,4.4", "--goal", "22.2,14.6"]
        runs = [plan, [*plan, "--set", "robot.radius=1"], ["simulate", root / "scenarios/workshop.yaml"],
                ["simulate", root / "scenarios/workshop.yaml", "--time-limit", "1"],
                ["solve", folder / "problem.txt", "--out", folder / "problem.res"],
                ["barn", folder / "worlds", "--shard", "1/1"], ["merge", folder / "barn.json"],
                ["dynabarn", folder / "moving.json"],
                ["bodies", folder / "bodies", "--tasks", "corner_car_mirrored", "--shard", "1/1"],
                ["parking", folder / "parking"], ["people", "recorded", folder / "people"],
                ["people", "crowdnav", folder / "people", "--cases", "0"],
                ["replay", folder / "run.mcap"], ["compare", folder / "plan.json", folder / "simulate.json"],
                ["statuses"]]
        errors = []
        for run in runs:
            out = folder / f"{run[0]}.json"  # which later commands read
            subprocess.run([tool, *run, "--json", out], capture_output=True, check=False)
            result = json.loads(out.read_text())
            schema = str(result.get("schema", "")).removeprefix("fairway/")
            if schema not in schemas:
                errors.append(f"fairway {run[0]}: expected a schema of docs/schemas, found '{schema}'")
                continue
            errors += [f"docs/schemas/{schema}.schema.json: fairway {run[0]}: {error}"
                       for error in violations(result, schemas[schema], "result")]
    return errors
