"""Pictures of the presets for the menu, and the times in their runs that tell them apart."""
