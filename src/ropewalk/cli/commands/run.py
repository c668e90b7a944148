import click


@click.command()
def run() -> None:
    """TODO."""
    raise NotImplementedError
