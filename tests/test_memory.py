"""Results remembered for a record are found by that very object, not by an equal one."""

from mechproof.record.memory import remember_last


def test_a_result_is_found_by_the_very_same_argument_alone() -> None:
    asked = []

    @remember_last(2)
    def count(names: dict[str, int]) -> int:
        asked.append(names)
        return len(names)

    one, other = {"x": 1}, {"x": 1}
    assert [count(one), count(one), count(other), count(other)] == [1, 1, 1, 1]
    assert [*map(id, asked)] == [id(one), id(other)]


def test_what_is_given_by_name_is_no_other_result() -> None:
    @remember_last(2)
    def join(first: str, second: str = "") -> str:
        return first + second

    assert [join("x"), join("x", second="y"), join("x")] == ["x", "xy", "x"]


def test_no_more_results_are_kept_than_are_said() -> None:
    asked = []

    @remember_last(1)
    def note(names: list[str]) -> None:
        asked.append(names)

    one, other = ["x"], ["y"]
    for names in (one, other, one):
        note(names)
    assert asked == [one, other, one]
