"""The command group: every command, one place for every error, the exit status.

Exit statuses: 0 all went well, 1 an error in Ropewalk itself, 2 bad input, 3 the run broke,
130 interrupted.
"""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Sequence
from typing import Any

import click

from ropewalk import __version__
from ropewalk.cli import failures
from ropewalk.cli.commands.check import check
from ropewalk.cli.commands.compare import compare
from ropewalk.cli.commands.demo import demo
from ropewalk.cli.commands.export import export
from ropewalk.cli.commands.info import info
from ropewalk.cli.commands.lab import lab
from ropewalk.cli.commands.line import line
from ropewalk.cli.commands.modes import modes
from ropewalk.cli.commands.movie import movie
from ropewalk.cli.commands.new import new
from ropewalk.cli.commands.plot import plot
from ropewalk.cli.commands.presets import presets
from ropewalk.cli.commands.report import report
from ropewalk.cli.commands.resume import resume
from ropewalk.cli.commands.ropes import ropes
from ropewalk.cli.commands.run import run
from ropewalk.cli.commands.schema import schema
from ropewalk.cli.commands.settle import settle
from ropewalk.cli.commands.share import share
from ropewalk.cli.commands.sheet import sheet
from ropewalk.cli.commands.sweep import sweep
from ropewalk.cli.commands.view import view
from ropewalk.cli.startup import without_last_rites
from ropewalk.words.nearest import nearest


def _set_debug(context: click.Context, _: click.Parameter, value: bool) -> None:
    if value:
        context.find_object(failures.Settings).debug = True  # type: ignore[union-attr]


def debug_option() -> click.Option:
    """Return the option that shows tracebacks; every command has it."""
    return click.Option(
        ["--debug"],
        is_flag=True,
        hidden=True,
        expose_value=False,
        callback=_set_debug,
        help="Show the traceback of an error in Ropewalk.",
    )


class RopewalkGroup(click.Group):
    """Runs a command and turns whatever goes wrong into one message and an exit status."""

    def add_command(self, cmd: click.Command, name: str | None = None) -> None:
        cmd.params.append(debug_option())
        super().add_command(cmd, name)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        name = args[0]
        if self.get_command(ctx, name) is None and not name.startswith("-"):
            hint = nearest(name, self.list_commands(ctx))
            raise click.UsageError(f'there is no command "{name}"; {hint}', ctx)
        return super().resolve_command(ctx, args)

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(self.commands)  # in the order in which they are worth reading

    def main(
        self,
        args: Sequence[str] | None = None,
        prog_name: str | None = None,
        complete_var: str | None = None,
        standalone_mode: bool = True,
        **extra: Any,
    ) -> Any:
        """Run; exits with the command's status unless `standalone_mode` is off."""
        extra.setdefault("obj", failures.Settings(debug=bool(os.environ.get("ROPEWALK_DEBUG"))))
        name = prog_name or "ropewalk"
        if not standalone_mode:
            return super().main(args, name, complete_var, standalone_mode=False, **extra)
        without_last_rites()
        try:
            with warnings.catch_warnings(), failures.interrupts() as interrupts:
                warnings.simplefilter("ignore", RuntimeWarning)  # numpy's, of broken runs
                warnings.showwarning = failures.show_warning
                failures.refuse_closed_stdout()
                status = super().main(args, name, complete_var, standalone_mode=False, **extra)
            sys.stdout.flush()
        except Exception as error:  # the one place where errors become messages
            lost = interrupts and failures.explain(error)[0] == failures.BUG
            status = failures.report(click.Abort() if lost else error, extra["obj"])
        sys.exit(status if isinstance(status, int) else 0)


@click.group(
    "ropewalk",
    cls=RopewalkGroup,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog="SCENE is a TOML file or the name of a preset. A run is a folder (DIR).",
    no_args_is_help=True,
)
@click.version_option(__version__, "-V", "--version", message="ropewalk %(version)s")
def main() -> None:
    """Simulate ropes: check a scene, run it, look at the results.

    \b
    Begin with:  ropewalk demo
    then:        ropewalk new r4 -o scene.toml
                 ropewalk check scene.toml
                 ropewalk run scene.toml
    """


for _command in (
    demo, view, presets, ropes, line, new, check, settle, modes, run, sweep, resume, info, plot, movie, share,
    lab, compare, export, sheet, report, schema,
):  # fmt: skip
    main.add_command(_command)
main.params.append(debug_option())
