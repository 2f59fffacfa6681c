"""Runs the tests of a script: all of its functions named test_..., each with a folder of its own."""
import sys
import tempfile


def main(tests, wanted):
    """`tests`: functions by name; `wanted`: only those whose names contain one of these words, if there are any."""
    failed = 0
    for name, test in tests.items():
        if not name.startswith("test_") or wanted and not any(word in name for word in wanted):
            continue
        with tempfile.TemporaryDirectory() as folder:
            try:
                test(folder)
                print(f"ok      {name}")
            except AssertionError as error:
                failed += 1
                print(f"FAILED  {name}: {error}")
    sys.exit(1 if failed else 0)
