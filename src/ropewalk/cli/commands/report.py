import click


@click.command()
def report() -> None:
    """TODO."""
    raise NotImplementedError
