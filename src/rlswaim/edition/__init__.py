"""The critical edition: each printed number beside the computed one, with its verdict and its cause."""
