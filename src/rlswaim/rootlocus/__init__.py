"""A general engine for root loci, which knows no rocket."""
