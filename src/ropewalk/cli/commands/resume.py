import click


@click.command()
def resume() -> None:
    """TODO."""
    raise NotImplementedError
