"""A picture made ready to be traced, or refused as no body plan."""
