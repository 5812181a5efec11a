import click
import pytest
from click.testing import CliRunner

from iconstudio.cli.lists import ListCommand, Numbers, Words, flat, is_number


@click.command(
    cls=ListCommand, goes_on={"--names": {"a", "b", "c"}.__contains__, "--sizes": is_number}
)
@click.argument("file")
@click.option("--names", type=Words(), multiple=True, default=(("a", "b"),))
@click.option("--sizes", type=Numbers(9), multiple=True, default=((1.0, 2.0),))
@click.option("--out")
def command(file, names, sizes, out):
    click.echo(f"{file} {flat(names)} {flat(sizes)} {out}")


@pytest.mark.parametrize(
    ("arguments", "answer"),
    [
        ("f.json", "f.json ('a', 'b') (1.0, 2.0) None"),
        ("f.json --names c", "f.json ('c',) (1.0, 2.0) None"),
        ("f.json --names a,c --out d", "f.json ('a', 'c') (1.0, 2.0) d"),
        ("--names a c f.json", "f.json ('a', 'c') (1.0, 2.0) None"),
        ("--names a --names c f.json", "f.json ('a', 'c') (1.0, 2.0) None"),
        ("--sizes 0.5 1 2 f.json --out 3", "f.json ('a', 'b') (0.5, 1.0, 2.0) 3"),
        ("--sizes 0.5,1 --names b f.json", "f.json ('b',) (0.5, 1.0) None"),
        ("--out 7 f.json --sizes 3", "f.json ('a', 'b') (3.0,) 7"),
        ("--names x f.json", "f.json ('x',) (1.0, 2.0) None"),
    ],
)
def test_lists_with_commas_spaces_or_again(arguments, answer):
    assert CliRunner().invoke(command, arguments.split()).output.strip() == answer


@pytest.mark.parametrize("value", ["x", "", "0", "-1", "10", "nan", "inf", "1,,x"])
def test_what_is_no_list_of_numbers_is_refused(value):
    result = CliRunner().invoke(command, ["f.json", "--sizes", value])
    assert result.exit_code == 2
    assert "numbers" in result.output
