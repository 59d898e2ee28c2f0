"""From a hull and her weights to the girder: structure, weights, distributions along the ship."""
