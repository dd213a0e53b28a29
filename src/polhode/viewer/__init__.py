"""Pages of motions: samples, pictures for any body, and the page itself."""
