import click


@click.command()
def plot() -> None:
    """TODO."""
    raise NotImplementedError
