"""The review page: a person sees what was read from a picture, confirms it and mends it, on a local page."""
