"""How numbers and names are said to people; used on every floor."""
