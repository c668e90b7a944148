import click


@click.command()
def info() -> None:
    """TODO."""
    raise NotImplementedError
