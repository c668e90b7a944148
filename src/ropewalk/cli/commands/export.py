import click


@click.command()
def export() -> None:
    """TODO."""
    raise NotImplementedError
