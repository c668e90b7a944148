"""Many runs of one scene: tables, ensembles, uncertainty, fits; on one core or a cluster.

A sweep is a table of values (`parameters`, `designs`) and a list of what to keep of every run (`keep`).
Its runs are made in batches (`batch`), here or by workers (`engines`); a batch is one chunk of the store
(`store`), which is marked as done when its data are there. `answer` opens what is stored.
"""
