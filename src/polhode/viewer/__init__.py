"""What a page is made of: samples, pictures that fit any body, and the page itself."""
