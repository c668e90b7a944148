import click


@click.command()
def movie() -> None:
    """TODO."""
    raise NotImplementedError
