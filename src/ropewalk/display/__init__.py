"""How results and progress look in notebooks and on terminals; used on every floor."""
