"""Live: a running simulation that is changed while it runs, and its view in the browser."""
