import click


@click.command()
def compare() -> None:
    """TODO."""
    raise NotImplementedError
